import type { PartedPass } from '../../../glsl/link/link-parts.ts';
import type { ResourceId } from '../../../program/program.ts';
import { type FlatNode, portKey, sourcesAt } from '../../flat-graph.ts';
import { layerOutput } from '../layers.ts';
import type { ScheduledPass } from '../scheduled.ts';
import { depthAt, hasDepth } from './lower-depth.ts';
import { addResource, addStep, type Lowering, takeLink, valueSteps } from './lowering.ts';
import { isBuffer, passSamplers, passUniforms, shaderOf, sizeOf } from './pass-parts.ts';

/** A linked image node with its buffers. */
export interface LoweredPasses {
  readonly passes: readonly PartedPass[];
  readonly buffers: ReadonlyMap<string, ResourceId>;
}

/**
 * Links an image node and adds its passes; the last one draws to the node's texture or to the screen. If the shader cannot be linked, it
 * adds diagnostics, and the texture is never drawn.
 */
export function lowerPasses(lowering: Lowering, node: FlatNode, target: 'screen' | 'texture'): LoweredPasses {
  return drawPasses(lowering, node, linkPasses(lowering, node), (pass, id) => lastTarget(lowering, node, pass, id, target));
}

/** Adds linked passes. `outputOf` returns the target of the pass that draws the node's output. */
export function drawPasses(
  lowering: Lowering,
  node: FlatNode,
  passes: readonly PartedPass[],
  outputOf: (pass: PartedPass, id: string) => ResourceId | 'screen',
): LoweredPasses {
  // Every uniform param can be set at run time, even if no pass uses it.
  for (const [name, param] of Object.entries(node.definition.params)) if (param.stage === 'uniform') lowering.slots.ofParam(node, name);
  const lowered = { passes, buffers: addBuffers(lowering, node, passes) };
  let before: string | undefined;
  passes.forEach((pass, i) => {
    const id = `${node.id}.pass${i}`;
    const drawsInto = isBuffer(pass.target) ? bufferOf(lowered, pass.target) : outputOf(pass, id);
    // Passes of a node run in order, even if they share no buffers: a persistent buffer may be read before it is drawn.
    addPass(lowering, node, lowered, { pass, id, target: drawsInto, after: before });
    before = id;
  });
  return lowered;
}

/** Draws the last pass again to a texture, because the first time it drew to the screen. */
export function lowerLastPassAgain(lowering: Lowering, node: FlatNode, lowered: LoweredPasses): void {
  const last = lowered.passes.length - 1;
  const pass = lowered.passes[last];
  if (!pass) return;
  const id = `${node.id}.pass${last}.tap`;
  const target = lastTarget(lowering, node, pass, id, 'texture');
  addPass(lowering, node, lowered, { pass, id, target, after: last > 0 ? `${node.id}.pass${last - 1}` : undefined });
}

/** Whether the shader of a node can be linked. The result is cached. */
export function isLinkable(lowering: Lowering, node: FlatNode): boolean {
  if (node.definition.lowering.kind !== 'image') return true;
  const { file, source, vertex, variant } = shaderOf(lowering, node, () => true);
  return lowering.shaders.link(file, source, vertex, variant).output !== null;
}

export function linkPasses(lowering: Lowering, node: FlatNode): readonly PartedPass[] {
  // Linked as if every layer had depth, so that the samplers show whether the shader reads it.
  const asking = shaderOf(lowering, node, () => true);
  const link = lowering.shaders.link(asking.file, asking.source, asking.vertex, asking.variant);
  const { output } = link;
  takeLink(lowering, node, link);
  if (output === null) {
    const broken = layerOutput(node);
    if (broken) lowering.resourceOf.set(portKey(broken), portKey(broken));
    return [];
  }
  const asked = new Set(
    output.flatMap(({ samplers }) => samplers.flatMap(({ source }) => (source.kind === 'input-depth' ? [source.input] : []))),
  );
  const missing = [...asked].filter((port) => !hasDepth(lowering, node, port));
  if (missing.length === 0) return output;
  if (!hasRoom(node)) for (const port of missing) warnOfMissingDepth(lowering, node, port);
  return lowering.shaders.link(asking.file, asking.source, asking.vertex, { ...asking.variant, withoutDepth: missing }).output ?? [];
}

/** Whether room depth is connected to a node. Filters that read depth use it for layers without depth. */
function hasRoom(node: FlatNode): boolean {
  return Object.entries(node.definition.inputs).some(([port, { type }]) => type === 'depth' && sourcesAt(node, port).length > 0);
}

function warnOfMissingDepth({ diagnostics }: Lowering, node: FlatNode, port: string): void {
  const [source] = sourcesAt(node, port);
  const message = `${node.id} reads the depth of ${source ? portKey(source) : port}, which has none.`;
  const fix = 'Connect a layer with depth: scenes have depth, and filters that move no pixels keep it.';
  diagnostics.push({ code: 'SCR043', severity: 'warning', nodeId: node.id, port, message, fix });
}

function addBuffers(lowering: Lowering, node: FlatNode, passes: readonly PartedPass[]): Map<string, ResourceId> {
  const buffers = new Map<string, ResourceId>();
  const domain = domainOf(lowering, node);
  for (const { target } of passes) {
    if (!isBuffer(target) || buffers.has(target.name)) continue;
    const id = `${node.id}.${target.name}`;
    const resource = addResource(lowering, {
      // A buffer may have the name of an output.
      id: Object.hasOwn(node.definition.outputs, target.name) ? `${id}.buffer` : id,
      kind: 'target',
      domain,
      size: sizeOf(lowering, node, target.width, target.height),
      format: target.format,
      depth: 'none',
      samples: 1,
      lifetime: target.persistent ? 'persistent' : 'frame',
    });
    buffers.set(target.name, resource);
  }
  return buffers;
}

function bufferOf({ buffers }: LoweredPasses, { name }: { readonly name: string }): ResourceId {
  const resource = buffers.get(name);
  if (resource === undefined) throw new Error(`There is no buffer ${name}.`);
  return resource;
}

function lastTarget(
  lowering: Lowering,
  node: FlatNode,
  pass: PartedPass,
  writer: string,
  target: 'screen' | 'texture',
): ResourceId | 'screen' {
  const output = layerOutput(node);
  if (target === 'screen' || !output) return 'screen';
  const key = portKey(output);
  addResource(lowering, {
    id: key,
    kind: 'target',
    domain: domainOf(lowering, node),
    size: sizeOf(lowering, node, null, null),
    format: pass.target.format,
    depth: 'none',
    samples: 1,
    lifetime: 'frame',
  });
  lowering.resourceOf.set(key, key);
  lowering.writerOf.set(key, writer);
  return key;
}

interface PassRequest {
  readonly pass: PartedPass;
  readonly id: string;
  readonly target: ResourceId | 'screen';
  readonly after: string | undefined;
}

function addPass(lowering: Lowering, node: FlatNode, { buffers }: LoweredPasses, { pass, id, target, after }: PassRequest): void {
  const { samplers, reads } = passSamplers(lowering, node, pass, buffers, (layer) => depthAt(lowering, layer));
  const uniforms = passUniforms(lowering, node, pass);
  const pulses = uniforms.flatMap(({ source }) => ('pulses' in source ? source.pulses : []));
  const { lowering: kind } = node.definition;
  const operation: ScheduledPass = {
    id,
    node: node.id,
    kind: 'pass',
    view: domainOf(lowering, node) === 'image' ? 'once' : 'each',
    reads: [...reads, ...pulses],
    writes: target === 'screen' ? [] : [target],
    shader: pass.shader,
    parts: pass.parts,
    target,
    blend: target === 'screen' ? 'over' : 'replace',
    samplers,
    uniforms,
    passIndex: pass.passIndex,
    ...(kind.kind === 'image' && { access: kind.access }),
  };
  addStep(lowering, operation, [after, ...valueSteps(lowering, node)]);
}

function domainOf({ layers }: Lowering, node: FlatNode): 'view' | 'image' {
  const output = layerOutput(node);
  return (output && layers.get(portKey(output))?.domain) ?? 'view';
}
