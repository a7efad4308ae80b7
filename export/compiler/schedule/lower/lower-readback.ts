import type { ReadbackOperation, ResourceId } from '../../../program/program.ts';
import { type FlatNode, portKey, type Source } from '../../flat-graph.ts';
import { addResource, addStep, type Lowering, resourceAt } from './lowering.ts';
import { passUniforms } from './pass-parts.ts';

/** Size of the reduced image. Its 19,200 pixels are read in a fraction of a millisecond, and a hand covers hundreds of them. */
const WIDTH_PX = 160;
const HEIGHT_PX = 120;

const REDUCE_FILE = 'scrim/reduce.fs';

/** Each pixel is the mean of 4 × 4 samples, which interpolate: together they read all pixels of a layer of up to 1280 × 960. */
const REDUCE_SOURCE = `/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Reduces a layer to a small image.",
  "SCRIM_ALPHA": "premultiplied",
  "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }]
}*/

void main() {
  vec4 sum = vec4(0.0);
  for (int y = 0; y < 4; y++) {
    for (int x = 0; x < 4; x++) {
      vec2 offset = (vec2(float(x), float(y)) - 1.5) / 4.0;
      sum += IMG_NORM_PIXEL(inputImage, isf_FragNormCoord + offset / RENDERSIZE);
    }
  }
  gl_FragColor = sum / 16.0;
}
`;

/**
 * Lowers an input whose pixels a node reads on the CPU (ADR 46) to a pass that reduces the layer, and the operation that reads the result
 * back after it is drawn.
 *
 * @returns The resource of the pixels, which contain an earlier frame until the operation runs: the node does not wait for it.
 */
export function lowerReadback(lowering: Lowering, node: FlatNode, port: string, layer: Source): ResourceId {
  const domain = lowering.layers.get(portKey(layer))?.domain ?? 'view';
  const view = domain === 'image' ? 'once' : 'each';
  const id = `${node.id}.${port}`;
  const picture = addResource(lowering, {
    id: `${id}.picture`,
    kind: 'target',
    domain,
    size: { base: 'view', width: [WIDTH_PX], height: [HEIGHT_PX] },
    format: 'rgba8',
    depth: 'none',
    samples: 1,
    lifetime: 'frame',
  });
  const pixels = addResource(lowering, { id: `${id}.pixels`, kind: 'pixels' });
  lowering.writerOf.set(picture, picture);
  const variant = { loopBudget: false, absent: [], withoutDepth: [], scene: false };
  const [pass] = lowering.shaders.link(REDUCE_FILE, REDUCE_SOURCE, null, variant).output ?? [];
  const [sampler] = pass?.samplers ?? [];
  if (!pass || !sampler) throw new Error('The shader that reduces layers cannot be linked.');
  const resource = resourceAt(lowering, layer);
  addStep(lowering, {
    id: picture,
    node: node.id,
    kind: 'pass',
    view,
    reads: [resource],
    writes: [picture],
    shader: pass.shader,
    parts: pass.parts,
    target: picture,
    blend: 'replace',
    samplers: [{ name: sampler.name, source: { kind: 'color', resource }, fit: 'none' }],
    uniforms: passUniforms(lowering, node, pass),
    passIndex: pass.passIndex,
    access: 'resize',
  });
  const operation: ReadbackOperation = {
    id: `${id}.readback`,
    node: node.id,
    kind: 'readback',
    view,
    reads: [picture],
    writes: [pixels],
    picture,
    pixels,
  };
  addStep(lowering, operation);
  return pixels;
}
