import { type FormEvent, useId, useState } from 'react';
import { useStore } from 'zustand';
import { createProject } from '../state/files.ts';
import { Button } from '../ui/button.tsx';
import { Dialog } from '../ui/dialog.tsx';
import { useEditor } from './editor-context.ts';
import './folder-dialog.css';
import './new-dialog.css';

/** What to begin with, and the folder it goes to. */
export function NewDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const id = useId();
  const templates = useStore(editor.document, (state) => state.templates);
  const canPick = useStore(editor.document, (state) => state.canPickFolders);
  const [template, setTemplate] = useState(templates[0]?.name ?? '');
  const [path, setPath] = useState('');
  const [busy, setBusy] = useState(false);
  const ready = !busy && path.trim() !== '' && template !== '';
  const go = async () => {
    if (!ready) return;
    setBusy(true);
    if (!(await createProject(editor, path.trim(), template))) setBusy(false);
  };
  return (
    <Dialog
      title="New project"
      onClose={onClose}
      actions={
        <>
          <Button look="quiet" onPress={onClose}>
            Cancel
          </Button>
          <Button look="primary" disabled={!ready} onPress={() => void go()}>
            Create
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
        <fieldset className="new-templates">
          <legend>Begin with</legend>
          {templates.map(({ name, title, description }) => (
            <label key={name} className="new-template">
              <input type="radio" name={`${id}-template`} checked={name === template} onChange={() => setTemplate(name)} />
              <span>
                <strong>{title}</strong>
                <span className="new-description">{description}</span>
              </span>
            </label>
          ))}
        </fieldset>
        <label htmlFor={id}>Folder</label>
        <div className="new-folder">
          <input
            id={id}
            className="field"
            data-autofocus=""
            spellCheck={false}
            placeholder="/home/me/projects/my-effect"
            value={path}
            onChange={(event) => setPath(event.target.value)}
          />
          {canPick && (
            <Button
              icon="folder"
              onPress={async () => {
                const picked = await editor.host.call('folder.pick', { purpose: 'new' });
                if (picked.path !== null) setPath(picked.path);
              }}
            >
              Choose…
            </Button>
          )}
        </div>
        <p className="folder-note">The folder must be empty or new; its name becomes the project’s title.</p>
      </form>
    </Dialog>
  );
}
