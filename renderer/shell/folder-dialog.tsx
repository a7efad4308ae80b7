import { useId, useState } from 'react';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { exportPage } from '../state/files/export-page.ts';
import { saveAs } from '../state/files/files.ts';
import { suggestFolder } from '../state/files/suggest-folder.ts';
import { FormDialog } from '../ui/form-dialog.tsx';
import { FolderField } from './folder-field.tsx';

interface FolderDialogProps {
  readonly purpose: 'save-as' | 'export';
  readonly onClose: () => void;
}

const WORDS = {
  'save-as': {
    title: 'Save a copy',
    action: 'Save',
    note: 'The folder must be empty or new. The project’s assets are copied with it.',
    example: '/home/me/projects/my-effect',
    ending: '-copy',
  },
  export: {
    title: 'Export the page',
    action: 'Export',
    note: 'A folder of static files for any web server. It must be new, empty, or an earlier export.',
    example: '/home/me/pages/my-effect',
    ending: '-page',
  },
} as const;

/** Asks for a folder on hosts without a native folder dialog. */
export function FolderDialog({ purpose, onClose }: FolderDialogProps) {
  const editor = useEditor();
  const words = WORDS[purpose];
  const id = useId();
  const title = useDocument((state) => state.project.title);
  const [path, setPath] = useState(() => suggestFolder(editor, title, words.ending));
  const [busy, setBusy] = useState(false);
  const go = async () => {
    setBusy(true);
    await (purpose === 'export' ? exportPage : saveAs)(editor, path.trim());
    setBusy(false);
  };
  return (
    <FormDialog title={words.title} action={words.action} ready={!busy && path.trim() !== ''} onGo={() => void go()} onClose={onClose}>
      <FolderField id={id} label="Folder" path={path} example={words.example} onChange={setPath} />
      <p className="dialog-note">{words.note}</p>
    </FormDialog>
  );
}
