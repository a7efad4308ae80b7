import type { InputPort, ParamDefinition, ParamValue, Stateful } from '../../../../nodes/kit/definition.ts';
import { subsetGlyphs } from '../../../../nodes/kit/glyphs.ts';
import { isValueType, type ValueType, type WireType } from '../../../../nodes/kit/wire-types.ts';
import { parseValue } from '../../../graph/expression/param-expression.ts';
import type { DrawOperation, DrawUnder, InputRef, NodeOperation, OutputRef, Resource, ResourceId } from '../../../program/program.ts';
import { type FlatNode, portKey, type Source, sourcesAt } from '../../flat-graph.ts';
import { drawsItself, isDraw, layerInputs, layerOutput, onlyBlends } from '../layers.ts';
import type { ScheduledDraw } from '../scheduled.ts';
import { movingBinding, startValue } from '../slot-allocator.ts';
import { depthAt } from './lower-depth.ts';
import { lowerReadback } from './lower-readback.ts';
import { shadowMapsOf } from './lower-shadow-maps.ts';
import { readsOfTechniques, underAt } from './lower-technique.ts';
import { addResource, addStep, type Lowering, layerAt, resourceAt, type TechniqueReads, valueSteps } from './lowering.ts';

type NodeKind = 'value' | 'source' | 'behavior' | 'geometry';

/** Lowers a node that its runtime plays and that draws nothing. */
export function lowerNode(lowering: Lowering, node: FlatNode): void {
  const kind = playedKind(node);
  if (kind === null) throw new Error(`${node.id} is not played by a runtime of its own.`);
  const outputs: Record<string, OutputRef> = {};
  const writes: ResourceId[] = [];
  for (const [port, { type, whenRead }] of Object.entries(node.definition.outputs)) {
    const source = { node: node.id, port };
    if (whenRead && !lowering.read.has(portKey(source))) continue;
    if (isValueType(type)) {
      outputs[port] = { kind: 'slot', slot: lowering.slots.ofOutput(source, type) };
      continue;
    }
    const resource = addResource(lowering, outputResource(lowering, source, type));
    lowering.resourceOf.set(portKey(source), resource);
    lowering.writerOf.set(resource, node.id);
    writes.push(resource);
    outputs[port] = type === 'layer' ? { kind: 'layer', layer: { color: resource, depth: null } } : { kind: 'resource', resource };
  }
  lowering.computedBy.set(node.id, node.id);
  const operation = { ...nodeOperation(lowering, node, node.id, kind), outputs, writes };
  addStep(lowering, operation, valueSteps(lowering, node));
}

/**
 * Lowers what a node that draws outputs besides its layer: operations that run before anything is drawn, for the outputs that something
 * reads. They have no inputs, so they can be lowered before those of the node.
 */
export function lowerParts(lowering: Lowering, node: FlatNode): void {
  for (const [port, { type, part }] of Object.entries(node.definition.outputs)) {
    const source = { node: node.id, port };
    const id = portKey(source);
    if (part === undefined || isValueType(type) || !lowering.read.has(id) || lowering.resourceOf.has(id)) continue;
    const resource = addResource(lowering, outputResource(lowering, source, type));
    lowering.resourceOf.set(id, resource);
    lowering.writerOf.set(resource, id);
    const operation: NodeOperation & { readonly kind: 'source'; readonly view: 'once' } = {
      id,
      node: node.id,
      kind: 'source',
      view: 'once',
      reads: [],
      writes: [resource],
      type: part,
      inputs: {},
      multiple: [],
      config: {},
      outputs: { [port]: { kind: 'resource', resource } },
      params: uniformParams(lowering, node, node.definition.params),
      assets: assetsOf(node),
    };
    addStep(lowering, operation, valueSteps(lowering, node));
  }
}

export interface DrawRequest {
  readonly node: FlatNode;
  /** The occlusion that is fused with the draw, if any. */
  readonly occlusion: FlatNode | null;
  readonly target: 'screen' | 'texture';
  /** Id of the operation. */
  readonly id: string;
}

/** Lowers a node that draws objects, to the screen or to a texture for its layer or its occlusion's. */
export function lowerDraw(lowering: Lowering, { node, occlusion, target, id }: DrawRequest): ScheduledDraw {
  const shown = layerOutput(occlusion ?? node);
  const drawn = layerOutput(node);
  if (!shown || !drawn) throw new Error(`${node.id} draws no layer.`);
  const image = target === 'texture' ? addColorTarget(lowering, shown, id, onlyBlends(node) ? 1 : lowering.samples) : null;
  const shadowMaps = shadowMapsOf(lowering, node);
  const base = nodeOperation(lowering, node, id, 'draw');
  const hiding = occlusion && drawOcclusion(lowering, occlusion);
  const styled = readsOfTechniques(lowering, node);
  const under = underLayer(lowering, node, styled);
  const own = [...base.reads, ...(shadowMaps === null ? [] : [shadowMaps]), ...(hiding ? [hiding.roomDepth] : [])];
  const reads = [...new Set([...own, ...styled.flatMap(({ layers }) => layers), ...(under ? [under.resource] : [])])];
  const operation: ScheduledDraw = {
    ...base,
    kind: 'draw',
    view: 'each',
    reads,
    writes: image === null ? [] : [image],
    outputs:
      image === null ? {} : { [drawn.port]: { kind: 'layer', layer: { color: image, depth: { resource: image, encoding: 'window' } } } },
    target: image ?? 'screen',
    shadowMaps,
    occlusion: hiding,
    ...(drawsItself(node) ? { ownDrawing: true } : {}),
    ...(onlyBlends(node) ? { onlyBlends: true } : {}),
    ...(under === undefined ? {} : { under }),
    ...(styled.some(({ readsBehind }) => readsBehind) ? { glass: true } : {}),
  };
  addStep(lowering, operation, [...valueSteps(lowering, node), ...(occlusion ? valueSteps(lowering, occlusion) : [])]);
  return operation;
}

/**
 * The layer that glass shows where there are no objects: the one at the node's own input, else the only one of its techniques. Null if its
 * techniques have different layers: each technique shows its own. Undefined if neither the node nor a technique has such a layer.
 */
function underLayer(lowering: Lowering, node: FlatNode, styled: readonly TechniqueReads[]): DrawUnder | null | undefined {
  const [own] = layerInputs(node);
  if (own) return underAt(lowering, own);
  const layers = new Map(styled.flatMap(({ under }) => (under ? [[under.resource, under] as const] : [])));
  const [first, ...others] = layers.values();
  return others.length > 0 ? null : first;
}

function addColorTarget(lowering: Lowering, shown: Source, operation: string, samples: Lowering['samples']): ResourceId {
  const key = portKey(shown);
  addResource(lowering, {
    id: key,
    kind: 'target',
    domain: 'view',
    size: { base: 'view', width: [{ op: 'width' }], height: [{ op: 'height' }] },
    format: lowering.layers.get(key)?.encoding === 'scene' ? 'scene16f' : 'rgba8',
    depth: 'window',
    samples,
    lifetime: 'frame',
  });
  lowering.resourceOf.set(key, key);
  lowering.writerOf.set(key, operation);
  lowering.drawn.add(key);
  return key;
}

function drawOcclusion(lowering: Lowering, occlusion: FlatNode): NonNullable<DrawOperation['occlusion']> {
  const { inputs, params } = occlusion.definition;
  const port = Object.keys(inputs).find((name) => inputs[name]?.type === 'depth');
  const [roomDepth] = port === undefined ? [] : sourcesAt(occlusion, port);
  if (!roomDepth) throw new Error(`${occlusion.id} hides nothing without room depth.`);
  const slots = uniformParams(lowering, occlusion, params);
  return { node: occlusion.id, roomDepth: resourceAt(lowering, roomDepth), params: slots };
}

/** Creates the operation of a node, without its outputs. */
export function nodeOperation<K extends NodeKind | 'draw' | 'cpu'>(
  lowering: Lowering,
  node: FlatNode,
  id: string,
  kind: K,
): NodeOperation & { readonly kind: K; readonly view: 'once' } {
  const { type, params, delay, stateful, worker } = node.definition;
  // The layer of a CPU filter is its field `image`, that of a draw its field `under`; they are no inputs.
  const ports = kind === 'cpu' ? {} : kind === 'draw' ? withoutLayers(node.definition.inputs) : node.definition.inputs;
  const pulses = Object.keys(ports).filter((port) => ports[port]?.type === 'pulse');
  const poses = Object.keys(ports).filter((port) => ports[port]?.type === 'pose');
  const readBack = (port: string, source: Source): InputRef => ({
    kind: 'resource',
    resource: lowerReadback(lowering, node, port, source),
  });
  const inputs = Object.fromEntries(
    Object.entries(ports).map(([port, { type: wire, pixels }]) => [
      port,
      sourcesAt(node, port).map((source) => (pixels ? readBack(port, source) : inputRef(lowering, source, wire, delay ?? false))),
    ]),
  );
  const slots = uniformParams(lowering, node, params);
  const state = stateful && stateOf(node, stateful, slots);
  return {
    id,
    node: node.id,
    kind,
    view: 'once',
    reads: [...new Set(Object.values(inputs).flat().flatMap(resourcesIn))],
    writes: [],
    type,
    inputs,
    multiple: Object.keys(ports).filter((port) => ports[port]?.multiple === true),
    ...(pulses.length > 0 ? { pulses } : {}),
    ...(poses.length > 0 ? { poses } : {}),
    ...(delay ? { delay } : {}),
    ...(state ? { stateful: state } : {}),
    ...(worker ? { worker } : {}),
    outputs: {},
    params: slots,
    config: Object.fromEntries(
      Object.entries(params).flatMap(([name, param]) =>
        param.stage === 'structure' ? [[name, configValue(lowering, node, param, startValue(node, name, param))]] : [],
      ),
    ),
    assets: assetsOf(node),
    ...(drawsDepthMeshes(node) ? { depthMeshes: true } : {}),
  };
}

function assetsOf(node: FlatNode): Record<string, string | null> {
  return Object.fromEntries(
    Object.entries(node.definition.params).flatMap(([name, param]) =>
      param.stage === 'asset' ? [[name, String(startValue(node, name, param)) || null]] : [],
    ),
  );
}

function drawsDepthMeshes(node: FlatNode): boolean {
  const { params } = node.definition;
  return Object.values(params).some((param) => {
    const condition = param.type === 'asset' ? param.depthMeshes : undefined;
    const method = condition && params[condition.param];
    return condition && method && startValue(node, condition.param, method) === condition.is;
  });
}

function withoutLayers(ports: Readonly<Record<string, InputPort>>): Readonly<Record<string, InputPort>> {
  return Object.fromEntries(Object.entries(ports).filter(([, { type }]) => type !== 'layer'));
}

/**
 * The field `stateful` of an operation; null if the node is not stateful. A param with a wire, an expression or a track may exceed any
 * limit, so a node that is stateful above a limit of such a param counts as stateful.
 */
function stateOf(node: FlatNode, stateful: Stateful, slots: Readonly<Record<string, number>>): NodeOperation['stateful'] | null {
  if (stateful === true) return true;
  const moves = (name: string) => sourcesAt(node, name).length > 0 || movingBinding(node, name) !== null;
  if ('moves' in stateful) return stateful.moves.some(moves) ? true : null;
  const { param, above } = stateful;
  const slot = slots[param];
  if (slot === undefined) throw new Error(`${node.id} has no uniform param ${param}.`);
  return moves(param) ? true : { slot, above };
}

function uniformParams(lowering: Lowering, node: FlatNode, params: Readonly<Record<string, ParamDefinition>>): Record<string, number> {
  const uniform = Object.keys(params).filter((name) => params[name]?.stage === 'uniform');
  return Object.fromEntries(uniform.map((name) => [name, lowering.slots.ofParam(node, name)]));
}

function configValue(lowering: Lowering, node: FlatNode, param: ParamDefinition, value: ParamValue): ParamValue {
  if (param.type === 'text' && param.glyphs) return glyphsOf(lowering, node, param.glyphs, String(value));
  const expression = parseValue(param, value);
  if (expression === null) return value;
  if (!expression.ok) throw new Error(`An expression has not been checked: ${expression.message}.`);
  return expression.parts.join(' ');
}

/** The outlines of the glyphs that a text may show. */
function glyphsOf(
  { library }: Lowering,
  node: FlatNode,
  { of, font }: { readonly of: string; readonly font: string },
  live: string,
): string {
  const outlines = library.shader(font);
  const text = node.definition.params[of];
  if (outlines === undefined || !text) throw new Error(`${node.id} has no font ${font} or no text ${of}.`);
  return subsetGlyphs(outlines, node.inputs.has(of) ? live : String(startValue(node, of, text)));
}

function inputRef(lowering: Lowering, source: Source, type: WireType, delay: boolean): InputRef {
  if (isValueType(type)) return { kind: 'slot', slot: lowering.slots.ofInput(source, type) };
  switch (type) {
    case 'layer':
      return { kind: 'layer', layer: layerAt(lowering, source, (from) => depthAt(lowering, from)) };
    case 'pulse':
    case 'pose':
    case 'depth':
    case 'objects':
    case 'lights':
    case 'environment':
    case 'surfaces':
    case 'body':
    case 'capture':
    case 'audio':
      // A delay reads what nodes write that come after it.
      return { kind: 'resource', resource: delay ? portKey(source) : resourceAt(lowering, source) };
    case 'technique':
      return { kind: 'resource', resource: resourceAt(lowering, source) };
  }
}

function resourcesIn(ref: InputRef): ResourceId[] {
  switch (ref.kind) {
    case 'slot':
      return [];
    case 'resource':
      return [ref.resource];
    case 'layer': {
      const { color, depth } = ref.layer;
      return depth && depth.resource !== color ? [color, depth.resource] : [color];
    }
  }
}

function outputResource({ layers }: Lowering, source: Source, type: Exclude<WireType, ValueType>): Resource {
  const id = portKey(source);
  switch (type) {
    case 'layer':
      return { id, kind: 'external', domain: layers.get(id)?.domain ?? 'view' };
    case 'depth':
      return { id, kind: 'room-depth' };
    case 'objects':
    case 'lights':
    case 'environment':
      return { id, kind: type };
    case 'pulse':
      return { id, kind: 'pulses' };
    case 'pose':
      return { id, kind: 'pose' };
    case 'audio':
      return { id, kind: 'sound' };
    case 'body':
      return { id, kind: 'bodies' };
    case 'capture':
      return { id, kind: 'capture' };
    case 'technique':
    case 'surfaces':
      throw new Error(`The program has no resources of type ${type} yet, which ${id} gives.`);
  }
}

/** Whether the node is lowered by `lowerNode`. */
export function isPlayed(node: FlatNode): boolean {
  return playedKind(node) !== null && !isDraw(node);
}

/** The kind of the operation that the node's runtime plays, or null if it has none. */
function playedKind({ definition }: FlatNode): NodeKind | null {
  const { kind } = definition.lowering;
  switch (kind) {
    case 'value':
    case 'source':
    case 'behavior':
    case 'geometry':
      return kind;
    case 'image':
    case 'technique':
    case 'cpu':
    case 'present':
      return null;
  }
}
