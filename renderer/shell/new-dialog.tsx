import { useId, useState } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../state/editor/editor-context.ts';
import { createProject } from '../state/files/files.ts';
import { FormDialog } from '../ui/form-dialog.tsx';
import { FolderField } from './folder-field.tsx';
import { NameField } from './name-field.tsx';
import { useProjectFolder } from './use-project-folder.ts';
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
  const [typedTitle, setTitle] = useState('My effect');
  const title = typedTitle.trim();
  const { path, onChange } = useProjectFolder(title);
  const [busy, setBusy] = useState(false);
  const ready = !busy && title !== '' && path.trim() !== '' && template !== '';
  const go = async () => {
    setBusy(true);
    if (!(await createProject(editor, { path: path.trim(), template, title }))) setBusy(false);
  };
  return (
    <FormDialog title="New project" action="Create" ready={ready} onGo={() => void go()} onClose={onClose}>
      <fieldset className="new-templates">
        <legend>Template</legend>
        {templates.map(({ name: key, title: label, description }) => (
          <label key={key} className="new-template">
            <input type="radio" name={`${id}-template`} checked={key === template} onChange={() => setTemplate(key)} />
            <span>
              <strong>{label}</strong>
              <span className="new-description">{description}</span>
            </span>
          </label>
        ))}
      </fieldset>
      <NameField name={typedTitle} onChange={setTitle} />
      <FolderField id={id} label="Folder" path={path} purpose="new" onChange={onChange} />
      <p className="dialog-note">The folder must be empty or new.</p>
    </FormDialog>
  );
}
