import type { Editor } from '../editor/editor.ts';
import { joinPath } from './folder-path.ts';

/**
 * A folder in the projects folder, named after a title: `My effect` gives `/home/me/Scrim/my-effect`. It may already exist.
 *
 * @param ending Added to the name, such as `-page`.
 */
export function suggestFolder({ document }: Pick<Editor, 'document'>, title: string, ending = ''): string {
  return folderIn(document.getState().projectsDir, title, ending);
}

/** A folder in the folder `place` that is named after a title; empty if there is no place. */
export function folderIn(place: string, title: string, ending = ''): string {
  return place === '' ? '' : joinPath(place, `${fileName(title)}${ending}`);
}

/** The folder, or the first of `PATH-2`, `PATH-3` and so on that is not taken. */
export function freeFolder(path: string, taken: ReadonlySet<string>): string {
  let free = path;
  for (let number = 2; taken.has(free); number++) free = `${path}-${number}`;
  return free;
}

/** Most characters of a proposed name. File systems allow 255 bytes, and characters of some scripts take four. */
const MOST_CHARACTERS = 48;

/** The name of a folder for a title. Letters and digits of all scripts stay; everything else becomes one hyphen. Long names are cut. */
export function fileName(title: string): string {
  const words = title
    .toLowerCase()
    .replaceAll(/[^\p{L}\p{N}]+/gu, '-')
    .replace(/^-/, '');
  const name = [...words].slice(0, MOST_CHARACTERS).join('').replace(/-$/, '');
  return name === '' ? 'untitled' : name;
}
