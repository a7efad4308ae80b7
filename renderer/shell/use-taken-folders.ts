import { useEffect, useState } from 'react';
import { useEditor } from '../state/editor/editor-context.ts';

/** Paths of the folders in the folder `path`; none until they are listed. */
export function useTakenFolders(path: string): ReadonlySet<string> {
  const editor = useEditor();
  const [taken, setTaken] = useState<ReadonlySet<string>>(new Set());
  useEffect(() => {
    let wanted = path !== '';
    const show = (paths: readonly string[]) => wanted && setTaken(new Set(paths));
    if (wanted)
      editor.host.call('folder.list', { path }).then(
        ({ folders }) => show(folders.map((folder) => folder.path)),
        () => show([]),
      );
    return () => {
      wanted = false;
    };
  }, [editor, path]);
  return taken;
}
