import type { Migration, NodeDefinition, NodeLibrary, SavedParams } from '../../../nodes/kit/definition.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { PORT_NAME } from '../document/name-rules.ts';
import { readBinding } from '../document/read-binding.ts';
import { printJson } from '../json/print-json.ts';
import { createShapeReader } from '../json/shape-reader.ts';
import type { Binding, Graph, GraphNode, Project } from '../project.ts';
import { saveBinding } from '../save.ts';
import { renamedPort, renameParams, renamePorts } from './rename-params.ts';

export interface Migrated<P> {
  readonly project: P;
  readonly diagnostics: readonly Diagnostic[];
}

/**
 * Migrates the params of every node to the version of its type in the library. Unchanged nodes and graphs stay the same objects. Nodes of
 * unknown types and of newer versions stay unchanged; `validateProject` reports them.
 *
 * @returns The migrated project, and SCR018 for params that cannot be migrated and for wires whose unit changed.
 * @throws Error if a node type lacks a migration, which is a programming error.
 *
 * @example
 * const { project: migrated, diagnostics } = migrateNodes(loaded, library);
 */
export function migrateNodes<P extends Pick<Project, 'graphs'>>(project: P, library: NodeLibrary): Migrated<P> {
  const diagnostics: Diagnostic[] = [];
  let graphs: Record<string, Graph> | null = null;
  for (const [name, graph] of Object.entries(project.graphs)) {
    const nodes = migrateGraph(graph, library, diagnostics);
    if (nodes === null) continue;
    graphs ??= { ...project.graphs };
    graphs[name] = { ...renameWired(graph, library, diagnostics), nodes };
  }
  return { project: graphs === null ? project : { ...project, graphs }, diagnostics };
}

function migrateGraph(graph: Graph, library: NodeLibrary, diagnostics: Diagnostic[]): Graph['nodes'] | null {
  let nodes: Record<string, GraphNode> | null = null;
  for (const [id, node] of Object.entries(graph.nodes)) {
    const definition = library.definition(node.type);
    if (definition === undefined || node.version >= definition.version) continue;
    const migrated = migrateNode(node, definition);
    if (typeof migrated === 'string') {
      const message = `The parameters of ${id} (${node.type}, version ${node.version}) cannot be migrated: ${migrated}`;
      diagnostics.push({ code: 'SCR018', severity: 'error', nodeId: id, message });
      continue;
    }
    nodes ??= { ...graph.nodes };
    nodes[id] = migrated;
  }
  return nodes;
}

/** All migrations of a type, both functions and declared renames. */
export function migrationsOf({ migrations, renamed = [] }: NodeDefinition): readonly Migration[] {
  return migrations ?? renamed.map((names) => (params) => renameParams(params, names));
}

/** Renames the ends of wires. Values on wires are not converted, which a diagnostic reports. */
function renameWired(graph: Graph, library: NodeLibrary, diagnostics: Diagnostic[]): Graph {
  const isRenamed = ({ type, version }: GraphNode) => (library.definition(type)?.renamed?.length ?? 0) >= version;
  if (!Object.values(graph.nodes).some(isRenamed)) return graph;
  return renamePorts(graph, ({ node: id, port }) => {
    const node = graph.nodes[id];
    const definition = node && library.definition(node.type);
    if (!node || !definition) return port;
    const { to, times } = renamedPort(port, node, definition);
    if (times !== 1) {
      const message = `The unit of “${definition.params[to]?.label ?? to}” of ${id} has changed since the project was saved.`;
      diagnostics.push({
        code: 'SCR018',
        severity: 'warning',
        nodeId: id,
        port: to,
        message,
        fix: `Multiply the connected value by ${times}.`,
      });
    }
    return to;
  });
}

/** Returns a binding in the form in which files store it, because migrations read that form. */
function asSaved(binding: Binding): unknown {
  return JSON.parse(printJson(saveBinding(binding)));
}

/** The migrated node, or the error message: files may contain anything, but migrations expect what the editor saves. */
function migrateNode(node: GraphNode, definition: NodeDefinition): GraphNode | string {
  let saved: SavedParams = Object.fromEntries(Object.entries(node.params).map(([name, binding]) => [name, asSaved(binding)]));
  for (let version = node.version; version < definition.version; version++) {
    const step = migrationsOf(definition)[version - 1];
    if (step === undefined) throw new Error(`${definition.type} has no migration from version ${version} to ${version + 1}.`);
    try {
      saved = step(saved);
    } catch (error) {
      return String(error);
    }
  }
  const reader = createShapeReader();
  const params = reader.record(saved, ['params'], PORT_NAME, (json, path) => readBinding(reader, json, path));
  const [problem] = reader.problems;
  return problem?.message ?? { ...node, version: definition.version, params };
}
