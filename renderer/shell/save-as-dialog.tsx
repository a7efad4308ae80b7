import { useId, useState } from 'react';
import { useEditor } from '../state/editor/editor-context.ts';
import { saveAs } from '../state/files/files.ts';
import { FormDialog } from '../ui/form-dialog.tsx';
import { FolderField } from './folder-field.tsx';
import { NameField } from './name-field.tsx';
import { useProjectFolder } from './use-project-folder.ts';

/** Asks for the name and the folder of a copy. */
export function SaveAsDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const id = useId();
  const [typedTitle, setTitle] = useState(() => `${editor.document.getState().project.title} copy`);
  const title = typedTitle.trim();
  const { path, onChange } = useProjectFolder(title);
  const [busy, setBusy] = useState(false);
  const go = async () => {
    setBusy(true);
    if (!(await saveAs(editor, path.trim(), title))) setBusy(false);
  };
  const ready = !busy && title !== '' && path.trim() !== '';
  return (
    <FormDialog title="Save a copy" action="Save" ready={ready} onGo={() => void go()} onClose={onClose}>
      <NameField name={typedTitle} onChange={setTitle} />
      <FolderField id={id} label="Folder" path={path} purpose="save-as" onChange={onChange} />
      <p className="dialog-note">The folder must be empty or new. The project’s assets are copied with it.</p>
    </FormDialog>
  );
}
