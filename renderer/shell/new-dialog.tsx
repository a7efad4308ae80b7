import { useId, useState } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../state/editor/editor-context.ts';
import { createProject } from '../state/files/files.ts';
import { FormDialog } from '../ui/form-dialog.tsx';
import { FolderField } from './folder-field.tsx';
import './new-dialog.css';

interface NewDialogProps {
  /** Preselected template. */
  readonly chosen?: string;
  readonly onClose: () => void;
}

/** Creates a project from a template in a folder. */
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
        <legend>Template</legend>
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
