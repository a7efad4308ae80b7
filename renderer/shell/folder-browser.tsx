import { useEffect, useState } from 'react';
import type { HostOutput } from '../../app/contract/contract.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { Icon } from '../ui/icon.tsx';

interface FolderBrowserProps {
  /** The folder in which it begins, or a path in it. */
  readonly from: string;
  /** Called with each folder that the person goes to. */
  readonly onGo: (path: string) => void;
}

/** The folders of this machine, for hosts without a native folder dialog. A press on one goes into it. */
export function FolderBrowser({ from, onGo }: FolderBrowserProps) {
  const editor = useEditor();
  const [asked, setAsked] = useState(from);
  const [shown, setShown] = useState<HostOutput<'folder.list'> | null>(null);
  useEffect(() => {
    let wanted = true;
    const show = (next: HostOutput<'folder.list'> | null) => wanted && setShown(next);
    editor.host.call('folder.list', { path: asked }).then(show, () => show(null));
    return () => {
      wanted = false;
    };
  }, [editor, asked]);
  const go = (path: string) => {
    setAsked(path);
    onGo(path);
  };
  if (shown === null) return null;
  const { path, parent, folders } = shown;
  return (
    <section className="folder-browser" aria-label={`Folders in ${path}`}>
      <ul className="scroll">
        {parent !== null && (
          <li>
            <button type="button" onClick={() => go(parent)}>
              <Icon name="up" />
              Up to {parent}
            </button>
          </li>
        )}
        {folders.map((folder) => (
          <li key={folder.path}>
            <button type="button" onClick={() => go(folder.path)}>
              <Icon name="folder" />
              <span className="folder-name">{folder.name}</span>
              {folder.isProject && <span className="folder-kind">Project</span>}
            </button>
          </li>
        ))}
      </ul>
      {folders.length === 0 && <p className="dialog-note">There are no folders in {path}.</p>}
    </section>
  );
}
