/**
 * Why `path` cannot be the path of an asset, in words, or null where it can. Assets lie inside the project folder: nothing that
 * a file system or a web server could read as a way out of it is let through.
 */
export function assetPathProblem(path: string): string | null {
  if (path === '') return 'it is empty';
  if (path.length > 512) return 'it is longer than 512 characters';
  if (hasControlCharacter(path)) return 'it has a control character in it';
  if (path.includes('\\')) return 'it has a backslash in it; parts are separated by /';
  if (path.startsWith('/')) return 'it is absolute';
  if (/^[a-z][a-z0-9+.-]*:/i.test(path)) return 'it begins with a drive or a scheme';
  if (/%[0-9a-f]{2}/i.test(path)) return 'it has a %-escape in it; write the character itself';
  const parts = path.split('/');
  if (parts.includes('')) return 'a part between two / is empty';
  // Some systems drop dots and spaces at the end of a name, so that ".. ." would be "..".
  if (parts.some((part) => /^[. ]+$/.test(part))) return 'a part of it leads to another folder';
  return null;
}

function hasControlCharacter(text: string): boolean {
  for (let i = 0; i < text.length; i++) {
    const code = text.charCodeAt(i);
    if (code < 0x20 || (code >= 0x7f && code < 0xa0)) return true;
  }
  return false;
}
