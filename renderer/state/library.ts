import { readDefinition } from '../../export/glsl/read-definition.ts';
import { type ProjectLibrary, projectLibrary, type ReadShader, rememberShaders } from '../../export/graph/library/project-library.ts';
import type { Project } from '../../export/graph/project.ts';
import type { NodeDefinition, NodeLibrary } from '../../nodes/kit/definition.ts';

/** Node types and shader texts as `nodes/generated` has them. */
export interface LibraryData {
  readonly definitions: readonly NodeDefinition[];
  readonly shaders: Readonly<Record<string, string>>;
}

export function baseLibrary({ definitions, shaders }: LibraryData): NodeLibrary {
  const byType = new Map(definitions.map((definition) => [definition.type, definition]));
  return {
    definition: (type) => byType.get(type),
    shader: (name) => (Object.hasOwn(shaders, name) ? shaders[name] : undefined),
    types: () => byType.keys(),
  };
}

/** The node type that a shader file is, or what is wrong with its header. */
export const readShader: ReadShader = (file, source) => {
  return readDefinition(source, file);
};

/** What the editor knows of node types, for one project after the other. */
export interface Libraries {
  /** Without any project's own shaders. */
  readonly base: NodeLibrary;
  /** Reads each text once. */
  readonly readShader: ReadShader;
  /**
   * With the project's own shaders. While a shader's header is broken, its node keeps the ports it had when the header could
   * last be read: a comma forgotten while typing takes no wires away.
   */
  readonly of: (project: Pick<Project, 'sources'>) => ProjectLibrary;
}

export function createLibraries(data: LibraryData): Libraries {
  const base = baseLibrary(data);
  const remembered = rememberShaders(readShader);
  const lastGood = new Map<string, NodeDefinition>();
  let last: { readonly sources: Project['sources']; readonly library: ProjectLibrary } | null = null;
  const readOrLastGood: ReadShader = (file, source) => {
    const result = remembered.read(file, source);
    if (result.output !== null) lastGood.set(file, result.output);
    return { output: result.output ?? lastGood.get(file) ?? null, diagnostics: result.diagnostics };
  };
  return {
    base,
    readShader: remembered.read,
    of: ({ sources }) => {
      if (last?.sources === sources) return last.library;
      const library = projectLibrary(base, sources, readOrLastGood);
      remembered.endRound();
      last = { sources, library };
      return library;
    },
  };
}
