import type { PassOperation, ProgramAsset } from '../program/program.ts';

/** Prefix of ids of images that shaders import, which are not in the project's asset table. */
const PREFIX = 'imported:';

/**
 * Id of an image that the shader `file` imports from the relative path `path`: `shaders/leak.fs` and `../assets/leak.png` give
 * `imported:assets/leak.png`. Paths cannot leave the project folder.
 */
export function importedAssetId(file: string, path: string): string {
  const parts = file.split('/').slice(0, -1);
  for (const part of path.split(/[\\/]/)) {
    if (part === '..') parts.pop();
    else if (part !== '' && part !== '.') parts.push(part);
  }
  return `${PREFIX}${parts.join('/')}`;
}

/**
 * Whether a shader imports the asset by a path, so that the project does not list it.
 *
 * @example
 * isImported({ id: 'imported:assets/leak.png', kind: 'image', path: 'assets/leak.png' }); // true
 */
export function isImported({ id }: ProgramAsset): boolean {
  return id.startsWith(PREFIX);
}

/** Assets that passes import, without duplicates. */
export function importedAssets(passes: readonly PassOperation[]): ProgramAsset[] {
  const ids = passes.flatMap(({ samplers }) => samplers.flatMap(({ source }) => (source.kind === 'import' ? source.assets : [])));
  return [...new Set(ids)].sort().map((id) => ({ id, kind: 'image', path: id.slice(PREFIX.length) }));
}
