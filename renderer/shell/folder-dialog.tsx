import { type FormEvent, useId, useState } from 'react';
import { exportPage } from '../state/export-page.ts';
import { saveAs } from '../state/files.ts';
import { Button } from '../ui/button.tsx';
import { Dialog } from '../ui/dialog.tsx';
import { useEditor } from './editor-context.ts';
import './folder-dialog.css';

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
  },
  export: {
    title: 'Export the page',
    action: 'Export',
    note: 'A folder of static files for any web server. It must be new, empty, or an earlier export.',
    example: '/home/me/pages/my-effect',
  },
} as const;

/** Asks for a folder where the shell has no dialog of its own. */
export function FolderDialog({ purpose, onClose }: FolderDialogProps) {
  const editor = useEditor();
  const id = useId();
  const [path, setPath] = useState('');
  const [busy, setBusy] = useState(false);
  const words = WORDS[purpose];
  const go = async () => {
    if (path.trim() === '') return;
    setBusy(true);
    await (purpose === 'export' ? exportPage : saveAs)(editor, path.trim());
    setBusy(false);
  };
  return (
    <Dialog
      title={words.title}
      onClose={onClose}
      actions={
        <>
          <Button look="quiet" onPress={onClose}>
            Cancel
          </Button>
          <Button look="primary" disabled={busy || path.trim() === ''} onPress={() => void go()}>
            {words.action}
          </Button>
        </>
      }
    >
      <form
        className="folder-form"
        onSubmit={(event: FormEvent) => {
          event.preventDefault();
          void go();
        }}
      >
        <label htmlFor={id}>Folder</label>
        <input
          id={id}
          className="field"
          data-autofocus=""
          spellCheck={false}
          placeholder={words.example}
          value={path}
          onChange={(event) => setPath(event.target.value)}
        />
        <p className="folder-note">{words.note}</p>
      </form>
    </Dialog>
  );
}
