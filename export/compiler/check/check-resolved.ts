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
  /** Nodes that the screen depends on, each after those it depends on itself. */
  readonly live: readonly FlatNode[];
  /** The same for everything that is looked at besides. */
  readonly tapped: readonly FlatNode[];
  readonly taps: readonly Tap[];
}

/** A layer to look at, by the name that it was asked for by. */
export interface Tap {
  readonly name: string;
  readonly source: Source;
}

/**
 * Second phase: whatever is wrong with the project, and with what *resolve* made of it. Taps on layers that are not there or
 * not whole are dropped: to look at something unfinished is no mistake.
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
  const whole = wholeTaps(graph, order, taps);
  const tappedIds = nodesBehind(
    graph,
    whole.map(({ source }) => source.node),
  );
  return { output: { graph, screen, live, tapped: order.filter(({ id }) => tappedIds.has(id)), taps: whole }, diagnostics };
}

/**
 * By depth and then by id, so that equal graphs make equal programs whatever order their nodes were added in. A delay does not wait
 * for what is wired to it.
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

export function nodesBehind({ nodes }: FlatGraph, roots: Iterable<string>): ReadonlySet<string> {
  const behind = new Set(roots);
  // The set grows while it is walked.
  for (const id of behind) {
    for (const sources of nodes.get(id)?.inputs.values() ?? []) for (const { node } of sources) behind.add(node);
  }
  return behind;
}

/** Whether the expressions in its params can be read. Where the screen depends on them, it has been told. */
function isReadable({ definition, bindings }: FlatNode): boolean {
  return [...bindings].every(([name, binding]) => {
    const param = definition.params[name];
    if (!param) return true;
    const expression = 'expression' in binding ? parseBinding(param, binding.expression) : parseValue(param, boundValue(binding));
    return expression?.ok !== false;
  });
}

/** What only shows in the flat graph. */
function checkNode(node: FlatNode): Diagnostic[] {
  const { id: nodeId, definition } = node;
  const diagnostics: Diagnostic[] = [];
  for (const [port, muted] of node.cutOff) {
    if (definition.inputs[port]?.required !== true) continue;
    const message = `Input “${definition.inputs[port].label}” of ${nodeId} receives nothing: ${muted} is muted and passes nothing through.`;
    diagnostics.push({ code: 'SCR015', severity: 'error', nodeId, port, message, fix: `Unmute ${muted}, or mute ${nodeId} too.` });
  }
  return diagnostics;
}

function wholeTaps({ standIns }: FlatGraph, order: readonly FlatNode[], taps: readonly string[]): Tap[] {
  const whole = taps.length === 0 ? new Map<string, FlatNode>() : wholeNodes(order);
  return [...new Set(taps)].sort().flatMap((name): Tap[] => {
    const dot = name.lastIndexOf('.');
    const source = standIns.get(name) ?? { node: name.slice(0, dot), port: name.slice(dot + 1) };
    const outputs = whole.get(source.node)?.definition.outputs ?? {};
    return Object.hasOwn(outputs, source.port) && outputs[source.port]?.type === 'layer' ? [{ name, source }] : [];
  });
}

/** Nodes that have all they require, all the way back. */
function wholeNodes(order: readonly FlatNode[]): ReadonlyMap<string, FlatNode> {
  const isComplete = (node: FlatNode) =>
    Object.entries(node.definition.inputs).every(([port, { required }]) => !required || node.inputs.has(port));
  const whole = new Map(
    order.filter((node) => isComplete(node) && checkNode(node).length === 0 && isReadable(node)).map((node) => [node.id, node]),
  );
  // In the order of the graph one round finds all, but for loops through delays.
  for (let before = -1; before !== whole.size; ) {
    before = whole.size;
    for (const [id, { inputs }] of whole) {
      if ([...inputs.values()].some((sources) => sources.some((source) => !whole.has(source.node)))) whole.delete(id);
    }
  }
  return whole;
}
