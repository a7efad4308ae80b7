import type { NodeDefinition, NodeLibrary } from '../../../nodes/kit/definition.ts';
import type { Diagnostic, Result } from '../../../nodes/kit/diagnostics.ts';
import { isChunkFile } from '../names.ts';
import { sortedEntries } from '../own.ts';

/** Makes a node type of an ISF file or a technique. `file` is what `lowering.shader` will name: `shaders/edge.fs`. */
export type ReadShader = (file: string, source: string) => Result<NodeDefinition>;

export interface ProjectLibrary extends NodeLibrary {
  /** What is wrong with the project's own shaders, each with its file. */
  readonly diagnostics: readonly Diagnostic[];
  /** Node type → file in `shaders/`, for the types that the project brings. */
  readonly files: ReadonlyMap<string, string>;
}

/** Shader names of the project's own files, so that they never collide with the library's. */
export function projectShaderName(file: string): string {
  return `shaders/${file}`;
}

/**
 * The library with the project's own shaders before it: a file `sepia.fs` that is a filter is `filter/sepia`, whatever the
 * library calls so. A file whose header cannot be read brings no type and is in `diagnostics`. A file in `chunks/` brings none: it
 * is what techniques get that include it, the library's too.
 */
export function projectLibrary(base: NodeLibrary, sources: Readonly<Record<string, string>>, readShader: ReadShader): ProjectLibrary {
  const definitions = new Map<string, NodeDefinition>();
  const files = new Map<string, string>();
  const shaders = new Map<string, string>();
  const diagnostics: Diagnostic[] = [];
  for (const [file, source] of sortedEntries(sources)) {
    const name = projectShaderName(file);
    shaders.set(name, source);
    if (isChunkFile(file)) shaders.set(file, source);
    if (!/\.(fs|glsl)$/.test(file) || isChunkFile(file)) continue;
    const read = readShader(name, source);
    diagnostics.push(...read.diagnostics.map((d) => ({ ...d, file: name })));
    if (read.output === null) continue;
    definitions.set(read.output.type, read.output);
    files.set(read.output.type, file);
  }
  return {
    diagnostics,
    files,
    definition: (type) => definitions.get(type) ?? base.definition(type),
    shader: (name) => shaders.get(name) ?? base.shader(name),
    *types() {
      yield* definitions.keys();
      for (const type of base.types()) if (!definitions.has(type)) yield type;
    },
  };
}

/** Reads every text once: most edits change no shader. Forgets texts that the last two projects had no more. */
export function rememberShaders(readShader: ReadShader): { readonly read: ReadShader; endRound(): void } {
  let current = new Map<string, Result<NodeDefinition>>();
  let previous = new Map<string, Result<NodeDefinition>>();
  return {
    read: (file, source) => {
      const key = `${file}\n${source}`;
      const result = current.get(key) ?? previous.get(key) ?? readShader(file, source);
      current.set(key, result);
      return result;
    },
    endRound: () => {
      previous = current;
      current = new Map();
    },
  };
}
