import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import { type Diagnostic, hasErrors, type Result } from '../../../nodes/kit/diagnostics.ts';
import type { LayerRef, Presentation, Resource, SlotTable } from '../../program/program.ts';
import { type Checked, nodesBehind, type Tap } from '../check/check-resolved.ts';
import { type FlatNode, portKey } from '../flat-graph.ts';
import type { ShaderStore } from '../shaders/shader-store.ts';
import { type DemandStart, findDemand } from './demand.ts';
import { describeLayers, layerOutput } from './layers.ts';
import { isDelayed } from './lower/lower-delayed.ts';
import { depthAt } from './lower/lower-depth.ts';
import { lowerShown, lowerTapped } from './lower/lower-graph.ts';
import { lowerMovedParam } from './lower/lower-moved-param.ts';
import { isLinkable } from './lower/lower-passes.ts';
import { createLowering, type Lowering, layerAt } from './lower/lowering.ts';
import { orderOperations } from './order.ts';
import { isDrawOperation, isPass, type ScheduledAbove, type ScheduledOperation, type ScheduledTrial } from './scheduled.ts';
import { readScreen } from './screen-options.ts';
import { countUses, type Leaf, planScreen, type ScreenPlan } from './screen-plan.ts';
import { shareTargets } from './share-targets.ts';

export interface ScheduleOptions {
  readonly library: NodeLibrary;
  readonly shaders: ShaderStore;
  readonly loopBudget: boolean;
}

/** The operations in order, with what they read and write, and all that is known of the program but its shaders' places. */
export interface Schedule {
  readonly operations: readonly ScheduledOperation[];
  /** The `trial` of a technique is an index into `trials`; *link* puts its place among the shaders there. */
  readonly resources: readonly Resource[];
  readonly trials: readonly ScheduledTrial[];
  readonly slots: SlotTable;
  readonly presentation: Presentation;
  readonly taps: Readonly<Record<string, LayerRef>>;
  /** Nodes that the screen depends on, or what is looked at. */
  readonly nodes: readonly FlatNode[];
  /** Those of them that have work to do: a world that is the background has none. */
  readonly working: ReadonlySet<string>;
}

export interface ScheduleResult extends Result<Schedule> {
  /** Where shaders have mistakes: what stands above them. */
  readonly above: readonly ScheduledAbove[];
}

/** What every device has. */
const DRAW_SAMPLES = 4;

/**
 * Third phase: nodes to operations with explicit resources, in order. Only what the screen needs; what is looked at besides gets
 * operations of its own, so that looking never changes the picture.
 */
export function schedule(checked: Checked, options: ScheduleOptions): ScheduleResult {
  const { graph, live, tapped, screen } = checked;
  const order = [...new Map([...live, ...tapped].map((node) => [node.id, node])).values()];
  const layers = describeLayers(order);
  const uses = countUses(live);
  const plan = planScreen(graph, screen, layers, uses);
  const { antialias, around } = readScreen(screen);
  const samples = antialias ? DRAW_SAMPLES : 1;
  const lowering = createLowering({ graph, layers, order, compiledIn: plan.blended, onMoved: lowerMovedParam, samples, ...options });
  const demand = findDemand(graph, live, startOf(plan));
  const shown = lowerShown(lowering, live, plan.leaves, demand);
  const { diagnostics, above } = lowering;
  if (hasErrors(diagnostics)) return { output: null, diagnostics, above };
  const presentation: Presentation = { ...presentationOf(plan, lowering), ...(around && { around }) };

  const taps = linkableTaps(lowering, checked);
  const behind = nodesBehind(
    graph,
    taps.map(({ source }) => source.node),
  );
  const besides = tapped.filter(({ id }) => behind.has(id));
  const looked = findDemand(graph, besides, { nodes: [], images: taps.map(({ source }) => source), sunk: [] }, demand);
  lowerTapped(lowering, besides, looked, shown);
  const isLive = new Set(live.map(({ id }) => id));
  const tappedLayers = taps.map(({ name, source }) => [name, layerAt(lowering, source, (layer) => depthAt(lowering, layer))] as const);
  const operations = orderOperations(lowering.steps, shown.onScreen, delayedPictures(order));
  const lookedAt = new Set(tappedLayers.flatMap(([, { color, depth }]) => [color, depth?.resource ?? color]));
  return {
    output: {
      operations,
      resources: shareTargets(operations, lowering.resources, lookedAt),
      trials: lowering.trials,
      slots: lowering.slots.table(),
      presentation,
      taps: Object.fromEntries(tappedLayers),
      nodes: order.filter(({ id }) => isLive.has(id) || behind.has(id)),
      working: new Set([...demand.nodes, ...looked.nodes]),
    },
    diagnostics,
    above: [],
  };
}

function startOf({ leaves }: ScreenPlan): DemandStart {
  const of = <K extends Leaf['kind']>(kind: K) => leaves.filter((leaf): leaf is Extract<Leaf, { kind: K }> => leaf.kind === kind);
  return {
    nodes: [...of('draw'), ...of('passes')].map(({ node }) => node.id),
    images: of('picture').map(({ source }) => source),
    sunk: of('draw').flatMap(({ node, draw }) => (node === draw ? [] : [{ occlusion: node, draw }])),
  };
}

function presentationOf({ background }: ScreenPlan, { steps, samples }: Lowering): Presentation {
  const draws = steps.map(({ operation }) => operation).filter(isDrawOperation);
  const composed = steps.some(({ operation }) => isPass(operation)) || draws.some(({ target }) => target !== 'screen');
  // Passes cover whole pixels: a multisampled framebuffer would cost them a resolve and show no difference.
  const antialias = samples > 1 && draws.some(({ target }) => target === 'screen');
  return { mode: composed ? 'composed' : 'forward', antialias, background, blend: 'alpha' };
}

/** Layers that show the previous frame. */
function delayedPictures(order: readonly FlatNode[]): ReadonlySet<string> {
  return new Set(
    order
      .filter(isDelayed)
      .flatMap((node) => layerOutput(node) ?? [])
      .map(portKey),
  );
}

/** A shader that cannot be linked takes the pictures behind it, and no others: the screen does not depend on it. */
function linkableTaps(lowering: Lowering, { tapped, taps }: Checked): readonly Tap[] {
  const broken = new Set<string>();
  for (const node of tapped) {
    const after = [...node.inputs.values()].flat().some((source) => broken.has(source.node));
    if (after || !isLinkable(lowering, node)) broken.add(node.id);
    if (!after && broken.has(node.id)) lowering.diagnostics.push(brokenShader(node));
  }
  return taps.filter(({ source }) => !broken.has(source.node));
}

function brokenShader({ id, definition }: FlatNode): Diagnostic {
  return {
    code: 'SCR041',
    severity: 'warning',
    nodeId: id,
    message: `The shader of ${id} (${definition.title}) cannot be read, so the node shows nothing.`,
  };
}
