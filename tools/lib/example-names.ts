import { readdir } from 'node:fs/promises';
import { join } from 'node:path';

/** The names of all projects in `examples/`, by name. */
export async function exampleNames(root: string): Promise<readonly string[]> {
  const entries = await readdir(join(root, 'examples'), { recursive: true });
  return entries.flatMap((path) => /^([^/\\]+)[/\\]project\.scrim\.json$/.exec(path)?.[1] ?? []).sort();
}
