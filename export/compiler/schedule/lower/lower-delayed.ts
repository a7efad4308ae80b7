import { type FlatNode, portKey } from '../../flat-graph.ts';
import { layerOutput } from '../layers.ts';
import { drawPasses, linkPasses } from './lower-passes.ts';
import { addResource, type Lowering } from './lowering.ts';
import { sizeOf } from './pass-parts.ts';

/** Whether this is an image node that outputs its result of the previous frame. */
export function isDelayed({ definition: { lowering, delay } }: FlatNode): boolean {
  return lowering.kind === 'image' && delay === true;
}

/**
 * Adds the texture of a delayed node before its inputs are lowered, because they may depend on it. No operation waits for it: it keeps its
 * content until the end of the frame (`captures` in `order.ts`), separately for each view.
 */
export function lowerDelayed(lowering: Lowering, node: FlatNode): void {
  const output = layerOutput(node);
  if (!output || node.definition.outputs[output.port]?.domain !== 'view') throw new Error(`${node.id} has to give a layer of the view.`);
  const id = portKey(output);
  addResource(lowering, {
    id,
    kind: 'target',
    domain: 'view',
    size: sizeOf(lowering, node, null, null),
    format: 'rgba8',
    depth: 'none',
    samples: 1,
    lifetime: 'persistent',
  });
  lowering.resourceOf.set(id, id);
  lowering.delayed.push(node);
}

/** Draws the content of delayed nodes for the next frame, after all other nodes are lowered. */
export function lowerCaptures(lowering: Lowering): void {
  for (const node of lowering.delayed.splice(0)) {
    const output = layerOutput(node);
    if (output) drawPasses(lowering, node, linkPasses(lowering, node), () => portKey(output));
  }
}
