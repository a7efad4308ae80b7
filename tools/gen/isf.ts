import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import type { ShaderFile } from './find-nodes.ts';

/** Definitions of the library's ISF files, in the files' order. */
export async function isfDefinitions(files: readonly ShaderFile[]): Promise<readonly NodeDefinition[]> {
  const skipped = files.filter((file) => file.name.endsWith('.fs')).length;
  if (skipped > 0) console.log(`gen: ${skipped} ISF files have no definition yet, because export/glsl cannot read headers yet.`);
  return [];
}
