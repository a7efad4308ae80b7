import { readNodeInterface } from '../../../export/glsl/read-definition.ts';
import { subgraphType } from '../../../export/graph/document-names.ts';
import { createInterfaceLookup, type NodeInterface } from '../../../export/graph/library/node-interface.ts';
import { createShaderCache, type ProjectLibrary, projectLibrary, type ReadShader } from '../../../export/graph/library/project-library.ts';
import { EMPTY_GRAPH } from '../../../export/graph/new-project.ts';
import { type ExposedPorts, MAIN_GRAPH, type Project } from '../../../export/graph/project.ts';
import { libraryOf, type NodeDefinition, type NodeLibrary } from '../../../nodes/kit/definition.ts';

/** Node types and shader texts of `nodes/generated`. */
export interface LibraryData {
  readonly definitions: readonly NodeDefinition[];
  readonly shaders: Readonly<Record<string, string>>;
}

/** Reads the node type of a shader file from its header. The compiler parses the GLSL, in its worker. */
export const readShader: ReadShader = (file, source) => {
  return readNodeInterface(source, file);
};

/** Creates the node library of each open project. */
export interface Libraries {
  /** The library without the shaders and subgraphs of a project. */
  readonly base: NodeLibrary;
  /** Reads shader headers, cached by text. */
  readonly readShader: ReadShader;
  /**
   * The library with the shaders and subgraphs of a project. While the header of a shader is invalid, its node keeps the ports of the
   * last valid header, so that an unfinished edit removes no wires.
   */
  readonly of: (project: Pick<Project, 'sources' | 'graphs'>) => ProjectLibrary;
  /** The library without subgraphs, for the compiler, which replaces instances by their contents. */
  readonly withoutSubgraphs: (project: Pick<Project, 'sources'>) => ProjectLibrary;
}

interface Whole {
  readonly graphs: Project['graphs'];
  readonly own: ProjectLibrary;
  /** The subgraph definitions, and their JSON. */
  readonly definitions: readonly NodeDefinition[];
  readonly text: string;
  readonly library: ProjectLibrary;
}

export function createLibraries(data: LibraryData): Libraries {
  const base = libraryOf(data.definitions, data.shaders);
  const lastGood = new Map<string, NodeDefinition>();
  // An equal header keeps its definition object, so that the canvas does not render again.
  const cache = createShaderCache((file, source) => {
    const { output, diagnostics } = readShader(file, source);
    const before = lastGood.get(file);
    return { output: before && JSON.stringify(before) === JSON.stringify(output) ? before : output, diagnostics };
  });
  let last: { readonly sources: Project['sources']; readonly library: ProjectLibrary } | null = null;
  const readOrLastGood: ReadShader = (file, source) => {
    const result = cache.read(file, source);
    if (result.output !== null) lastGood.set(file, result.output);
    return { output: result.output ?? lastGood.get(file) ?? null, diagnostics: result.diagnostics };
  };
  const withoutSubgraphs: Libraries['withoutSubgraphs'] = ({ sources }) => {
    if (last?.sources === sources) return last.library;
    const library = projectLibrary(base, sources, readOrLastGood);
    cache.endGeneration();
    last = { sources, library };
    return library;
  };
  let lastWhole: Whole | null = null;
  return {
    base,
    readShader: cache.read,
    withoutSubgraphs,
    of: ({ sources, graphs }) => {
      const own = withoutSubgraphs({ sources });
      if (lastWhole?.graphs === graphs && lastWhole.own === own) return lastWhole.library;
      const made = subgraphDefinitions(graphs, own);
      const text = JSON.stringify(made);
      // Keeps the objects while the interfaces of the subgraphs are unchanged, because the whole canvas depends on them.
      const definitions = lastWhole?.text === text ? lastWhole.definitions : made;
      const library =
        lastWhole?.definitions === definitions && lastWhole.own === own ? lastWhole.library : withDefinitions(own, definitions);
      lastWhole = { graphs, own, text, definitions, library };
      return library;
    },
  };
}

/** Whether two libraries have the same node types; the texts of shaders may differ. */
export function hasSameTypes(a: ProjectLibrary, b: ProjectLibrary): boolean {
  if (a === b) return true;
  const types = [...a.types()];
  const others = [...b.types()];
  return types.length === others.length && types.every((type, i) => type === others[i] && a.definition(type) === b.definition(type));
}

/** Search keywords of all subgraphs. */
const KEYWORDS = ['library', 'project', 'own', 'group'];

/** Subgraphs as node types. They have no lowering of their own, because the compiler replaces them by their contents. */
function subgraphDefinitions(graphs: Project['graphs'], library: NodeLibrary): readonly NodeDefinition[] {
  const interfaceOf = createInterfaceLookup({ graphs }, library);
  return Object.keys(graphs)
    .filter((name) => name !== MAIN_GRAPH)
    .flatMap((name) => {
      const nodeInterface = interfaceOf(subgraphType(name));
      return nodeInterface
        ? [
            {
              ...nodeInterface,
              ...wordsOf(name, nodeInterface, graphs[name]?.exposed ?? EMPTY_GRAPH.exposed),
              keywords: KEYWORDS,
              lowering: { kind: 'behavior' as const },
            },
          ]
        : [];
    });
}

/**
 * Title and docs of a subgraph. Ports that were renamed or that share a label are labeled by their exposed names instead of the labels that
 * they have inside.
 */
function wordsOf(
  name: string,
  nodeInterface: NodeInterface,
  { inputs, outputs }: ExposedPorts,
): Pick<NodeInterface, 'title' | 'doc' | 'inputs' | 'outputs' | 'params'> {
  const renamed = new Set(
    [...inputs, ...outputs].filter(({ name: shown, port }) => !isNumbered(shown, port)).map(({ name: shown }) => shown),
  );
  const labels = [nodeInterface.inputs, nodeInterface.params].flatMap((ports) => Object.values(ports).map(({ label }) => label));
  const named = <T extends { readonly label: string }>(ports: Readonly<Record<string, T>>, among: readonly string[]) =>
    Object.fromEntries(
      Object.entries(ports).map(([port, value]) => {
        const alone = among.filter((label) => label === value.label).length < 2;
        return [port, alone && !renamed.has(port) ? value : { ...value, label: titleOfName(port) }];
      }),
    );
  return {
    title: titleOfName(name),
    doc: 'A subgraph of this project. Open it to edit its nodes; the edits apply to all of its instances.',
    inputs: named(nodeInterface.inputs, labels),
    outputs: named(
      nodeInterface.outputs,
      Object.values(nodeInterface.outputs).map(({ label }) => label),
    ),
    params: named(nodeInterface.params, labels),
  };
}

/** Whether a name is another one, or the same with a number. */
function isNumbered(name: string, stem: string): boolean {
  return name.startsWith(stem) && /^\d*$/.test(name.slice(stem.length));
}

/** Makes a title from a name: `soft-look` → `Soft look`, `inputImage2` → `Input image 2`. */
export function titleOfName(name: string): string {
  const words = name
    .replaceAll(/([a-z])([A-Z0-9])/g, '$1 $2')
    .replaceAll(/[-_]+/g, ' ')
    .toLowerCase();
  return words.charAt(0).toUpperCase() + words.slice(1);
}

function withDefinitions(library: ProjectLibrary, definitions: readonly NodeDefinition[]): ProjectLibrary {
  const byType = new Map(definitions.map((definition) => [definition.type, definition]));
  if (byType.size === 0) return library;
  return {
    ...library,
    definition: (type) => byType.get(type) ?? library.definition(type),
    *types() {
      yield* library.types();
      yield* byType.keys();
    },
  };
}
