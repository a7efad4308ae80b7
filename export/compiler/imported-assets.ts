import type { PassOperation, ProgramAsset } from '../program/program.ts';

/** Pictures that shaders bring along have no entry in the project's asset table: their id says where they are. */
const PREFIX = 'imported:';

/**
 * Id of a picture that the shader `file` imports from `path`, which is relative to it: `shaders/leak.fs` and `../assets/leak.png` give
 * `imported:assets/leak.png`. What would lead out of the project stays inside.
 */
export function importedAssetId(file: string, path: string): string {
  const parts = file.split('/').slice(0, -1);
  for (const part of path.split(/[\\/]/)) {
    if (part === '..') parts.pop();
    else if (part !== '' && part !== '.') parts.push(part);
  }
  return `${PREFIX}${parts.join('/')}`;
}

export function isImported({ id }: ProgramAsset): boolean {
  return id.startsWith(PREFIX);
}

/** What passes import, each once. */
export function importedAssets(passes: readonly PassOperation[]): ProgramAsset[] {
  const ids = passes.flatMap(({ samplers }) => samplers.flatMap(({ source }) => (source.kind === 'import' ? source.assets : [])));
  return [...new Set(ids)].sort().map((id) => ({ id, kind: 'image', path: id.slice(PREFIX.length) }));
}
