import { useId, useState } from 'react';
import { useStore } from 'zustand';
import { type FolderLook, importPhotographs, lookIntoFolder } from '../state/acquisition/import-photographs.ts';
import { canvasCenter } from '../state/commands/command-actions.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import type { ToolStep } from '../state/editor/ui.ts';
import { ChoiceField, TextField } from '../ui/form-fields.tsx';
import type { SelectOption } from '../ui/select-field.tsx';
import { FolderField } from './folder-field.tsx';
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
  const canRun = found !== null && (found.hasCameras || found.colmap !== null);
  const go = () => {
    const request = { ...asked, name: shownName, oneCamera: lenses === 'one' };
    void importPhotographs(editor, request, canvasCenter(editor));
  };
  return (
    <ToolDialog
      kind="photographs"
      title="Import photographs"
      action="Import"
      again="Continue"
      program="COLMAP"
      steps={STEPS}
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
      <p className="dialog-note" role="status">
        {lookWords(look)}
      </p>
    </ToolDialog>
  );
}

function lookWords(look: FolderLook | null): string {
  if (look === null)
    return 'A folder of photographs of a room or an object, from many places. Cameras that are missing are found by COLMAP.';
  if (!('photographs' in look)) return problemText(look);
  const count = look.photographs === 1 ? '1 photograph' : `${look.photographs} photographs`;
  if (look.hasCameras) return `${count}, with cameras.`;
  return look.colmap === null ? `${count} without cameras.` : `${count} without cameras. COLMAP ${look.colmap} finds them.`;
}

/** Name of the last folder of a path. */
function nameOfFolder(path: string): string {
  const names = path.split(/[\\/]/).filter((part) => part !== '');
  return (names.at(-1) ?? '').slice(0, 80);
}
