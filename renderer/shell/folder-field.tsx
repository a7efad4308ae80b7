import type { ReactNode } from 'react';
import './folder-field.css';

interface FolderFieldProps {
  readonly id: string;
  readonly label: string;
  readonly path: string;
  /** A path of the kind that is asked for. */
  readonly example?: string;
  readonly onChange: (path: string) => void;
  /** What stands beside it, such as a button that picks one. */
  readonly children?: ReactNode;
}

/** A folder by its path: what a dialog begins with. */
export function FolderField({ id, label, path, example = '/home/me/projects/my-effect', onChange, children }: FolderFieldProps) {
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
        {children}
      </div>
    </>
  );
}
