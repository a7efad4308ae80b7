import { useEffect, useState } from 'react';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';

/** Paths of the folders in the projects folder; none until they are listed. */
export function useTakenFolders(): ReadonlySet<string> {
  const editor = useEditor();
  const path = useDocument(({ projectsDir }) => projectsDir);
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
