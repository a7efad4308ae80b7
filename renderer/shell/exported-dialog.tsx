import { useState } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../state/editor/editor-context.ts';
import type { ExportedPage, ExportSettings } from '../state/editor/ui.ts';
import { copyExportAddress, exportPage, lastExport, visitExport } from '../state/files/export-page.ts';
import { Button } from '../ui/button.tsx';
import { Dialog } from '../ui/dialog.tsx';
import { Icon } from '../ui/icon.tsx';
import { ExportProgress } from './export-dialog.tsx';
import { ExportErrors } from './export-errors.tsx';
import { ExportDevices, ExportMemory, ExportSizes, NoSizes } from './export-report.tsx';
import { PublishedAddress } from './published-address.tsx';
import './export-dialog.css';

/** The last exported page: its poster, where to see it, its size, and what each device shows of it. */
export function ExportedDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const exported = useStore(editor.ui, (state) => state.exported);
  const busy = useStore(editor.ui, (state) => state.exporting !== null);
  const settings = useStore(editor.ui, (state) => state.exportSettings);
  const [said, setSaid] = useState('');
  if (exported === null || lastExport(editor) === null) return null;
  const isOld = settings.singleFile !== exported.settings.singleFile || settings.offline !== exported.settings.offline;
  const copy = async () => setSaid((await copyExportAddress(editor)) ?? '');
  const visit = () => visitExport(editor, (url) => window.open(url, '_blank', 'noopener'));
  const again = (changed: Partial<ExportSettings>) => {
    setSaid('');
    void exportPage(editor, changed);
  };
  return (
    <Dialog
      title={exported.title}
      size="large"
      onClose={onClose}
      actions={
        <>
          {busy ? (
            <ExportProgress />
          ) : (
            <span className="export-state" role="status">
              {said}
            </span>
          )}
          <Button look="quiet" onPress={onClose}>
            Close
          </Button>
          <Button icon="link" disabled={busy} onPress={() => void copy()}>
            Copy address
          </Button>
          <Button look="primary" autoFocus icon="screen" disabled={busy} onPress={() => void visit()}>
            Open in browser
          </Button>
        </>
      }
    >
      <p className="exported-to" role="status">
        Exported to {exported.settings.out}
      </p>
      <ExportErrors onShow={onClose} />
      <div className="exported scroll" aria-busy={busy}>
        <div className="exported-column">
          <Poster exported={exported} />
          <ExportSwitches settings={settings} busy={busy} onChange={again} />
          <PublishedAddress exported={exported} busy={busy} onExport={() => again({})} />
        </div>
        <div className="exported-column">
          {isOld ? <NoSizes busy={busy} /> : <ExportSizes report={exported.report} />}
          {!isOld && <ExportMemory report={exported.report} />}
          <ExportDevices report={exported.report} />
        </div>
      </div>
    </Dialog>
  );
}

function Poster({ exported: { poster, title } }: { readonly exported: ExportedPage }) {
  if (poster !== null) return <img className="exported-poster" src={poster} alt={`Poster of ${title}`} width={1200} height={630} />;
  return (
    <div className="exported-poster exported-no-poster">
      <Icon name="image" size={24} />
      The preview showed nothing. The page has a neutral poster.
    </div>
  );
}

interface ExportSwitchesProps {
  readonly settings: ExportSettings;
  readonly busy: boolean;
  /** Exports the page again. */
  readonly onChange: (changed: Partial<ExportSettings>) => void;
}

function ExportSwitches({ settings: { singleFile, offline }, busy, onChange }: ExportSwitchesProps) {
  return (
    <section className="exported-section" aria-label="Form of the page">
      <Switch
        label="Single file"
        note="Opens from a disk or a mail. AR needs a web server."
        on={singleFile}
        disabled={busy}
        onChange={(on) => onChange({ singleFile: on })}
      />
      <Switch
        label="Works offline"
        note={singleFile ? 'A single file needs no network.' : 'After one visit, the page opens without a network.'}
        on={singleFile || offline}
        disabled={busy || singleFile}
        onChange={(on) => onChange({ offline: on })}
      />
    </section>
  );
}

interface SwitchProps {
  readonly label: string;
  readonly note: string;
  readonly on: boolean;
  readonly disabled: boolean;
  readonly onChange: (on: boolean) => void;
}

function Switch({ label, note, on, disabled, onChange }: SwitchProps) {
  return (
    <label className="exported-switch">
      <span>
        {label}
        <span className="exported-note">{note}</span>
      </span>
      <input
        type="checkbox"
        role="switch"
        className="switch"
        aria-label={label}
        aria-checked={on}
        checked={on}
        disabled={disabled}
        onChange={(event) => onChange(event.target.checked)}
      />
    </label>
  );
}
