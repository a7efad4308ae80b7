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

/** Letters and digits of all scripts stay; everything else becomes one hyphen. */
function fileName(title: string): string {
  const name = title
    .toLowerCase()
    .replaceAll(/[^\p{L}\p{N}]+/gu, '-')
    .replaceAll(/^-|-$/g, '');
  return name === '' ? 'untitled' : name;
}
