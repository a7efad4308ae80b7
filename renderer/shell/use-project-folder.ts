import { useState } from 'react';
import { useDocument } from '../state/editor/editor-context.ts';
import { splitPath } from '../state/files/folder-path.ts';
import { folderIn, freeFolder } from '../state/files/suggest-folder.ts';
import { useTakenFolders } from './use-taken-folders.ts';

interface ProjectFolder {
  readonly path: string;
  readonly onChange: (path: string) => void;
}

/**
 * The folder of a new project: a free one that is named after it, in the projects folder or in the one that the person went to. A name
 * that the person types stays.
 */
export function useProjectFolder(title: string): ProjectFolder {
  const projectsDir = useDocument((state) => state.projectsDir);
  const [place, setPlace] = useState<string | null>(null);
  const [typed, setTyped] = useState<string | null>(null);
  const folder = place ?? projectsDir;
  const taken = useTakenFolders(folder);
  const path = typed ?? freeFolder(folderIn(folder, title), taken);
  const onChange = (next: string) => {
    const [nextPlace, name] = splitPath(next);
    const follows = nextPlace !== '' && name !== '' && name === splitPath(path)[1];
    if (follows) setPlace(nextPlace);
    setTyped(follows ? null : next);
  };
  return { path, onChange };
}
