import { subgraphName } from '../../../export/graph/document-names.ts';
import { type Binding, type Graph, MAIN_GRAPH, type PortAddress, type Project } from '../../../export/graph/project.ts';
import { getOwn, sortedEntries } from '../../../export/graph/record.ts';
import type { ParamEdit } from './changes.ts';

/** A param of the running program. `node` is its id there: `outer/inner` within subgraphs. */
export type PlacedEdit = Pick<ParamEdit, 'node' | 'param' | 'value'>;

/** Maximum number of values to set in the running program. For more, a recompile is faster. */
const MAX_USES = 2000;

/**
 * A place where a graph is used: the main graph, or one instance of a subgraph. For an instance, `place` is the node in the place `within`
 * which it lies; null for the main graph.
 */
interface Use {
  /** Prefix of its node ids in the program: empty, or `outer/`. */
  readonly prefix: string;
  readonly name: string;
  readonly graph: Graph;
  readonly place: { readonly node: string; readonly within: Use } | null;
}

/**
 * Finds the params of the running program that an edit changes: one in the main graph, or one per instance of a subgraph. A value set
 * on an instance replaces the value inside; an edit of an instance applies to the exposed param. Returns null if a recompile is
 * needed.
 */
export function placesOf(project: Project, edit: ParamEdit): readonly PlacedEdit[] | null {
  const uses = usesOf(project, edit.graph);
  if (uses === null) return null;
  const places: PlacedEdit[] = [];
  for (const start of uses) {
    const end = innermost(project, start, { node: edit.node, port: edit.param });
    if (end === null) return null;
    const { use, node, port } = end;
    const binding = outermostBinding(end) ?? getOwn(getOwn(use.graph.nodes, node)?.params ?? {}, port);
    const value = binding === undefined ? edit.value : heldValue(binding);
    if (value === undefined) return null;
    places.push({ node: use.prefix + node, param: port, value });
  }
  return places;
}

function heldValue(binding: Binding): ParamEdit['value'] | undefined {
  if ('value' in binding) return binding.value;
  return 'port' in binding ? binding.port : undefined;
}

/** All instances of a graph that are reachable from the main graph; null if there are too many. */
function usesOf({ graphs }: Project, name: string): readonly Use[] | null {
  const main = getOwn(graphs, MAIN_GRAPH);
  if (!main) return [];
  const leading = graphsLeadingTo(graphs, name);
  const list: Use[] = [{ prefix: '', name: MAIN_GRAPH, graph: main, place: null }];
  // The loop also visits elements that are appended during it.
  for (const within of list) {
    for (const [node, { type, muted }] of sortedEntries(within.graph.nodes)) {
      const used = subgraphName(type);
      const graph = used === null || muted === true || !leading.has(used) ? undefined : getOwn(graphs, used);
      if (used !== null && graph) list.push({ prefix: `${within.prefix}${node}/`, name: used, graph, place: { node, within } });
    }
    if (list.length > MAX_USES) return null;
  }
  return list.filter((use) => use.name === name);
}

/** The graph and all graphs that contain it, directly or not. */
function graphsLeadingTo(graphs: Project['graphs'], name: string): ReadonlySet<string> {
  const users = new Map<string, string[]>();
  for (const [user, { nodes }] of Object.entries(graphs)) {
    for (const { type } of Object.values(nodes)) {
      const used = subgraphName(type);
      if (used !== null) users.set(used, [...(users.get(used) ?? []), user]);
    }
  }
  const leading = new Set([name]);
  // The loop also visits elements that are added during it.
  for (const graph of leading) for (const user of users.get(graph) ?? []) leading.add(user);
  return leading;
}

interface End extends PortAddress {
  readonly use: Use;
}

/** Follows an exposed port into the subgraphs to the node that owns it; null if there is none. */
function innermost({ graphs }: Project, start: Use, { node, port }: PortAddress): End | null {
  let at: End = { use: start, node, port };
  for (let depth = 0; depth <= MAX_USES; depth++) {
    const type = getOwn(at.use.graph.nodes, at.node)?.type;
    const name = type === undefined ? null : subgraphName(type);
    if (name === null) return type === undefined ? null : at;
    const graph = getOwn(graphs, name);
    const next = graph?.exposed.inputs.find((exposed) => exposed.name === at.port);
    if (!graph || !next) return null;
    const use: Use = { prefix: `${at.use.prefix}${at.node}/`, name, graph, place: { node: at.node, within: at.use } };
    at = { use, node: next.node, port: next.port };
  }
  return null;
}

/** The binding of the param on the surrounding instances. The outermost one applies; of several exposed names, the first. */
function outermostBinding({ use, node, port }: End): Binding | undefined {
  let found: Binding | undefined;
  let addresses: readonly PortAddress[] = [{ node, port }];
  for (let inner = use; inner.place !== null && addresses.length > 0; inner = inner.place.within) {
    const shown = inner.graph.exposed.inputs.filter((exposed) => addresses.some((a) => a.node === exposed.node && a.port === exposed.port));
    const { node: outer, within } = inner.place;
    const params = getOwn(within.graph.nodes, outer)?.params ?? {};
    const set = shown.find(({ name }) => getOwn(params, name) !== undefined);
    if (set) found = getOwn(params, set.name);
    addresses = shown.map(({ name }) => ({ node: outer, port: name }));
  }
  return found;
}
