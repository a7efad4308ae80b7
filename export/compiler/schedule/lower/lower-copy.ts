import { portKey, type Source } from '../../flat-graph.ts';
import type { ScheduledPass } from '../scheduled.ts';
import { addStep, type Lowering, resourceAt } from './lowering.ts';
import type { Fit } from './pass-parts.ts';

/** Name of the shader that copies a layer unchanged, for layers that no other pass draws to the screen. */
const COPY_FILE = 'scrim/copy.fs';

const COPY_SOURCE = `/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Shows a layer as it is.",
  "SCRIM_ALPHA": "premultiplied",
  "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }]
}*/

void main() {
  gl_FragColor = IMG_THIS_PIXEL(inputImage);
}
`;

/** Copies an image over the content of the screen; `id` is the id of the operation. */
export function lowerCopyToScreen(lowering: Lowering, id: string, layer: Source, fit: Fit): void {
  const isImage = lowering.layers.get(portKey(layer))?.domain === 'image';
  const copy = copyOf(lowering, layer, isImage ? fit : 'none');
  addStep(lowering, { ...copy, id, node: layer.node, view: 'each', writes: [], target: 'screen', blend: 'over' });
}

/** Creates a pass that copies a layer; the caller adds the target. */
export function copyOf(
  lowering: Lowering,
  layer: Source,
  fit: Fit | 'none',
): Omit<ScheduledPass, 'id' | 'node' | 'view' | 'writes' | 'target' | 'blend'> {
  const variant = { loopBudget: false, absent: [], withoutDepth: [], scene: false };
  const [pass] = lowering.shaders.link(COPY_FILE, COPY_SOURCE, null, variant).output ?? [];
  const [sampler] = pass?.samplers ?? [];
  if (!pass || !sampler) throw new Error('The shader that copies cannot be linked.');
  const resource = resourceAt(lowering, layer);
  return {
    kind: 'pass',
    reads: [resource],
    shader: pass.shader,
    parts: pass.parts,
    samplers: [{ name: sampler.name, source: { kind: 'color', resource }, fit }],
    uniforms: [],
    passIndex: pass.passIndex,
    access: 'pointwise',
    copies: true,
  };
}
