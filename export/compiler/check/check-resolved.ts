import type { LayerEncoding } from '../../../nodes/kit/definition.ts';
import { type Diagnostic, hasErrors, type Result } from '../../../nodes/kit/diagnostics.ts';
import { parseBinding, parseValue } from '../../graph/expression/param-expression.ts';
import { CONVERSIONS, neededEncoding, outputEncoding } from '../../graph/layer-encoding.ts';
import { boundValue } from '../../graph/library/param-value.ts';
import { topologicalOrder } from '../../graph/topology.ts';
import { validateProject } from '../../graph/validate/validate.ts';
import { actorsOf, type FlatGraph, type FlatNode, portKey, type Source, sourcesAt } from '../flat-graph.ts';
import type { Resolved } from '../resolve/resolve.ts';
import { encodedNode } from '../schedule/layers.ts';

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

/** Names of layers to view; see `CompileOptions`. */
export interface ViewedLayers {
  readonly taps: readonly string[];
  readonly thumbnails: readonly string[];
}

/** A viewed layer and the name it was requested by. */
export interface Tap {
  readonly name: string;
  readonly source: Source;
  readonly isThumbnail: boolean;
}

/**
 * Second phase: validates the project and the resolved graph. Viewed layers that do not exist or are incomplete are dropped without a
 * diagnostic.
 */
export function check({ project, library, graph }: Resolved, wanted: ViewedLayers): Result<Checked> {
  const diagnostics = validateProject(project, library);
  const { screen } = graph;
  if (!screen && !hasErrors(diagnostics))
    diagnostics.push({ code: 'SCR017', severity: 'error', message: 'The output is muted.', fix: 'Unmute it.' });
  if (!screen || hasErrors(diagnostics)) return { output: null, diagnostics };
  const order = orderOf(graph);
  const encodings = encodingsOf(order);
  const liveIds = nodesBehind(graph, [screen.id, ...heardNodes(order, encodings)]);
  const live = order.filter(({ id }) => liveIds.has(id));
  diagnostics.push(...live.flatMap((node) => checkNode(node, encodings)), ...checkSingle(live));
  if (hasErrors(diagnostics)) return { output: null, diagnostics };
  const whole = completeTaps(graph, order, wanted, encodings).filter((tap) => !tap.isThumbnail || isInert(graph, tap, liveIds));
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

/** @returns The ids of `roots` and of all nodes that they depend on, with the nodes that act on those. */
export function nodesBehind({ nodes }: FlatGraph, roots: Iterable<string>): ReadonlySet<string> {
  const behind = new Set(roots);
  const actors = actorsOf(nodes.values());
  // The set grows during the iteration.
  for (const id of behind) {
    for (const sources of nodes.get(id)?.inputs.values() ?? []) for (const { node } of sources) behind.add(node);
    for (const actor of actors.get(id) ?? []) behind.add(actor);
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

/** Finds the mistakes of a node that only the flat graph shows: muted sources and layer encodings. */
function checkNode(node: FlatNode, encodings: Encodings): Diagnostic[] {
  const { id: nodeId, definition } = node;
  const diagnostics: Diagnostic[] = [];
  for (const [port, muted] of node.muteBlocked) {
    if (definition.inputs[port]?.required !== true) continue;
    const message = `Input “${definition.inputs[port].label}” of ${nodeId} receives nothing: ${muted} is muted and passes nothing through.`;
    diagnostics.push({ code: 'SCR015', severity: 'error', nodeId, port, message, fix: `Unmute ${muted}, or mute ${nodeId} too.` });
  }
  return [...diagnostics, ...checkEncodings(node, encodings)];
}

/** Reports further nodes of a type of which a graph may have only one node. */
function checkSingle(live: readonly FlatNode[]): Diagnostic[] {
  const first = new Map<string, FlatNode>();
  return live.flatMap((node): Diagnostic[] => {
    const { id: nodeId, definition } = node;
    if (!definition.single) return [];
    const other = first.get(definition.type);
    if (!other) {
      first.set(definition.type, node);
      return [];
    }
    const message = `The graph has two nodes “${definition.title}”: ${other.id} and ${nodeId}.`;
    return [{ code: 'SCR027', severity: 'error', nodeId, message, fix: `Connect everything to ${other.id}, and delete ${nodeId}.` }];
  });
}

/** Encoding of each layer output, by `portKey`. */
type Encodings = ReadonlyMap<string, LayerEncoding>;

/** Finds the encodings of all layer outputs. A delay outputs display layers, so the encodings of its inputs need not be known before. */
function encodingsOf(order: readonly FlatNode[]): Encodings {
  const encodings = new Map<string, LayerEncoding>();
  for (const node of order) {
    const encoded = encodedNode(node, (source) => encodings.get(portKey(source)) ?? 'display');
    for (const [port, { type }] of Object.entries(node.definition.outputs)) {
      if (type === 'layer') encodings.set(portKey({ node: node.id, port }), outputEncoding(encoded, port));
    }
  }
  return encodings;
}

function checkEncodings(node: FlatNode, encodings: Encodings): Diagnostic[] {
  const { id: nodeId, definition } = node;
  const encoded = encodedNode(node, (source) => encodings.get(portKey(source)) ?? 'display');
  return Object.entries(definition.inputs).flatMap(([port, { type, label }]): Diagnostic[] => {
    const [source] = type === 'layer' ? sourcesAt(node, port) : [];
    const needed = neededEncoding(encoded, port);
    const given = encoded.encodingAt(port);
    if (!source || needed === null || given === null || given === needed) return [];
    const other = definition.inputs[port]?.encoding === 'either' ? ', as its first layer is' : '';
    const message = `Input “${label}” of ${nodeId} needs a ${needed} layer${other}, but ${portKey(source)} is a ${given} layer.`;
    const fix = `Insert “${CONVERSIONS[needed].title}” into the wire.`;
    return [{ code: 'SCR048', severity: 'error', nodeId, port, message, fix }];
  });
}

function completeTaps({ replacements }: FlatGraph, order: readonly FlatNode[], wanted: ViewedLayers, encodings: Encodings): Tap[] {
  const names = new Set([...wanted.taps, ...wanted.thumbnails]);
  const viewed = new Set(wanted.taps);
  const whole = names.size === 0 ? new Map<string, FlatNode>() : completeNodes(order, encodings);
  return [...names].sort().flatMap((name): Tap[] => {
    const dot = name.lastIndexOf('.');
    const source = replacements.get(name) ?? { node: name.slice(0, dot), port: name.slice(dot + 1) };
    const outputs = whole.get(source.node)?.definition.outputs ?? {};
    return Object.hasOwn(outputs, source.port) && outputs[source.port]?.type === 'layer'
      ? [{ name, source, isThumbnail: !viewed.has(name) }]
      : [];
  });
}

/**
 * Whether a layer can be viewed without effect on how the program plays. The nodes that it adds to the program then request no capability
 * (except if sampled, which a thumbnail does not count as), read no input, show no controls and do not depend on earlier frames.
 */
function isInert(graph: FlatGraph, { source }: Tap, live: ReadonlySet<string>): boolean {
  return [...nodesBehind(graph, [source.node])].every((id) => {
    const definition = graph.nodes.get(id)?.definition;
    if (!definition || live.has(id)) return true;
    const { needs = [], control, visitorParams, single, heard, readsInput, stateful, lowering } = definition;
    if (control || visitorParams || single || heard || readsInput || stateful) return false;
    return needs.every(({ when }) => when === 'sampled') && !(lowering.kind === 'image' && lowering.access === 'persistent');
  });
}

/** Nodes that play sound. An incomplete one is left out without a diagnostic, as an incomplete viewed layer is. */
function heardNodes(order: readonly FlatNode[], encodings: Encodings): readonly string[] {
  if (!order.some(({ definition }) => definition.heard)) return [];
  return [...completeNodes(order, encodings).values()].filter(({ definition }) => definition.heard).map(({ id }) => id);
}

/**
 * Finds the nodes that can be played: they have no mistakes, their required inputs are connected, and the same is true of all nodes that
 * they depend on.
 */
function completeNodes(order: readonly FlatNode[], encodings: Encodings): ReadonlyMap<string, FlatNode> {
  const isComplete = (node: FlatNode) =>
    Object.entries(node.definition.inputs).every(([port, { required }]) => !required || node.inputs.has(port));
  const whole = new Map(
    order.filter((node) => isComplete(node) && checkNode(node, encodings).length === 0 && isReadable(node)).map((node) => [node.id, node]),
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
