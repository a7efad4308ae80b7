import { CylinderGeometry, DoubleSide, Mesh, MeshBasicMaterial, Quaternion, Vector3 } from 'three';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { SessionFrame } from '../../kit/session.ts';
import { setMaterialColor } from '../../kit/three/material-color.ts';
import { createMeshItem } from '../../kit/three/mesh-item.ts';
import type { definition } from './definition.ts';
import { createRibbon } from './ribbon.ts';

/** A shorter line counts as none, because it has no direction. */
const LEAST_M = 1e-6;

// Filled and read within one call.
const start = new Vector3();
const end = new Vector3();
const along = new Vector3();
const scale = new Vector3();
const rotation = new Quaternion();
const UP = new Vector3(0, 1, 0);

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { widthM, widthPx, color, castShadow } = ctx.params;
  const ribbon = ctx.config.widthIn === 'pixels' ? createRibbon() : null;
  const { objects } = ctx.outputs;
  const geometry = ribbon?.geometry ?? new CylinderGeometry(0.5, 0.5, 1, 12);
  const material = new MeshBasicMaterial(ribbon ? { side: DoubleSide } : {});
  const mesh = new Mesh(geometry, material);
  const item = createMeshItem('line', mesh);

  function show(shown: boolean): void {
    if (objects.items.length > 0 === shown) return;
    objects.items.length = 0;
    if (shown) objects.items.push(item);
    objects.version++;
  }

  /** Writes the line from pose to pose; returns false if there is none. */
  function lay(frame: SessionFrame): boolean {
    const { from, to } = ctx.inputs;
    if (!from?.valid || !to?.valid) return false;
    start.fromArray(from.worldFromPose, 12);
    end.fromArray(to.worldFromPose, 12);
    const lengthM = along.subVectors(end, start).length();
    if (lengthM < LEAST_M) return false;
    if (ribbon) return widthPx.value > 0 && ribbon.lay(from.worldFromPose, to.worldFromPose, widthPx.value, frame);
    if (widthM.value <= 0) return false;
    rotation.setFromUnitVectors(UP, along.divideScalar(lengthM));
    item.worldFromObject.compose(start.add(end).multiplyScalar(0.5), rotation, scale.set(widthM.value, lengthM, widthM.value));
    return true;
  }

  return {
    update: (frame) => {
      setMaterialColor(material, color.value);
      item.castsShadow = castShadow.value && !ribbon;
      show(lay(frame));
    },
    dispose: () => {
      geometry.dispose();
      material.dispose();
    },
  };
}
