import type { NodeLibrary } from '../../../../nodes/kit/definition.ts';
import type { Diagnostic } from '../../../../nodes/kit/diagnostics.ts';
import type { DrawUnder, LayerDepthRef, LayerRef, Resource, ResourceId } from '../../../program/program.ts';
import { type FlatGraph, type FlatNode, portKey, type Source } from '../../flat-graph.ts';
import type { ShaderLink } from '../../shaders/shader-link.ts';
import type { ShaderStore } from '../../shaders/shader-store.ts';
import type { LayerTable } from '../layers.ts';
import type { ScheduledAbove, ScheduledOperation, ScheduledTrial, Step } from '../scheduled.ts';
import { createSlotAllocator, type MovedParam, type SlotAllocator } from '../slot-allocator.ts';

/** The program under construction: state shared by the lowering of all nodes. */
export interface Lowering {
  readonly graph: FlatGraph;
  readonly library: NodeLibrary;
  readonly shaders: ShaderStore;
  readonly loopBudget: boolean;
  readonly layers: LayerTable;
  /** Outputs that a node or a viewer reads, as `node.port`. */
  readonly read: ReadonlySet<string>;
  /** Index of every node in topological order. */
  readonly rank: ReadonlyMap<string, number>;
  readonly slots: SlotAllocator;
  /** Samples of targets that objects are drawn into. */
  readonly samples: 1 | 4;
  readonly resources: Resource[];
  /** The tables of curves and gradients among them. */
  readonly tables: Set<ResourceId>;
  readonly steps: Step[];
  /** Complete shaders for testing whether a driver accepts the text of a technique. */
  readonly trials: ScheduledTrial[];
  /** Resource of an output, as `node.port`: the color of a layer, a list, room depth. */
  readonly resourceOf: Map<string, ResourceId>;
  /** Outputs that a draw writes, which therefore have a depth buffer. */
  readonly drawn: Set<string>;
  /** Outputs whose depth a separate pass computes. */
  readonly computedDepth: Map<string, LayerDepthRef | null>;
  /** Resource → operation that completes it. */
  readonly writerOf: Map<ResourceId, string>;
  /** Node → operation that computes its values. */
  readonly computedBy: Map<string, string>;
  /** Delayed image nodes whose textures exist but are not drawn yet. */
  readonly delayed: FlatNode[];
  /** Node of a technique → what draws with that technique read. */
  readonly techniqueReads: Map<string, TechniqueReads>;
  /** Node → operations that set its params from expressions or tracks. */
  readonly movedBy: Map<string, string[]>;
  /** The text above mistakes in shaders that cannot be linked, by node. */
  readonly above: ScheduledAbove[];
  readonly diagnostics: Diagnostic[];
}

export interface TechniqueReads {
  readonly layers: readonly ResourceId[];
  /** Whether the technique shows what is behind its objects, and the layer that it shows where there are no objects (`under`). */
  readonly readsBehind: boolean;
  readonly under: DrawUnder | null;
}

export function createLowering(
  start: Pick<Lowering, 'graph' | 'library' | 'shaders' | 'loopBudget' | 'layers' | 'read' | 'samples'> & {
    readonly order: readonly FlatNode[];
    readonly compiledIn: ReadonlySet<string>;
    readonly onMoved: (lowering: Lowering, moved: MovedParam) => void;
  },
): Lowering {
  const { order, compiledIn, onMoved, ...given } = start;
  const lowering: Lowering = {
    ...given,
    rank: new Map(order.map((node, index) => [node.id, index])),
    slots: createSlotAllocator(start.graph, compiledIn, (moved) => onMoved(lowering, moved)),
    resources: [],
    tables: new Set(),
    steps: [],
    trials: [],
    resourceOf: new Map(),
    drawn: new Set(),
    computedDepth: new Map(),
    writerOf: new Map(),
    computedBy: new Map(),
    delayed: [],
    techniqueReads: new Map(),
    movedBy: new Map(),
    above: [],
    diagnostics: [],
  };
  return lowering;
}

/** Takes over the diagnostics of a linked shader, and the text above its mistake, with the id of the node. */
export function takeLink({ diagnostics, above }: Lowering, node: FlatNode, link: ShaderLink<unknown>): void {
  diagnostics.push(...link.diagnostics.map((diagnostic) => ({ ...diagnostic, nodeId: node.id })));
  if (link.above !== null) above.push({ ...link.above, node: node.id });
}

export function addResource(lowering: Lowering, resource: Resource): ResourceId {
  lowering.resources.push(resource);
  return resource.id;
}

/** Adds an operation. It runs after the operations that complete the resources it reads, and after those in `after`. */
export function addStep(lowering: Lowering, operation: ScheduledOperation, after: readonly (string | undefined)[] = []): void {
  const waits = new Set<string>();
  for (const id of operation.reads) waits.add(lowering.writerOf.get(id) ?? '');
  for (const id of after) waits.add(id ?? '');
  waits.delete('');
  waits.delete(operation.id);
  lowering.steps.push({ operation, after: [...waits] });
}

/** Operations that compute the values at a node's inputs or set its params; none for a delay. */
export function valueSteps({ computedBy, movedBy }: Lowering, node: FlatNode): (string | undefined)[] {
  if (node.definition.delay) return [];
  const wired = [...node.inputs.values()].flatMap((sources) => sources.map((source) => computedBy.get(source.node)));
  return [...wired, ...(movedBy.get(node.id) ?? [])];
}

export function resourceAt({ resourceOf }: Lowering, source: Source): ResourceId {
  const resource = resourceOf.get(portKey(source));
  if (resource === undefined) throw new Error(`${portKey(source)} is read before it is there.`);
  return resource;
}

export function layerAt(lowering: Lowering, source: Source, depthOf: (source: Source) => LayerDepthRef | null): LayerRef {
  return { color: resourceAt(lowering, source), depth: depthOf(source) };
}

export function nodeAt({ graph }: Lowering, id: string): FlatNode {
  const node = graph.nodes.get(id);
  if (!node) throw new Error(`There is no node ${id}.`);
  return node;
}
