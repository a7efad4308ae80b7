import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import { createEncodingLookup } from '../encoding-lookup.ts';
import { CONVERSIONS } from '../layer-encoding.ts';
import type { Project, Wire } from '../project.ts';
import { getOwn } from '../record.ts';
import { sameWire } from '../wires.ts';
import { type Change, graphOf, sequence, unchanged } from './change.ts';
import { addNode } from './node-commands.ts';
import { connect } from './wire-commands.ts';

export interface ConvertLayers {
  readonly library: NodeLibrary;
  readonly graph: string;
  /** Wires to convert first: where two layers differ, the new one is converted. */
  readonly first: readonly Wire[];
  /** Wires that stay as they are, although they do not fit. */
  readonly except: readonly Wire[];
  /** An unused id for a node of a type. */
  readonly makeId: (project: Project, type: string) => string;
}

/**
 * Inserts “Tone map” and “To scene” into wires whose layers have another encoding than their input needs (ADR 38). A conversion may make
 * further wires fit or not, so they are looked up again after each.
 *
 * @returns The change; never refused. Nothing changes if the library has no such node types.
 * @throws Error if the graph does not exist.
 *
 * @example
 * convertLayers(project, { library, graph: 'main', first: [wire], except: [], makeId: (p, type) => makeNodeId(p, type, random) });
 */
export function convertLayers(project: Project, options: ConvertLayers): Change {
  const { library, graph, first, except } = options;
  const { wires } = graphOf(project, graph);
  const { conversionOf } = createEncodingLookup(project, library, graph);
  const wire = first.find((candidate) => isIn(wires, candidate) && conversionOf(candidate, 'others') !== null);
  const next = wire ?? wires.find((other) => conversionOf(other, 'earlier') !== null && !isIn(except, other));
  const encoding = next && conversionOf(next, wire ? 'others' : 'earlier');
  const type = encoding ? CONVERSIONS[encoding].type : '';
  const definition = library.definition(type);
  const input = definition && Object.keys(definition.inputs)[0];
  const output = definition && Object.keys(definition.outputs)[0];
  if (!next || !input || !output) return unchanged(project);
  const id = options.makeId(project, type);
  return sequence(
    project,
    (before) => addNode(before, { library, graph, id, type, ...between(before, graph, next) }),
    (before) => connect(before, { library, graph, from: next.from, to: { node: id, port: input } }),
    (before) => connect(before, { library, graph, from: { node: id, port: output }, to: next.to }),
    (before) => convertLayers(before, options),
  );
}

/**
 * Wires of a graph whose layers do not fit their inputs.
 *
 * @example
 * // A scene layer goes through a blur to a sepia filter, which takes display layers only.
 * misfittingWires(project, library, 'main').map(printWire); // ['blur-a1b2.layer -> sepia-k7q2.inputImage']
 */
export function misfittingWires(project: Project, library: NodeLibrary, graph: string): readonly Wire[] {
  const lookup = createEncodingLookup(project, library, graph);
  return graphOf(project, graph).wires.filter((wire) => lookup.conversionOf(wire, 'earlier') !== null);
}

function isIn(wires: readonly Wire[], wire: Wire): boolean {
  return wires.some((other) => sameWire(other, wire));
}

function between(project: Project, graph: string, { from, to }: Wire): { readonly x: number; readonly y: number } {
  const nodes = getOwn(project.layout, graph)?.nodes ?? {};
  const [start, end] = [getOwn(nodes, from.node) ?? { x: 0, y: 0 }, getOwn(nodes, to.node) ?? { x: 0, y: 0 }];
  return { x: (start.x + end.x) / 2, y: (start.y + end.y) / 2 };
}
