import { useId, useState } from 'react';
import { useStore } from 'zustand';
import { createProject } from '../state/files.ts';
import { FormDialog } from '../ui/form-dialog.tsx';
import { useEditor } from './editor-context.ts';
import { FolderField } from './folder-field.tsx';
import './new-dialog.css';

interface NewDialogProps {
  /** The template that is chosen already. */
  readonly chosen?: string;
  readonly onClose: () => void;
}

/** What to begin with, and the folder it goes to. */
export function NewDialog({ chosen, onClose }: NewDialogProps) {
  const editor = useEditor();
  const id = useId();
  const templates = useStore(editor.document, (state) => state.templates);
  const [template, setTemplate] = useState(chosen ?? templates[0]?.name ?? '');
  const [path, setPath] = useState('');
  const [busy, setBusy] = useState(false);
  const ready = !busy && path.trim() !== '' && template !== '';
  const go = async () => {
    setBusy(true);
    if (!(await createProject(editor, path.trim(), template))) setBusy(false);
  };
  return (
    <FormDialog title="New project" action="Create" ready={ready} onGo={() => void go()} onClose={onClose}>
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
      <FolderField id={id} label="Folder" path={path} purpose="new" onChange={setPath} />
      <p className="dialog-note">The folder must be empty or new; its name becomes the project’s title.</p>
    </FormDialog>
  );
}
