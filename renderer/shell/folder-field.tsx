import { useState } from 'react';
import { useStore } from 'zustand';
import type { HostInput } from '../../app/contract/contract.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { clearDialogErrors } from '../state/editor/ui.ts';
import { askForFolder } from '../state/files/files.ts';
import { joinPath, splitPath } from '../state/files/folder-path.ts';
import { Button } from '../ui/button.tsx';
import { DialogErrors } from './dialog-error.tsx';
import { FolderBrowser } from './folder-browser.tsx';
import './folder-field.css';

interface FolderFieldProps {
  readonly id: string;
  readonly label: string;
  readonly path: string;
  /** Example path, shown as placeholder. */
  readonly example?: string;
  /** Purpose for the native folder dialog. Absent: the path can only be typed. */
  readonly purpose?: HostInput<'folder.pick'>['purpose'];
  /** `itself`: an existing folder is chosen. Default: a new folder is made in the chosen one, with the last part of `path` as its name. */
  readonly chooses?: 'itself' | 'place';
  readonly onChange: (path: string) => void;
}

/**
 * Field for the path of a folder, with a button for the native folder dialog, or else for a list of folders below the field. The errors of
 * the dialog stand below it until the path changes.
 */
export function FolderField(props: FolderFieldProps) {
  const { id, label, path, example = '/home/me/projects/my-effect', purpose, chooses = 'place', onChange } = props;
  const editor = useEditor();
  const canPick = useDocument((state) => state.canPickFolders);
  const [isOpen, setOpen] = useState(false);
  const [place, name] = chooses === 'itself' ? [path, ''] : splitPath(path);
  const isRefused = useStore(editor.ui, (state) => state.dialogErrors.length > 0);
  const isMissing = chooses === 'place' && path.trim() === '';
  const change = (next: string) => {
    clearDialogErrors(editor.ui);
    onChange(next);
  };
  return (
    <>
      <label htmlFor={id}>{label}</label>
      <div className="folder-field">
        <input
          id={id}
          className="field"
          data-autofocus=""
          spellCheck={false}
          placeholder={example}
          value={path}
          aria-invalid={isRefused || isMissing}
          aria-describedby={`${id}-error`}
          onChange={(event) => change(event.target.value)}
        />
        {purpose !== undefined && canPick && (
          <Button
            icon="folder"
            onPress={async () => {
              const picked = await askForFolder(editor, purpose);
              if (picked !== null) change(picked);
            }}
          >
            Choose…
          </Button>
        )}
        {!canPick && (
          <Button icon="folder" expanded={isOpen} onPress={() => setOpen(!isOpen)}>
            Browse
          </Button>
        )}
      </div>
      {isMissing && (
        <span id={`${id}-error`} className="form-error">
          Enter a folder.
        </span>
      )}
      {!isMissing && <DialogErrors id={`${id}-error`} />}
      {isOpen && <FolderBrowser from={place} onGo={(folder) => change(chooses === 'itself' ? folder : joinPath(folder, name))} />}
    </>
  );
}
