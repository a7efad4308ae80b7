import type { HostInput } from '../../app/contract/contract.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { askForFolder } from '../state/files/files.ts';
import { Button } from '../ui/button.tsx';
import './folder-field.css';

interface FolderFieldProps {
  readonly id: string;
  readonly label: string;
  readonly path: string;
  /** Example path, shown as placeholder. */
  readonly example?: string;
  /** Purpose for the native folder dialog. Absent: the path can only be typed. */
  readonly purpose?: HostInput<'folder.pick'>['purpose'];
  readonly onChange: (path: string) => void;
}

/** Field for the path of a folder, with a button for the native folder dialog. */
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
