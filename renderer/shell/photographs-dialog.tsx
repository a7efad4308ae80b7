import { useId, useMemo, useState } from 'react';
import { useStore } from 'zustand';
import { type JudgedDepth, judgeDepth } from '../../export/captures/depth/judge-depth.ts';
import { AXES } from '../../export/captures/upright.ts';
import { PHONE_GPU_BYTES } from '../../nodes/kit/phone-memory.ts';
import { type FolderLook, importPhotographs, lookIntoFolder } from '../state/acquisition/import-photographs.ts';
import { estimatePacked, type FolderSurvey, type PackedEstimate, surveyPhotographs } from '../state/acquisition/survey-photographs.ts';
import { canvasCenter } from '../state/commands/command-actions.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import type { ToolStep } from '../state/editor/ui.ts';
import { byteText } from '../state/files/byte-text.ts';
import { ChoiceField, TextField } from '../ui/form-fields.tsx';
import type { SelectOption } from '../ui/select-field.tsx';
import { DepthSection } from './depth-section.tsx';
import { FolderField } from './folder-field.tsx';
import { FORM, type PhotographsForm, readForm } from './photographs-form.ts';
import './photographs-dialog.css';
import { ProgramField, problemText, ToolDialog, useAnswer } from './tool-dialog.tsx';

const STEPS: readonly { readonly step: ToolStep; readonly label: string }[] = [
  { step: 'features', label: 'Features' },
  { step: 'matches', label: 'Matches' },
  { step: 'cameras', label: 'Cameras' },
  { step: 'mesh', label: 'Mesh' },
  { step: 'pack', label: 'Packing' },
];
const LENSES: readonly SelectOption<'one' | 'many'>[] = [
  { value: 'one', label: 'One camera, one focal length' },
  { value: 'many', label: 'Several, or with zoom' },
];

/** Imports a folder of photographs, whose cameras COLMAP finds. */
export function PhotographsDialog({ folder: given, onClose }: { readonly folder: string; readonly onClose: () => void }) {
  const editor = useEditor();
  const id = useId();
  const [folder, setFolder] = useState(given);
  const [name, setName] = useState<string | null>(null);
  const [lenses, setLenses] = useState<'one' | 'many'>('one');
  const colmap = useStore(editor.preferences, (state) => state.colmap);
  const asked = { folder: folder.trim(), colmap: colmap.trim() };
  const look = useAnswer(asked.folder === '' ? null : JSON.stringify(asked), () => lookIntoFolder(editor, asked.folder, asked.colmap));
  const shownName = name ?? nameOfFolder(folder);
  const isNamed = /[A-Za-z0-9]/.test(shownName);
  const found = look !== null && 'photographs' in look ? look : null;
  const surveyed = useAnswer(found === null ? null : asked.folder, () => surveyPhotographs(editor, asked.folder));
  const survey = surveyed !== null && 'photographs' in surveyed ? surveyed : null;
  const problem = [look, surveyed].find((answer) => answer !== null && 'code' in answer);
  const [form, setForm] = useState(FORM);
  const { maxSidePx, metersPerUnit } = readForm(form);
  const judged = useMemo(() => judgedDepth(survey, form), [survey, form]);
  const isDepthReady = survey?.depth == null || form.from !== 'auto' || (judged !== null && judged.problem === null);
  const isFormReady = survey !== null && maxSidePx !== null && metersPerUnit !== 'wrong' && isDepthReady;
  const canRun = found !== null && (found.hasCameras || found.colmap !== null) && isFormReady;
  const go = () => {
    if (maxSidePx === null || metersPerUnit === 'wrong') return;
    const isDetected = judged?.scale && form.from === 'auto';
    const request = {
      ...{ ...asked, name: shownName, oneCamera: lenses === 'one', maxSidePx, metersPerUnit, up: form.up === 'auto' ? null : form.up },
      depth: {
        from: form.from === 'auto' ? null : form.from,
        unit: isDetected ? judged.scale.unit : null,
        kind: isDetected ? judged.scale.kind : null,
      },
    };
    void importPhotographs(editor, request, canvasCenter(editor));
  };
  return (
    <ToolDialog
      kind="photographs"
      title="Import photographs"
      action="Import"
      again="Continue"
      program="COLMAP"
      steps={found?.hasCameras ? STEPS.slice(-1) : STEPS}
      ready={canRun && isNamed}
      onGo={go}
      onClose={onClose}
    >
      <FolderField
        id={`${id}-folder`}
        label="Folder"
        path={folder}
        example="/home/me/scans/kitchen"
        purpose="photographs"
        onChange={setFolder}
      />
      <div className="form-row">
        <TextField
          label="Name of the capture"
          text={shownName}
          error={isNamed || folder.trim() === '' ? undefined : 'Enter a name with letters.'}
          plain
          onChange={setName}
        />
        {!found?.hasCameras && <ChoiceField label="Taken with" value={lenses} options={LENSES} onChoose={setLenses} />}
      </div>
      {!found?.hasCameras && <ProgramField title="COLMAP" preference="colmap" problem={found?.diagnostic} />}
      <p className={problem ? 'form-error' : 'dialog-note'} role="status">
        {problem ? problemText(problem) : lookWords(found, survey)}
      </p>
      {survey !== null && found !== null && (
        <>
          <PackingSection survey={survey} form={form} maxSidePx={maxSidePx} onChange={(change) => setForm({ ...form, ...change })} />
          {survey.depth && (
            <DepthSection
              depth={survey.depth}
              hasMesh={survey.mesh !== null}
              form={form}
              judged={judged}
              onChange={(change) => setForm({ ...form, ...change })}
            />
          )}
        </>
      )}
    </ToolDialog>
  );
}

/** Null without depth files that are used, or while the unit is not a number. */
function judgedDepth(survey: FolderSurvey | null, form: PhotographsForm): JudgedDepth | null {
  const { answers, metersPerUnit } = readForm(form);
  if (!survey?.depth || !answers || form.from !== 'auto') return null;
  const unitM = metersPerUnit === 'wrong' ? 1 : (metersPerUnit ?? 1);
  return judgeDepth(survey.depth.samples, answers, unitM, !survey.depth.hasCameras);
}

interface PackingSectionProps {
  readonly survey: FolderSurvey;
  readonly form: PhotographsForm;
  readonly maxSidePx: number | null;
  readonly onChange: (change: Partial<PhotographsForm>) => void;
}

/** The size of the packed photographs with what they take, and the space of the cameras. */
function PackingSection({ survey, form, maxSidePx, onChange }: PackingSectionProps) {
  const estimate = useMemo(() => (maxSidePx === null ? null : estimatePacked(survey, maxSidePx)), [survey, maxSidePx]);
  return (
    <fieldset className="photographs-section">
      <legend>Size</legend>
      <div className="form-row">
        <TextField
          label="Longest side (px)"
          text={form.sidePx}
          error={maxSidePx === null ? 'Enter a whole number from 64 to 8192.' : undefined}
          onChange={(sidePx) => onChange({ sidePx })}
        />
        {survey.up !== null && (
          <>
            <ChoiceField
              label="Up"
              value={form.up}
              options={[
                { value: 'auto' as const, label: `As photographed (${survey.up})` },
                ...AXES.map((value) => ({ value, label: `${value} axis of the cameras` })),
              ]}
              onChoose={(up) => onChange({ up })}
            />
            <TextField
              label="Meters per unit (empty: 1)"
              text={form.metersPerUnit}
              error={readForm(form).metersPerUnit === 'wrong' ? 'Enter a number above 0.' : undefined}
              onChange={(metersPerUnit) => onChange({ metersPerUnit })}
            />
          </>
        )}
      </div>
      <p className="photographs-estimate">{estimate && estimateWords(estimate, survey.mesh === null)}</p>
    </fieldset>
  );
}

function estimateWords({ pageBytes, phone, sidePx }: PackedEstimate, hasNoMesh: boolean): string {
  const [width, height] = phone.photoPx;
  const reduced = Math.max(width, height) < sidePx ? `, where photographs are reduced to ${width} × ${height} px` : '';
  const mesh = hasNoMesh ? ', without the mesh' : '';
  return `About ${byteText(pageBytes)} in the page; ${byteText(phone.gpuBytes)} of ${byteText(PHONE_GPU_BYTES)} on the GPU of a phone${reduced}${mesh}.`;
}

function lookWords(look: Extract<FolderLook, { photographs: number }> | null, survey: FolderSurvey | null): string {
  if (look === null)
    return 'A folder of photographs of a room or an object, from many places. Cameras that are missing are found by COLMAP.';
  // A file of depth beside a 360° photograph is none.
  const photographs = look.hasCameras && survey ? survey.photographs.length : look.photographs;
  const count = photographs === 1 ? '1 photograph' : `${photographs} photographs`;
  if (look.hasCameras) return [`${count}, with cameras.`, ...(survey?.warnings ?? [])].join(' ');
  return look.colmap === null ? `${count} without cameras.` : `${count} without cameras. COLMAP ${look.colmap} finds them.`;
}

/** Name of the last folder of a path. */
function nameOfFolder(path: string): string {
  const names = path.split(/[\\/]/).filter((part) => part !== '');
  return (names.at(-1) ?? '').slice(0, 80);
}
