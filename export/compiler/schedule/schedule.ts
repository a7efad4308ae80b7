import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import { type Diagnostic, hasErrors, type Result } from '../../../nodes/kit/diagnostics.ts';
import { isProjectShader } from '../../graph/library/project-library.ts';
import type { LayerRef, Resource, SlotTable } from '../../program/program.ts';
import type { Presentation } from '../../program/program-presentation.ts';
import { type Checked, nodesBehind, type Tap } from '../check/check-resolved.ts';
import { type FlatGraph, type FlatNode, portKey } from '../flat-graph.ts';
import type { ShaderStore } from '../shaders/shader-store.ts';
import { totalBytes } from '../target-bytes.ts';
import { type CoverFacts, coversView } from './covers-view.ts';
import { type DemandStart, findDemand } from './demand.ts';
import { fuseOperations } from './fuse/fuse-operations.ts';
import { whyNotOpaque } from './fuse/opaque-objects.ts';
import type { SeparateWire } from './fuse/separate-wire.ts';
import { describeLayers, layerOutput } from './layers.ts';
import { isDelayed } from './lower/lower-delayed.ts';
import { depthAt } from './lower/lower-depth.ts';
import { lowerShown, lowerViewed } from './lower/lower-graph.ts';
import { lowerMovedParam } from './lower/lower-moved-param.ts';
import { isLinkable } from './lower/lower-passes.ts';
import { createLowering, type Lowering, layerAt } from './lower/lowering.ts';
import { markSharedPasses } from './mark-shared-passes.ts';
import { markUnfiltered } from './mark-unfiltered.ts';
import { orderOperations } from './order.ts';
import { isDrawOperation, isPass, type ScheduledAbove, type ScheduledOperation, type ScheduledTrial } from './scheduled.ts';
import { readScreen } from './screen-options.ts';
import { countUses, type Leaf, planScreen, type ScreenPlan } from './screen-plan.ts';
import { shareTargets } from './share-targets.ts';

export interface ScheduleOptions {
  readonly library: NodeLibrary;
  readonly shaders: ShaderStore;
  readonly loopBudget: boolean;
  readonly fuse: boolean;
  /** Ids of image assets without transparency. */
  readonly opaqueImages: ReadonlySet<string>;
  /** Ids of model assets without transparent materials. */
  readonly opaqueModels: ReadonlySet<string>;
}

/** The ordered operations with their resources: the program except for the indices of its shaders. */
export interface Schedule {
  readonly operations: readonly ScheduledOperation[];
  /** `trial` of a technique is an index into `trials`; *link* replaces it by an index of the shader table. */
  readonly resources: readonly Resource[];
  readonly trials: readonly ScheduledTrial[];
  readonly slots: SlotTable;
  readonly presentation: Presentation;
  readonly taps: Readonly<Record<string, LayerRef>>;
  /** Layers that passes read as textures, and why they are not fused. */
  readonly separate: readonly SeparateWire[];
  /** Nodes that the output or a viewed layer depends on. */
  readonly nodes: readonly FlatNode[];
  /** Nodes among them that need an operation, except for thumbnails; a camera image that is only the background needs none. */
  readonly working: ReadonlySet<string>;
}

export interface ScheduleResult extends Result<Schedule> {
  /** The shader text above mistakes, for each node whose shader cannot be linked. */
  readonly above: readonly ScheduledAbove[];
}

type Targets = Pick<Schedule, 'operations' | 'resources'>;

/** Sample count that every WebGL 2 device supports. */
const DRAW_SAMPLES = 4;

/**
 * Third phase: lowers nodes to ordered operations with explicit resources. Includes only what the output needs; viewed layers get
 * additional operations, so that viewing never changes the output.
 */
export function schedule(checked: Checked, options: ScheduleOptions): ScheduleResult {
  const { graph, live, viewed, screen } = checked;
  const order = [...new Map([...live, ...viewed].map((node) => [node.id, node])).values()];
  const layers = describeLayers(order);
  const uses = countUses(live);
  const plan = planScreen(graph, screen, layers, uses);
  const { antialias, around } = readScreen(screen);
  const samples = antialias ? DRAW_SAMPLES : 1;
  const read = new Set([...readOutputs(order), ...checked.taps.map(({ source }) => portKey(source))]);
  const lowering = createLowering({ graph, layers, order, read, compiledIn: plan.blended, onMoved: lowerMovedParam, samples, ...options });
  const demand = findDemand(graph, live, withHeard(demandStart(plan), live));
  const shown = lowerShown(lowering, live, plan.leaves, demand);
  const { diagnostics, above } = lowering;
  if (hasErrors(diagnostics)) return { output: null, diagnostics, above };
  // Viewed layers add steps.
  const ofScreen = new Set(lowering.steps.map(({ operation }) => operation.id));

  const linkable = linkableTaps(lowering, checked);
  const behind = nodesBehind(
    graph,
    linkable.map(({ source }) => source.node),
  );
  const viewedOrder = viewed.filter(({ id }) => behind.has(id));
  const demandOf = (wanted: readonly Tap[]) =>
    findDemand(graph, viewedOrder, { nodes: [], images: wanted.map(({ source }) => source), fused: [] }, demand);
  const viewedDemand = demandOf(linkable);
  lowerViewed(lowering, viewedOrder, viewedDemand, shown);
  const isLive = new Set(live.map(({ id }) => id));
  const viewedLayers = linkable.map(({ name, source }) => [name, layerAt(lowering, source, (layer) => depthAt(lowering, layer))] as const);
  const operations = orderOperations(lowering.steps, shown.onScreen, delayedTargets(order));
  const viewedResources = new Set(viewedLayers.flatMap(([, { color, depth }]) => [color, depth?.resource ?? color]));
  const plain: Targets = { operations: markUnfiltered(operations, lowering.resources), resources: lowering.resources };
  const unfused = new Set(order.flatMap((node) => (node.unfused ? [node.id] : [])));
  const slots = lowering.slots.table();
  const taps = Object.fromEntries(viewedLayers);
  const shared = ({ operations, resources }: Targets) => shareTargets(operations, resources, viewedResources);
  const bytesOf = (made: Targets) => totalBytes({ resources: shared(made), slots, taps });
  const fused = options.fuse
    ? fuseOperations({ ...plain, viewed: viewedResources, unfused }, options.opaqueImages, bytesOf, (draw) =>
        whyNotOpaque(graph, draw, options.opaqueModels),
      )
    : { ...plain, separate: [] };
  const resources = shared(fused);
  const covers =
    isOpaqueColor(plan.background) ||
    coversView(operations, { lowering, opaqueImages: options.opaqueImages, ...ownShaders(graph, options) });
  const shownOperations = fused.operations.filter(({ id }) => ofScreen.has(id));
  const presentation: Presentation = {
    ...presentationOf(plan, shownOperations, samples),
    ...(around && { around }),
    ...(covers && { covers }),
  };
  return {
    output: {
      operations: markSharedPasses({ operations: fused.operations, resources, taps }),
      resources,
      separate: fused.separate,
      trials: lowering.trials,
      slots,
      presentation,
      taps,
      nodes: order.filter(({ id }) => isLive.has(id) || behind.has(id)),
      working: new Set([...demand.nodes, ...demandOf(linkable.filter(({ isThumbnail }) => !isThumbnail)).nodes]),
    },
    diagnostics,
    above: [],
  };
}

function isOpaqueColor(background: Presentation['background']): boolean {
  return background !== 'world' && background[3] === 1;
}

function ownShaders({ nodes }: FlatGraph, { library, shaders }: ScheduleOptions): Pick<CoverFacts, 'node' | 'ownShader'> {
  return {
    node: (id) => nodes.get(id),
    ownShader: ({ definition: { lowering } }) => {
      const source = lowering.kind === 'image' && !isProjectShader(lowering.shader) ? library.shader(lowering.shader) : undefined;
      return source === undefined || lowering.kind !== 'image' ? null : shaders.read(lowering.shader, source).output;
    },
  };
}

function withHeard(start: DemandStart, live: readonly FlatNode[]): DemandStart {
  const heard = live.filter(({ definition }) => definition.heard).map(({ id }) => id);
  return heard.length === 0 ? start : { ...start, nodes: [...start.nodes, ...heard] };
}

/** Outputs that are connected to inputs of these nodes, as `node.port`. */
function readOutputs(nodes: readonly FlatNode[]): readonly string[] {
  return nodes.flatMap(({ inputs }) => [...inputs.values()].flat().map(portKey));
}

function demandStart({ leaves }: ScreenPlan): DemandStart {
  const of = <K extends Leaf['kind']>(kind: K) => leaves.filter((leaf): leaf is Extract<Leaf, { kind: K }> => leaf.kind === kind);
  return {
    nodes: [...of('draw'), ...of('passes')].map(({ node }) => node.id),
    images: of('texture').map(({ source }) => source),
    fused: of('draw').flatMap(({ node, draw }) => (node === draw ? [] : [{ occlusion: node, draw }])),
  };
}

function presentationOf({ background }: ScreenPlan, operations: readonly ScheduledOperation[], samples: number): Presentation {
  const draws = operations.filter(isDrawOperation);
  const composed = operations.some(isPass) || draws.some(({ target }) => target !== 'screen');
  // Full-screen passes cover whole pixels, so a multisampled framebuffer would only add the cost of resolving.
  const onScreen = draws.filter(({ target }) => target === 'screen');
  const tested = onScreen.filter(({ onlyBlends }) => onlyBlends !== true);
  const antialias = samples > 1 && tested.length > 0;
  const screenDepth = tested.length === 0 ? 'none' : onScreen.length === 1 && !composed ? 'whole' : null;
  return { mode: composed ? 'composed' : 'forward', antialias, background, blend: 'alpha', ...(screenDepth && { screenDepth }) };
}

/** Textures of delayed nodes, which contain the previous frame until the end of the frame, by `node.port`. */
function delayedTargets(order: readonly FlatNode[]): ReadonlySet<string> {
  return new Set(
    order
      .filter(isDelayed)
      .flatMap((node) => layerOutput(node) ?? [])
      .map(portKey),
  );
}

/** Drops the viewed layers that depend on a shader that cannot be linked. */
function linkableTaps(lowering: Lowering, { viewed, taps }: Checked): readonly Tap[] {
  const broken = new Set<string>();
  for (const node of viewed) {
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
