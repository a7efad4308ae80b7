import type { ParamDefinition, ParamValue } from '../../../nodes/kit/definition.ts';
import type { Binding } from '../../graph/project.ts';
import { type Checked, nodesBehind } from '../check/check-resolved.ts';
import { type FlatNode, portKey, type Source } from '../flat-graph.ts';
import { bindingFor, constantParam, constantsOf } from './constants.ts';
import type { FoldedNode } from './folded-node.ts';
import { type UnchangedLayers, unchangedLayer } from './unchanged.ts';

export interface Folded {
  readonly checked: Checked;
  /** Nodes that the output depended on and that are left out, in the order of the graph. */
  readonly folded: readonly FoldedNode[];
}

/**
 * Computes at compile time what a page would compute in every frame with the same result (ADR 48), for programs whose params nothing but
 * their own controls can set:
 *
 * - outputs of value nodes with constant params, and expressions without time, become constants;
 * - of equal value nodes and of equal effects on the same layer, one is kept;
 * - effects whose params say that they change nothing are left out, with what only they need.
 *
 * The params of nodes that are kept keep their slots. Viewed layers need all nodes, so a graph with viewed layers is returned as it is.
 */
export function fold(checked: Checked, unchanged: UnchangedLayers): Folded {
  const { graph, screen, live, taps } = checked;
  if (taps.length > 0) return { checked, folded: [] };
  const replaced = new Map<string, Source>();
  const constants = new Map<string, ParamValue>();
  const nodes = new Map(graph.nodes);
  const alike = new Map<string, FlatNode>();
  const repeats = new Set<string>();
  const readers = readersOf(live);
  for (const { id } of live) {
    const before = nodes.get(id);
    if (!before) continue;
    const node = withConstants(rewired(before, replaced), constants);
    nodes.set(id, node);
    for (const [port, value] of constantsOf(node)) constants.set(portKey({ node: id, port }), value);
    const same = replacementOf(node);
    if (same) for (const [port, source] of same) replaced.set(portKey({ node: id, port }), source);
  }
  // Delays come before what they read.
  for (const { id, definition } of live) {
    const node = nodes.get(id);
    if (node && definition.delay) nodes.set(id, withConstants(rewired(node, replaced), constants));
  }
  const folded = { ...graph, nodes };
  const heard = live.filter(({ definition }) => definition.heard).map(({ id }) => id);
  const behind = nodesBehind(folded, [screen.id, ...heard]);
  const kept = live.flatMap(({ id }) => (behind.has(id) ? (nodes.get(id) ?? []) : []));
  const shown = nodes.get(screen.id) ?? screen;
  const leftOut = live.flatMap(({ id, definition }) => (behind.has(id) ? [] : [whyLeftOut(id, Object.keys(definition.outputs))]));
  return { checked: { ...checked, graph: { ...folded, screen: shown }, screen: shown, live: kept }, folded: leftOut };

  function whyLeftOut(id: string, ports: readonly string[]): FoldedNode {
    const keys = ports.map((port) => portKey({ node: id, port }));
    const [instead] = keys.flatMap((key) => replaced.get(key)?.node ?? []);
    if (instead !== undefined) return { node: id, reason: repeats.has(id) ? 'unchanged' : 'equal', instead };
    return { node: id, reason: keys.some((key) => constants.has(key)) ? 'constant' : 'unread', instead: null };
  }

  /** What replaces the outputs of a node: those of an equal node, or a layer that it would only repeat. */
  function replacementOf(node: FlatNode): readonly (readonly [port: string, source: Source])[] | null {
    const ports = Object.keys(node.definition.outputs);
    const layer = unchangedLayer(node, readers.get(node.id) ?? [], unchanged);
    const [port] = ports;
    if (layer && port !== undefined && ports.length === 1) {
      repeats.add(node.id);
      return [[port, layer]];
    }
    const key = keyOf(node);
    const first = key === null ? undefined : alike.get(key);
    if (first) return ports.map((output) => [output, { node: first.id, port: output }]);
    if (key !== null) alike.set(key, node);
    return null;
  }
}

function readersOf(live: readonly FlatNode[]): ReadonlyMap<string, readonly FlatNode[]> {
  const readers = new Map<string, FlatNode[]>();
  for (const node of live) {
    for (const source of [...node.inputs.values()].flat()) readers.set(source.node, [...(readers.get(source.node) ?? []), node]);
  }
  return readers;
}

function rewired(node: FlatNode, replaced: ReadonlyMap<string, Source>): FlatNode {
  const isRead = [...node.inputs.values()].some((sources) => sources.some((source) => replaced.has(portKey(source))));
  if (!isRead) return node;
  const inputs = [...node.inputs].map(
    ([port, sources]) => [port, sources.map((source) => replaced.get(portKey(source)) ?? source)] as const,
  );
  return { ...node, inputs: new Map(inputs) };
}

/** The node with constants in place of wires and expressions that always have the same value. */
function withConstants(node: FlatNode, constants: ReadonlyMap<string, ParamValue>): FlatNode {
  const inputs = new Map(node.inputs);
  const bindings = new Map(node.bindings);
  for (const [name, param] of Object.entries(node.definition.params)) {
    const binding = constantBinding(node, name, param, constants);
    if (binding === null) continue;
    inputs.delete(name);
    bindings.set(name, binding);
  }
  return inputs.size === node.inputs.size && sameBindings(bindings, node.bindings) ? node : { ...node, inputs, bindings };
}

function sameBindings(a: ReadonlyMap<string, Binding>, b: ReadonlyMap<string, Binding>): boolean {
  return a.size === b.size && [...a].every(([name, binding]) => b.get(name) === binding);
}

function constantBinding(node: FlatNode, name: string, param: ParamDefinition, constants: ReadonlyMap<string, ParamValue>): Binding | null {
  const [source] = node.inputs.get(name) ?? [];
  const value = source ? constants.get(portKey(source)) : expressionValue(node, name, param);
  return value === undefined ? null : bindingFor(param, value);
}

/** The value of an expression that is the same in all frames; undefined if the param has no such expression. */
function expressionValue(node: FlatNode, name: string, param: ParamDefinition): ParamValue | undefined {
  const binding = node.bindings.get(name);
  return binding && 'expression' in binding ? constantParam(node, name, param) : undefined;
}

/** Equal for nodes with equal outputs; null if that is not known. */
function keyOf(node: FlatNode): string | null {
  const { definition, unfused, inputs, bindings } = node;
  const { lowering, delay, stateful, control, visitorParams, computes, type } = definition;
  if (delay || stateful || control || visitorParams) return null;
  const isImage = lowering.kind === 'image' && lowering.access !== 'persistent' && lowering.early === undefined;
  if (!isImage && computes === undefined) return null;
  const params = Object.entries(definition.params).map(([name, param]) => [
    name,
    inputs.has(name) ? null : (constantParam(node, name, param) ?? bindings.get(name)),
  ]);
  return JSON.stringify([type, unfused, params, [...inputs].sort(([a], [b]) => (a < b ? -1 : 1))]);
}
