import { type Diagnostic, hasErrors, type Result } from '../../../nodes/kit/diagnostics.ts';
import { parseBinding, parseValue } from '../../graph/expression/param-expression.ts';
import { boundValue } from '../../graph/library/param-value.ts';
import { topologicalOrder } from '../../graph/topology.ts';
import { validateProject } from '../../graph/validate/validate.ts';
import type { FlatGraph, FlatNode, Source } from '../flat-graph.ts';
import type { Resolved } from '../resolve/resolve.ts';

/** A graph that can be lowered. */
export interface Checked {
  readonly graph: FlatGraph;
  readonly screen: FlatNode;
  /** Nodes that the output depends on, each after the nodes that it depends on. */
  readonly live: readonly FlatNode[];
  /** Nodes that the viewed layers depend on, in the same order. */
  readonly viewed: readonly FlatNode[];
  readonly taps: readonly Tap[];
}

/** A viewed layer and the name it was requested by. */
export interface Tap {
  readonly name: string;
  readonly source: Source;
}

/**
 * Second phase: validates the project and the resolved graph. Viewed layers that do not exist or are incomplete are dropped without a
 * diagnostic.
 */
export function check({ project, library, graph }: Resolved, taps: readonly string[]): Result<Checked> {
  const diagnostics = validateProject(project, library);
  const { screen } = graph;
  if (!screen && !hasErrors(diagnostics))
    diagnostics.push({ code: 'SCR017', severity: 'error', message: 'The output is muted.', fix: 'Unmute it.' });
  if (!screen || hasErrors(diagnostics)) return { output: null, diagnostics };
  const order = orderOf(graph);
  const liveIds = nodesBehind(graph, [screen.id]);
  const live = order.filter(({ id }) => liveIds.has(id));
  diagnostics.push(...live.flatMap(checkNode));
  if (hasErrors(diagnostics)) return { output: null, diagnostics };
  const whole = completeTaps(graph, order, taps);
  const viewedIds = nodesBehind(
    graph,
    whole.map(({ source }) => source.node),
  );
  return { output: { graph, screen, live, viewed: order.filter(({ id }) => viewedIds.has(id)), taps: whole }, diagnostics };
}

/**
 * Sorts by depth, then by id, so that equal graphs give equal programs whatever order their nodes were added in. A delay does not depend on
 * its inputs.
 */
function orderOf({ nodes }: FlatGraph): FlatNode[] {
  const followers = new Map<string, string[]>();
  for (const id of [...nodes.keys()].sort()) followers.set(id, []);
  for (const node of nodes.values()) {
    if (node.definition.delay) continue;
    for (const sources of node.inputs.values()) for (const { node: from } of sources) followers.get(from)?.push(node.id);
  }
  const { order, left } = topologicalOrder(followers.keys(), (id) => followers.get(id) ?? []);
  if (left.size > 0) throw new Error('A graph without loops has got one by being flattened.');
  return order.flatMap((id) => nodes.get(id) ?? []);
}

/** @returns The ids of `roots` and of all nodes that they depend on. */
export function nodesBehind({ nodes }: FlatGraph, roots: Iterable<string>): ReadonlySet<string> {
  const behind = new Set(roots);
  // The set grows during the iteration.
  for (const id of behind) {
    for (const sources of nodes.get(id)?.inputs.values() ?? []) for (const { node } of sources) behind.add(node);
  }
  return behind;
}

/** Whether the expressions in the node's params are valid. For nodes that the output depends on, validation has reported errors. */
function isReadable({ definition, bindings }: FlatNode): boolean {
  return [...bindings].every(([name, binding]) => {
    const param = definition.params[name];
    if (!param) return true;
    const expression = 'expression' in binding ? parseBinding(param, binding.expression) : parseValue(param, boundValue(binding));
    return expression?.ok !== false;
  });
}

/** Checks that need the flat graph. */
function checkNode(node: FlatNode): Diagnostic[] {
  const { id: nodeId, definition } = node;
  const diagnostics: Diagnostic[] = [];
  for (const [port, muted] of node.muteBlocked) {
    if (definition.inputs[port]?.required !== true) continue;
    const message = `Input “${definition.inputs[port].label}” of ${nodeId} receives nothing: ${muted} is muted and passes nothing through.`;
    diagnostics.push({ code: 'SCR015', severity: 'error', nodeId, port, message, fix: `Unmute ${muted}, or mute ${nodeId} too.` });
  }
  return diagnostics;
}

function completeTaps({ replacements }: FlatGraph, order: readonly FlatNode[], taps: readonly string[]): Tap[] {
  const whole = taps.length === 0 ? new Map<string, FlatNode>() : completeNodes(order);
  return [...new Set(taps)].sort().flatMap((name): Tap[] => {
    const dot = name.lastIndexOf('.');
    const source = replacements.get(name) ?? { node: name.slice(0, dot), port: name.slice(dot + 1) };
    const outputs = whole.get(source.node)?.definition.outputs ?? {};
    return Object.hasOwn(outputs, source.port) && outputs[source.port]?.type === 'layer' ? [{ name, source }] : [];
  });
}

/** Nodes whose required inputs are connected, and those of all nodes that they depend on. */
function completeNodes(order: readonly FlatNode[]): ReadonlyMap<string, FlatNode> {
  const isComplete = (node: FlatNode) =>
    Object.entries(node.definition.inputs).every(([port, { required }]) => !required || node.inputs.has(port));
  const whole = new Map(
    order.filter((node) => isComplete(node) && checkNode(node).length === 0 && isReadable(node)).map((node) => [node.id, node]),
  );
  // In graph order one pass finds all nodes, except for loops through delays.
  for (let before = -1; before !== whole.size; ) {
    before = whole.size;
    for (const [id, { inputs }] of whole) {
      if ([...inputs.values()].some((sources) => sources.some((source) => !whole.has(source.node)))) whole.delete(id);
    }
  }
  return whole;
}
