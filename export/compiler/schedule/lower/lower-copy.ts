import { portKey, type Source } from '../../flat-graph.ts';
import { COPY_FILE, COPY_SOURCE } from '../../shaders/copy-shader.ts';
import type { Fit } from '../fit.ts';
import { addStep, type Lowering, resourceAt } from './lowering.ts';

/** Lays a picture over what is on the screen; `id` names the operation. */
export function lowerCopyToScreen(lowering: Lowering, id: string, layer: Source, fit: Fit): void {
  const variant = { loopBudget: false, absent: [], withoutDepth: [] };
  const [pass] = lowering.shaders.link(COPY_FILE, COPY_SOURCE, null, variant).output ?? [];
  const [sampler] = pass?.samplers ?? [];
  if (!pass || !sampler) throw new Error('The shader that copies cannot be linked.');
  const resource = resourceAt(lowering, layer);
  const isImage = lowering.layers.get(portKey(layer))?.domain === 'image';
  addStep(lowering, {
    id,
    node: layer.node,
    kind: 'pass',
    view: 'each',
    reads: [resource],
    writes: [],
    shader: pass.shader,
    target: 'screen',
    blend: 'over',
    samplers: [{ name: sampler.name, source: { kind: 'color', resource }, fit: isImage ? fit : 'none' }],
    uniforms: [],
    passIndex: pass.passIndex,
    access: 'pointwise',
  });
}
