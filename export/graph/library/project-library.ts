import type { NodeDefinition, NodeLibrary } from '../../../nodes/kit/definition.ts';
import type { Diagnostic, Result } from '../../../nodes/kit/diagnostics.ts';
import { isChunkFile } from '../document-names.ts';
import { sortedEntries } from '../record.ts';

/** Reads the node type of an ISF shader or a technique. `file` becomes `lowering.shader`, as in `shaders/edge.fs`. */
export type ReadShader = (file: string, source: string) => Result<NodeDefinition>;

export interface ProjectLibrary extends NodeLibrary {
  /** Problems of the project's own shaders, each with its file. */
  readonly diagnostics: readonly Diagnostic[];
  /** Node type → file in `shaders/`, for the types of the project. */
  readonly files: ReadonlyMap<string, string>;
}

/** The name under which a library has a project's shader. The prefix prevents collisions with the library's own shaders. */
export function projectShaderName(file: string): string {
  return `shaders/${file}`;
}

/** Whether a shader of this name belongs to the project. */
export function isProjectShader(name: string): boolean {
  return name.startsWith('shaders/');
}

/**
 * Adds a project's own shaders to a library. They take precedence: a filter `sepia.fs` replaces the library's `filter/sepia`. A file with
 * an invalid header adds no type and is reported in `diagnostics`. Files in `chunks/` add no type; techniques include them, also those of
 * the library.
 *
 * @param base The library without the project's shaders.
 * @param sources Shader texts by file name in `shaders/`.
 * @param readShader Reads every text in each call, so pass a cached one (`createShaderCache`).
 *
 * @example
 * const cache = createShaderCache(readShader);
 * const library = projectLibrary(base, project.sources, cache.read);
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

/**
 * Caches results of `readShader` by file and text, because most edits change no shader. `endGeneration` drops the texts that were not read
 * since its previous call.
 *
 * @example
 * const cache = createShaderCache(readShader);
 * projectLibrary(base, project.sources, cache.read);
 * cache.endGeneration();
 */
export function createShaderCache(readShader: ReadShader): { readonly read: ReadShader; endGeneration(): void } {
  let current = new Map<string, Result<NodeDefinition>>();
  let previous = new Map<string, Result<NodeDefinition>>();
  return {
    read: (file, source) => {
      const key = `${file}\n${source}`;
      const result = current.get(key) ?? previous.get(key) ?? readShader(file, source);
      current.set(key, result);
      return result;
    },
    endGeneration: () => {
      previous = current;
      current = new Map();
    },
  };
}
