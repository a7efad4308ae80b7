import type { CpuOperation, Resource, ResourceId } from '../../../program/program.ts';
import { type FlatNode, portKey } from '../../flat-graph.ts';
import { layerInputs, layerOutput } from '../layers.ts';
import { copyOf } from './lower-copy.ts';
import { nodeOperation } from './lower-node.ts';
import { addResource, addStep, type Lowering, valueSteps } from './lowering.ts';
import { sizeOf } from './pass-parts.ts';

/**
 * Lowers a CPU filter to a copy of its layer, which can be read back for any kind of layer, and the operation that sends it to a worker and
 * draws the result.
 */
export function lowerCpu(lowering: Lowering, node: FlatNode): void {
  const output = layerOutput(node);
  const [layer] = layerInputs(node);
  if (!output || !layer) throw new Error(`${node.id} has to take and to give a layer.`);
  const key = portKey(output);
  const domain = lowering.layers.get(key)?.domain ?? 'view';
  const view = domain === 'image' ? 'once' : 'each';
  const size = sizeOf(lowering, node, null, null);
  const target = (id: string): Resource => ({
    id,
    kind: 'target',
    domain,
    size,
    format: 'rgba8',
    depth: 'none',
    samples: 1,
    lifetime: 'frame',
  });
  const image: ResourceId = addResource(lowering, target(`${node.id}.picture`));
  addResource(lowering, target(key));
  lowering.writerOf.set(image, image);
  lowering.resourceOf.set(key, key);
  lowering.writerOf.set(key, node.id);
  const copy = copyOf(lowering, layer, 'none');
  addStep(lowering, { ...copy, id: image, node: node.id, view, writes: [image], target: image, blend: 'replace' });
  const operation: CpuOperation = {
    ...nodeOperation(lowering, node, node.id, 'cpu'),
    view,
    reads: [image],
    writes: [key],
    outputs: {},
    picture: image,
    target: key,
  };
  addStep(lowering, operation, valueSteps(lowering, node));
}

export function isCpu({ definition }: FlatNode): boolean {
  return definition.lowering.kind === 'cpu';
}
