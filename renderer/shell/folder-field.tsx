import type { HostInput } from '../../app/contract/contract.ts';
import { askForFolder } from '../state/files.ts';
import { Button } from '../ui/button.tsx';
import { useDocument, useEditor } from './editor-context.ts';
import './folder-field.css';

interface FolderFieldProps {
  readonly id: string;
  readonly label: string;
  readonly path: string;
  /** A path of the kind that is asked for. */
  readonly example?: string;
  /** What the shell's own dialog asks it for, where it has one; absent: it is typed alone. */
  readonly purpose?: HostInput<'folder.pick'>['purpose'];
  readonly onChange: (path: string) => void;
}

/** A folder by its path: what a dialog begins with. */
export function FolderField({ id, label, path, example = '/home/me/projects/my-effect', purpose, onChange }: FolderFieldProps) {
  const editor = useEditor();
  const canPick = useDocument((state) => state.canPickFolders);
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
          onChange={(event) => onChange(event.target.value)}
        />
        {purpose !== undefined && canPick && (
          <Button
            icon="folder"
            onPress={async () => {
              const picked = await askForFolder(editor, purpose);
              if (picked !== null) onChange(picked);
            }}
          >
            Choose…
          </Button>
        )}
      </div>
    </>
  );
}
