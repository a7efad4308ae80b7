import { useEffect, useId, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { type FolderLook, importPhotographs, lookIntoFolder } from '../state/acquisition/import-photographs.ts';
import { canvasCenter } from '../state/commands/command-actions.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import type { PhotographImport, PhotographStep } from '../state/editor/ui.ts';
import { cancelExport } from '../state/files/export-page.ts';
import { Button } from '../ui/button.tsx';
import { Dialog } from '../ui/dialog.tsx';
import { DialogForm } from '../ui/dialog-form.tsx';
import { ChoiceField, TextField } from '../ui/form-fields.tsx';
import type { SelectOption } from '../ui/select-field.tsx';
import { ErrorText } from './dialog-error.tsx';
import { ExportProgress } from './export-dialog.tsx';
import { FolderField } from './folder-field.tsx';
import './photographs-dialog.css';

const STEPS: readonly { readonly step: PhotographStep; readonly label: string }[] = [
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
/** Pause in typing after which the folder is looked into. */
const PAUSE_MS = 300;

/** Imports a folder of photographs: asks for it, and shows what COLMAP does. Closed meanwhile, the import goes on. */
export function PhotographsDialog({ folder: given, onClose }: { readonly folder: string; readonly onClose: () => void }) {
  const editor = useEditor();
  const id = useId();
  const handle = useDocument((state) => state.open?.handle ?? '');
  const exporting = useStore(editor.ui, (state) => state.exporting);
  const last = useStore(editor.ui, ({ photographs }) => (photographs?.handle === handle ? photographs : null));
  const [folder, setFolder] = useState(given);
  const [name, setName] = useState<string | null>(null);
  const [lenses, setLenses] = useState<'one' | 'many'>('one');
  const colmap = useStore(editor.preferences, (state) => state.colmap);
  const look = useLook(folder.trim(), colmap.trim());
  const shownName = name ?? nameOfFolder(folder);
  const isNamed = /[A-Za-z0-9]/.test(shownName);
  const found = look !== null && 'photographs' in look ? look : null;
  const canRun = found !== null && (found.hasCameras || found.colmap !== null);
  const running = exporting !== null;
  const ready = !running && canRun && isNamed;
  const go = () => {
    if (!ready) return;
    const request = { folder: folder.trim(), name: shownName, colmap: colmap.trim(), oneCamera: lenses === 'one' };
    void importPhotographs(editor, request, canvasCenter(editor));
  };
  return (
    <Dialog
      title="Import photographs"
      wide
      onClose={onClose}
      actions={
        <>
          <ExportProgress />
          <Button look="quiet" onPress={onClose}>
            {running ? 'Hide' : 'Close'}
          </Button>
          {running ? (
            <Button disabled={exporting.cancelled} onPress={() => void cancelExport(editor)}>
              Cancel
            </Button>
          ) : (
            <Button look="primary" disabled={!ready} onPress={go}>
              {last?.error ? 'Continue' : 'Import'}
            </Button>
          )}
        </>
      }
    >
      <DialogForm action="Import" onGo={go}>
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
        {!found?.hasCameras && (
          <TextField
            label="COLMAP (empty: the one in PATH)"
            text={colmap}
            error={found?.diagnostic ? `${found.diagnostic.message} ${found.diagnostic.fix ?? ''}` : undefined}
            plain
            onChange={(text) => editor.preferences.setState({ colmap: text })}
          />
        )}
        <p className="dialog-note" role="status">
          {lookWords(look)}
        </p>
      </DialogForm>
      {last !== null && <Progress of={last} />}
    </Dialog>
  );
}

/** What is in the folder, as far as it was typed. */
function useLook(folder: string, colmap: string): FolderLook | null {
  const editor = useEditor();
  const [look, setLook] = useState<FolderLook | null>(null);
  useEffect(() => {
    setLook(null);
    if (folder === '') return;
    let isCurrent = true;
    const stop = editor.clock.after(PAUSE_MS, () => {
      void lookIntoFolder(editor, folder, colmap).then((found) => {
        if (isCurrent) setLook(found);
      });
    });
    return () => {
      isCurrent = false;
      stop();
    };
  }, [editor, folder, colmap]);
  return look;
}

function lookWords(look: FolderLook | null): string {
  if (look === null)
    return 'A folder of photographs of a room or an object, from many places. Cameras that are missing are found by COLMAP.';
  if (!('photographs' in look)) return `${look.message} ${look.fix ?? ''}`;
  const count = look.photographs === 1 ? '1 photograph' : `${look.photographs} photographs`;
  if (look.hasCameras) return `${count}, with cameras.`;
  return look.colmap === null ? `${count} without cameras.` : `${count} without cameras. COLMAP ${look.colmap} finds them.`;
}

/** Name of the last folder of a path. */
function nameOfFolder(path: string): string {
  const names = path.split(/[\\/]/).filter((part) => part !== '');
  return (names.at(-1) ?? '').slice(0, 80);
}

function Progress({ of: { step, lines, error } }: { readonly of: PhotographImport }) {
  const log = useRef<HTMLTextAreaElement>(null);
  const at = STEPS.findIndex((each) => each.step === step);
  useEffect(() => {
    if (lines.length > 0) log.current?.scrollTo({ top: log.current.scrollHeight });
  }, [lines]);
  return (
    <section className="photographs-progress" aria-label="Progress">
      <ol>
        {STEPS.map(({ step: each, label }, i) => (
          <li key={each} data-state={i < at ? 'done' : i === at ? 'current' : 'waiting'} aria-current={i === at ? 'step' : undefined}>
            {label}
          </li>
        ))}
      </ol>
      <textarea ref={log} className="field scroll" aria-label="Output of COLMAP" readOnly value={lines.join('\n')} />
      {error !== null && (
        <div role="alert">
          <ErrorText text={error.message} detail={error.fix} />
        </div>
      )}
    </section>
  );
}
