/**
 * Checks the path of an asset. Assets are inside the project folder, so a path that a file system or a web server could resolve outside of
 * it is invalid.
 *
 * @param path Relative to the project folder, with `/` between folders.
 * @returns Why the path is invalid, as a clause (“it is empty”), or null if it is valid.
 *
 * @example
 * assetPathProblem('assets/statue.glb'); // null
 * assetPathProblem('../statue.glb'); // 'it leaves the project folder'
 */
export function assetPathProblem(path: string): string | null {
  if (path === '') return 'it is empty';
  if (path.length > 512) return 'it is longer than 512 characters';
  if (hasControlCharacter(path)) return 'it contains a control character';
  if (path.includes('\\')) return 'it contains a backslash; separate folders by /';
  if (path.startsWith('/')) return 'it is absolute';
  if (/^[a-z][a-z0-9+.-]*:/i.test(path)) return 'it starts with a drive or a URL scheme';
  if (/%[0-9a-f]{2}/i.test(path)) return 'it contains a %-escape; write the character itself';
  const parts = path.split('/');
  if (parts.includes('')) return 'it has an empty folder name';
  // Some systems drop dots and spaces at the end of a name, so “.. .” would become “..”.
  if (parts.some((part) => /^[. ]+$/.test(part))) return 'it leaves the project folder';
  return null;
}

function hasControlCharacter(text: string): boolean {
  for (let i = 0; i < text.length; i++) {
    const code = text.charCodeAt(i);
    if (code < 0x20 || (code >= 0x7f && code < 0xa0)) return true;
  }
  return false;
}
