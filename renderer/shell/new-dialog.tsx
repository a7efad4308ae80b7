import { useId, useState } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../state/editor/editor-context.ts';
import { createProject } from '../state/files/files.ts';
import { freeFolder, suggestFolder } from '../state/files/suggest-folder.ts';
import { FormDialog } from '../ui/form-dialog.tsx';
import { DialogError } from './dialog-error.tsx';
import { FolderField } from './folder-field.tsx';
import { useTakenFolders } from './use-taken-folders.ts';
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
  const [name, setName] = useState('My effect');
  /** The folder that the user typed; null while the folder follows the name. */
  const [typedPath, setTypedPath] = useState<string | null>(null);
  const taken = useTakenFolders();
  const path = typedPath ?? freeFolder(suggestFolder(editor, name), taken);
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
        {templates.map(({ name: key, title, description }) => (
          <label key={key} className="new-template">
            <input type="radio" name={`${id}-template`} checked={key === template} onChange={() => setTemplate(key)} />
            <span>
              <strong>{title}</strong>
              <span className="new-description">{description}</span>
            </span>
          </label>
        ))}
      </fieldset>
      <label htmlFor={`${id}-name`}>Name</label>
      <input
        id={`${id}-name`}
        className="field"
        data-autofocus=""
        spellCheck={false}
        value={name}
        onChange={(event) => setName(event.target.value)}
      />
      <FolderField id={id} label="Folder" path={path} purpose="new" onChange={setTypedPath} />
      <p className="dialog-note">The folder must be empty or new; its name becomes the project’s title.</p>
      <DialogError />
    </FormDialog>
  );
}
