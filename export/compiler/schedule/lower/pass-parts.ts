import type { NamedSize } from '../../../glsl/isf/isf-shader.ts';
import { companionOf } from '../../../glsl/isf/read-isf.ts';
import type { LinkedPass, LinkedSampler, LinkedUniform, PassTarget } from '../../../glsl/link/linked-pass.ts';
import type { LayerDepthRef, PassSampler, PassUniform, ResourceId, SizeExpression, TargetSize } from '../../../program/program.ts';
import { type FlatNode, portKey, type Source, sourcesAt } from '../../flat-graph.ts';
import { importedAssetId } from '../../imported-assets.ts';
import type { LinkVariant } from '../../shaders/shader-store.ts';
import { layerInputs, layerOutput } from '../layers.ts';
import { startValue } from '../slot-allocator.ts';
import { addResource, type Lowering, resourceAt } from './lowering.ts';

export type Fit = Exclude<PassSampler['fit'], 'none'>;

const FITS: readonly Fit[] = ['cover', 'contain', 'stretch'];

/** The shader of an image node and the variant in which it is linked for that node. */
export interface NodeShader {
  readonly file: string;
  readonly source: string;
  /** Text of its vertex shader, if any. */
  readonly vertex: string | null;
  readonly variant: LinkVariant;
}

/** Input types that an image node reads as textures. */
const PICTURES: ReadonlySet<string> = new Set(['layer', 'depth', 'audio']);

export function shaderOf(lowering: Lowering, node: FlatNode, hasDepth: (layer: Source) => boolean): NodeShader {
  const { lowering: kind, inputs, type } = node.definition;
  if (kind.kind !== 'image') throw new Error(`${node.id} has no shader.`);
  const source = lowering.library.shader(kind.shader);
  if (source === undefined) throw new Error(`The library has no shader ${kind.shader} for ${type}.`);
  const ports = Object.keys(inputs).filter((port) => PICTURES.has(inputs[port]?.type ?? ''));
  const vertex = lowering.library.shader(companionOf(kind.shader)) ?? null;
  const output = layerOutput(node);
  const scene = output !== null && lowering.layers.get(portKey(output))?.encoding === 'scene';
  const absent = ports.filter((port) => !node.inputs.has(port));
  const withoutDepth = ports.filter((port) => {
    const [layer] = inputs[port]?.type === 'layer' ? sourcesAt(node, port) : [];
    return layer !== undefined && !hasDepth(layer);
  });
  return { file: kind.shader, source, vertex, variant: { loopBudget: lowering.loopBudget, absent, withoutDepth, scene } };
}

export interface PassSamplers {
  readonly samplers: readonly PassSampler[];
  readonly reads: readonly ResourceId[];
}

/** Resources for the inputs and buffers of a pass. `buffers` contains the node's own. */
export function passSamplers(
  lowering: Lowering,
  node: FlatNode,
  pass: LinkedPass,
  buffers: ReadonlyMap<string, ResourceId>,
  depthOf: (layer: Source) => LayerDepthRef | null,
): PassSamplers {
  const samplers = pass.samplers.map(({ name, source }) => ({ name, ...sampled(lowering, node, source, buffers, depthOf) }));
  return {
    samplers,
    reads: [...new Set(samplers.flatMap(({ source }) => resourcesOf(source)))],
  };
}

function resourcesOf(source: PassSampler['source']): ResourceId[] {
  if (source.kind === 'import') return [];
  return [source.kind === 'depth' ? source.depth.resource : source.resource];
}

/** The assets of an image that a shader imports: one, or the six faces of a cube. */
function importedAt(lowering: Lowering, node: FlatNode, name: string): PassSampler['source'] {
  const { file, source } = shaderOf(lowering, node, () => true);
  const imported = lowering.shaders.read(file, source).output?.imported.find((image) => image.name === name);
  if (!imported) throw new Error(`${file} imports no ${name}.`);
  return { kind: 'import', assets: imported.paths.map((path) => importedAssetId(file, path)), cube: imported.cube };
}

function sampled(
  lowering: Lowering,
  node: FlatNode,
  from: LinkedSampler['source'],
  buffers: ReadonlyMap<string, ResourceId>,
  depthOf: (layer: Source) => LayerDepthRef | null,
): Omit<PassSampler, 'name'> {
  if (from.kind === 'buffer') {
    const resource = buffers.get(from.target);
    if (resource === undefined) throw new Error(`The shader of ${node.id} reads the buffer ${from.target}, which nobody makes.`);
    return { source: { kind: 'color', resource }, fit: 'none' };
  }
  if (from.kind === 'table') return { source: { kind: 'table', resource: tableAt(lowering, node, from) }, fit: 'none' };
  if (from.kind === 'import') return { source: importedAt(lowering, node, from.import), fit: 'none' };
  const [input] = sourcesAt(node, from.input);
  if (!input) throw new Error(`The shader of ${node.id} reads ${from.input}, which has no wire.`);
  if (from.kind === 'input-depth') {
    const depth = depthOf(input);
    if (!depth) throw new Error(`${node.id} was linked to read a depth that is not there.`);
    return { source: { kind: 'depth', depth }, fit: 'none' };
  }
  const resource = resourceAt(lowering, input);
  if (from.kind === 'sound') return { source: { kind: 'sound', resource, analysis: from.analysis, count: from.count }, fit: 'none' };
  if (from.kind === 'room-depth') return { source: { kind: 'room-depth', resource }, fit: 'none' };
  return { source: { kind: 'color', resource }, fit: fitAt(lowering, node, input) };
}

/** The table of a curve or a gradient, one per node and param. */
function tableAt(lowering: Lowering, node: FlatNode, { of, param }: Extract<LinkedSampler['source'], { kind: 'table' }>): ResourceId {
  const id = `${node.id}.${param}.${of}`;
  if (lowering.tables.has(id)) return id;
  lowering.tables.add(id);
  return addResource(lowering, { id, kind: 'table', of, slot: lowering.slots.ofParam(node, param) });
}

/** Uniforms of a pass: params refer to slots, events to lists of pulses. */
export function passUniforms({ slots }: Lowering, node: FlatNode, pass: LinkedPass): PassUniform[] {
  return pass.uniforms.map(({ name, type, source }) => ({
    name,
    type,
    source: uniformSource(source),
  }));

  function uniformSource(source: LinkedUniform['source']): PassUniform['source'] {
    if ('param' in source) return { slot: slots.ofParam(node, source.param) };
    return 'event' in source ? { pulses: sourcesAt(node, source.event).map(portKey) } : source;
  }
}

/** How a pass fits a layer: a node of the view domain fits an image of its own size to the view, all other layers need no fitting. */
function fitAt({ layers }: Lowering, node: FlatNode, layer: Source): PassSampler['fit'] {
  const output = layerOutput(node);
  const isView = !output || layers.get(portKey(output))?.domain !== 'image';
  return isView && layers.get(portKey(layer))?.domain === 'image' ? fitOf(node) : 'none';
}

/** Size of a node's textures: that of the view or of its first layer, or an expression over it from the shader's header. */
export function sizeOf(lowering: Lowering, node: FlatNode, width: NamedSize | null, height: NamedSize | null): TargetSize {
  const output = layerOutput(node);
  const isImage = output && lowering.layers.get(portKey(output))?.domain === 'image';
  const [first] = layerInputs(node);
  return {
    base: isImage && first ? resourceAt(lowering, first) : 'view',
    width: width === null ? [{ op: 'width' }] : sizeExpression(lowering, node, width),
    height: height === null ? [{ op: 'height' }] : sizeExpression(lowering, node, height),
  };
}

function sizeExpression({ slots }: Lowering, node: FlatNode, named: NamedSize): SizeExpression {
  return named.map((token) => (typeof token === 'object' && 'param' in token ? { slot: slots.ofParam(node, token.param) } : token));
}

export function isBuffer(target: PassTarget): target is Extract<PassTarget, { kind: 'buffer' }> {
  return target.kind === 'buffer';
}

/** How a node fits images of their own size to the view: its structure param `fit`, or `cover`. */
export function fitOf(node: FlatNode): Fit {
  const param = Object.hasOwn(node.definition.params, 'fit') ? node.definition.params.fit : undefined;
  const value = param?.stage === 'structure' ? startValue(node, 'fit', param) : undefined;
  return FITS.find((fit) => fit === value) ?? 'cover';
}
