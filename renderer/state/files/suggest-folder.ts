import type { Editor } from '../editor/editor.ts';

/**
 * A folder in the projects folder, named after a title: `My effect` gives `/home/me/Scrim/my-effect`. It may already exist.
 *
 * @param ending Added to the name, such as `-page`.
 */
export function suggestFolder({ document }: Pick<Editor, 'document'>, title: string, ending = ''): string {
  const { projectsDir } = document.getState();
  const separator = projectsDir.includes('\\') ? '\\' : '/';
  return projectsDir === '' ? '' : `${projectsDir}${separator}${fileName(title)}${ending}`;
}

/** The folder, or the first of `PATH-2`, `PATH-3` and so on that is not taken. */
export function freeFolder(path: string, taken: ReadonlySet<string>): string {
  let free = path;
  for (let number = 2; taken.has(free); number++) free = `${path}-${number}`;
  return free;
}

/** Letters and digits of all scripts stay; everything else becomes one hyphen. */
function fileName(title: string): string {
  const name = title
    .toLowerCase()
    .replaceAll(/[^\p{L}\p{N}]+/gu, '-')
    .replaceAll(/^-|-$/g, '');
  return name === '' ? 'untitled' : name;
}
