import { useEffect, useId, useMemo, useState } from 'react';
import { DAMAGED_CAPTURE_FIX } from '../../export/captures/file-faults.ts';
import {
  type CaptureReport,
  errorWords,
  photosOf,
  type ReportedPhoto,
  reportFacts,
  scaleAdvice,
  worstFirst,
} from '../../export/captures/report/capture-report.ts';
import { MARKS_LEGEND, photoMarks } from '../../export/captures/report/photo-marks.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { readCaptureReport, readPhotograph } from '../state/acquisition/capture-report.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { nameOf } from '../state/files/edit-assets.ts';
import { Button } from '../ui/button.tsx';
import { Dialog } from '../ui/dialog.tsx';
import './capture-report-dialog.css';
import { CamerasView } from './cameras-view.tsx';
import { ErrorText } from './dialog-error.tsx';

interface CaptureReportDialogProps {
  /** Path of `capture.json` in the project. */
  readonly path: string;
  /** What has just happened. */
  readonly note: string | undefined;
  readonly onClose: () => void;
}

/** What the import of a capture understood: its cameras over its mesh, and how well the points of each photograph fit. */
export function CaptureReportDialog({ path, note, onClose }: CaptureReportDialogProps) {
  const editor = useEditor();
  const [answer, setAnswer] = useState<CaptureReport | Diagnostic | null>(null);
  useEffect(() => {
    let isCurrent = true;
    void readCaptureReport(editor, path).then((found) => {
      if (isCurrent) setAnswer(found);
    });
    return () => {
      isCurrent = false;
    };
  }, [editor, path]);
  return (
    <Dialog
      title={`${nameOf(path)}: what was understood`}
      size="large"
      onClose={onClose}
      actions={
        <Button look="primary" autoFocus onPress={onClose}>
          Close
        </Button>
      }
    >
      {note !== undefined && (
        <p className="capture-note" role="status">
          {note}
        </p>
      )}
      {answer === null && <p className="dialog-note">Reading the capture…</p>}
      {answer !== null && 'views' in answer && <Report report={answer} folder={path.slice(0, path.lastIndexOf('/') + 1)} />}
      {answer !== null && 'code' in answer && (
        <div role="alert">
          <ErrorText text={answer.message} detail={answer.fix} />
        </div>
      )}
    </Dialog>
  );
}

const NO_RECORD =
  'Scrim imported this capture before it kept what it understands. Import the photographs again to see how well their points fit.';

function Report({ report, folder }: { readonly report: CaptureReport; readonly folder: string }) {
  const photos = useMemo(() => photosOf(report), [report]);
  const worst = useMemo(() => worstFirst(photos), [photos]);
  const names = useMemo(() => photos.map(({ name }) => name), [photos]);
  const [index, setIndex] = useState(worst[0]?.index ?? 0);
  const chosen = photos[index];
  const warnings = report.record?.warnings ?? [NO_RECORD];
  const advice = scaleAdvice(report.record);
  const isGuess = report.record?.scale?.from === 'guessed';
  return (
    <>
      <dl className="capture-facts">
        {reportFacts(report).map(({ label, text }) => (
          <div key={label}>
            <dt>{label}</dt>
            <dd>{text}</dd>
          </div>
        ))}
      </dl>
      {advice !== null && <p className={isGuess ? 'capture-warning' : 'capture-advice'}>{advice}</p>}
      {warnings.map((warning) => (
        <p key={warning} className="capture-warning">
          {warning}
        </p>
      ))}
      <div className="capture-columns">
        <CamerasView report={report} names={names} chosen={index} onChoose={setIndex} />
        <section aria-label="Photographs">
          {chosen && <Photo key={chosen.index} photo={chosen} path={folder + chosen.view.file} />}
          <PhotoList photos={worst} chosen={index} onChoose={setIndex} />
        </section>
      </div>
    </>
  );
}

/** A photograph with the places of its points. */
function Photo({ photo: { view, about, name }, path }: { readonly photo: ReportedPhoto; readonly path: string }) {
  const { widthPx, heightPx } = view;
  const { url, error, onDamaged } = usePhotograph(path);
  const marks = useMemo(() => photoMarks(about?.places ?? []), [about]);
  return (
    <figure className="capture-photo">
      <svg
        viewBox={`0 0 ${widthPx} ${heightPx}`}
        role="img"
        aria-label={`${name}: ${errorWords(about)}`}
        aria-busy={url === null && error === null}
      >
        {url !== null && <image href={url} width={widthPx} height={heightPx} onError={onDamaged} />}
        <path className="capture-seen" d={marks.seen} />
        <path className="capture-off" d={marks.off} />
      </svg>
      <figcaption>{marks.seen === '' ? `${name}: ${errorWords(about)}` : MARKS_LEGEND}</figcaption>
      <div role="alert">{error !== null && <ErrorText text={error.message} detail={error.fix} />}</div>
    </figure>
  );
}

function usePhotograph(path: string) {
  const editor = useEditor();
  const [url, setUrl] = useState<string | null>(null);
  const [error, setError] = useState<Pick<Diagnostic, 'message' | 'fix'> | null>(null);
  useEffect(() => {
    let made: string | null = null;
    let isCurrent = true;
    void readPhotograph(editor, path).then((read) => {
      if (!isCurrent || read === null) return;
      if (!(read instanceof Blob)) return setError(read);
      made = URL.createObjectURL(read);
      setUrl(made);
    });
    return () => {
      isCurrent = false;
      if (made !== null) URL.revokeObjectURL(made);
    };
  }, [editor, path]);
  const onDamaged = () => setError({ message: `${path} cannot be shown: it is damaged.`, fix: DAMAGED_CAPTURE_FIX });
  return { url, error, onDamaged };
}

interface PhotoListProps {
  readonly photos: readonly ReportedPhoto[];
  /** Index of a photograph in the capture. */
  readonly chosen: number;
  readonly onChoose: (index: number) => void;
}

function PhotoList({ photos, chosen, onChoose }: PhotoListProps) {
  const id = useId();
  return (
    <fieldset className="capture-photos scroll">
      <legend className="visually-hidden">Photographs, the worst first</legend>
      {photos.map(({ index, name, about }) => (
        <label key={index}>
          <input type="radio" name={id} checked={index === chosen} onChange={() => onChoose(index)} />
          <span className="capture-photo-name">{name}</span>
          <span className="capture-photo-error">{about?.errorPx == null ? '–' : `${about.errorPx.toFixed(2)} px`}</span>
        </label>
      ))}
    </fieldset>
  );
}
