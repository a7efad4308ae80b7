import { useId, useState } from 'react';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { saveAs } from '../state/files/files.ts';
import { freeFolder, suggestFolder } from '../state/files/suggest-folder.ts';
import { FormDialog } from '../ui/form-dialog.tsx';
import { DialogError } from './dialog-error.tsx';
import { FolderField } from './folder-field.tsx';
import { useTakenFolders } from './use-taken-folders.ts';

/** Asks for the folder of a copy, on hosts without a native folder dialog. */
export function SaveAsDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const id = useId();
  const title = useDocument((state) => state.project.title);
  const taken = useTakenFolders();
  /** The folder that the user typed; null while it is the suggested one. */
  const [typedPath, setTypedPath] = useState<string | null>(null);
  const path = typedPath ?? freeFolder(suggestFolder(editor, title, '-copy'), taken);
  const [busy, setBusy] = useState(false);
  const go = async () => {
    setBusy(true);
    await saveAs(editor, path.trim());
    setBusy(false);
  };
  return (
    <FormDialog title="Save a copy" action="Save" ready={!busy && path.trim() !== ''} onGo={() => void go()} onClose={onClose}>
      <FolderField id={id} label="Folder" path={path} onChange={setTypedPath} />
      <p className="dialog-note">The folder must be empty or new. The project’s assets are copied with it.</p>
      <DialogError />
    </FormDialog>
  );
}
