import { Euler, Matrix4, Quaternion, Vector3 } from 'three';
import { deriveObjects } from '../../kit/derive-objects.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

// Filled and read within one call.
const scratchPosition = new Vector3();
const scratchAngles = new Vector3();
const scratchEuler = new Euler(0, 0, 0, 'YXZ');
const scratchQuaternion = new Quaternion();
const scratchScale = new Vector3();

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { positionM, rotationRad, scale } = ctx.params;
  const newFromOld = new Matrix4();
  const derived = deriveObjects(ctx.outputs.objects, (item) => {
    item.worldFromObject.premultiply(newFromOld);
  });
  return {
    version: 0,
    update: () => {
      scratchEuler.setFromVector3(scratchAngles.fromArray(rotationRad.value));
      newFromOld.compose(
        scratchPosition.fromArray(positionM.value),
        scratchQuaternion.setFromEuler(scratchEuler),
        scratchScale.setScalar(scale.value),
      );
      derived.update(ctx.inputs.objects);
    },
    dispose: () => {},
  };
}
