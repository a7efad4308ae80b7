import { type FormEvent, useId, useState } from 'react';
import { useStore } from 'zustand';
import { openPath } from '../state/files.ts';
import { Button } from '../ui/button.tsx';
import { Dialog } from '../ui/dialog.tsx';
import { Icon } from '../ui/icon.tsx';
import { useEditor } from './editor-context.ts';
import './open-dialog.css';

/** A project folder: one of the examples, one picked in the shell's own dialog, or a path. */
export function OpenDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const id = useId();
  const [path, setPath] = useState('');
  const [busy, setBusy] = useState(false);
  const examples = useStore(editor.document, (state) => state.examples);
  const canPick = useStore(editor.document, (state) => state.canPickFolders);
  const open = async (chosen: string) => {
    setBusy(true);
    if (!(await openPath(editor, chosen))) setBusy(false);
  };
  const submit = (event: FormEvent) => {
    event.preventDefault();
    if (path.trim() !== '') void open(path.trim());
  };
  return (
    <Dialog
      title="Open a project"
      onClose={onClose}
      actions={
        <>
          <Button look="quiet" onPress={onClose}>
            Cancel
          </Button>
          <Button icon="add" onPress={() => editor.ui.setState({ dialog: { kind: 'new' } })}>
            New project…
          </Button>
          {canPick && (
            <Button
              icon="folder"
              onPress={async () => {
                const picked = await editor.host.call('folder.pick', { purpose: 'open' });
                if (picked.path !== null) await open(picked.path);
              }}
            >
              Choose a folder…
            </Button>
          )}
          <Button look="primary" disabled={busy || path.trim() === ''} onPress={() => void open(path.trim())}>
            Open
          </Button>
        </>
      }
    >
      <form className="dialog-form" onSubmit={submit}>
        <label htmlFor={id}>Folder of the project</label>
        <input
          id={id}
          className="field"
          data-autofocus=""
          spellCheck={false}
          placeholder="/home/me/projects/my-effect"
          value={path}
          onChange={(event) => setPath(event.target.value)}
        />
      </form>
      {examples.length > 0 && (
        <>
          <h3 className="folder-heading">Examples</h3>
          <ul className="folder-list">
            {examples.map((example) => (
              <li key={example.path}>
                <button type="button" disabled={busy} onClick={() => void open(example.path)}>
                  <Icon name="folder" />
                  <span>{example.title}</span>
                </button>
              </li>
            ))}
          </ul>
        </>
      )}
    </Dialog>
  );
}
