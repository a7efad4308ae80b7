/** The folder and the last part of a path of any system: `/home/me/Scrim/effect` gives `/home/me/Scrim` and `effect`. */
export function splitPath(path: string): readonly [folder: string, name: string] {
  const [, folder = '', name = ''] = /^(.*)[/\\]([^/\\]*)$/s.exec(path.trim()) ?? [];
  // The root keeps its separator.
  return [folder === '' || /^[a-z]:$/i.test(folder) ? path.trim().slice(0, folder.length + 1) : folder, name];
}

export function joinPath(folder: string, name: string): string {
  const separator = folder.includes('\\') ? '\\' : '/';
  return folder.endsWith(separator) ? `${folder}${name}` : `${folder}${separator}${name}`;
}
