import { Mesh, MeshBasicMaterial, MeshStandardMaterial, Quaternion, Vector3 } from 'three';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { SessionFrame, ViewFrame } from '../../kit/session.ts';
import { setMaterialColor } from '../../kit/three/material-color.ts';
import { createMeshItem } from '../../kit/three/mesh-item.ts';
import { createArrowGeometry, createArrowShape, setArrowShape } from './arrow-geometry.ts';
import type { definition } from './definition.ts';

/** A shorter arrow counts as none, because it has no direction. */
const LEAST_M = 1e-6;
const ROUGHNESS = 0.6;

// Filled and read within one call.
const start = new Vector3();
const end = new Vector3();
const along = new Vector3();
const neck = new Vector3();
const rotation = new Quaternion();
const ONE = new Vector3(1, 1, 1);
const UP = new Vector3(0, 1, 0);

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { lengthM, widthM, widthOfView, headWidth, headLength, color, castShadow } = ctx.params;
  const { direction, widthIn, shaded } = ctx.config;
  const { objects } = ctx.outputs;
  const geometry = createArrowGeometry();
  const material = shaded ? new MeshStandardMaterial({ roughness: ROUGHNESS }) : new MeshBasicMaterial();
  const mesh = new Mesh(geometry, material);
  const item = createMeshItem('arrow', mesh, { receivesShadow: shaded });
  const shape = createArrowShape();
  const drawn = createArrowShape();

  function show(shown: boolean): void {
    if (objects.items.length > 0 === shown) return;
    objects.items.length = 0;
    if (shown) objects.items.push(item);
    objects.version++;
  }

  /** Writes `start`, `end` and `along`; returns false if there is no arrow. */
  function findEnds(): boolean {
    const { from, to } = ctx.inputs;
    if (!from?.valid || (to && !to.valid)) return false;
    const matrix = from.worldFromPose;
    start.fromArray(matrix, 12);
    if (to) {
      along.subVectors(end.fromArray(to.worldFromPose, 12), start);
    } else {
      along.fromArray(matrix, direction === 'up' ? 4 : 8).multiplyScalar(direction === 'up' ? lengthM.value : -lengthM.value);
      end.addVectors(start, along);
    }
    return along.lengthSq() > LEAST_M ** 2;
  }

  /** Diameter of the shaft at a point in world space, meters. */
  function widthAt(point: Vector3, view: ViewFrame | undefined): number {
    return widthIn === 'world' ? widthM.value : view ? widthOfView.value * viewHeightM(point, view) : 0;
  }

  /** Sets the pose and the shape of the arrow; returns false if there is none. */
  function lay({ views }: SessionFrame): boolean {
    if (!findEnds()) return false;
    const [view] = views;
    const length = along.length();
    const tipWidthM = widthAt(end, view);
    shape.lengthM = length;
    shape.headLengthM = Math.min(length, headLength.value * tipWidthM);
    // The head of a short arrow keeps its angle.
    const full = headLength.value * tipWidthM;
    shape.headRadiusM = (0.5 * headWidth.value * tipWidthM * shape.headLengthM) / (full || 1);
    neck.copy(end).addScaledVector(along, -shape.headLengthM / length);
    shape.neckRadiusM = Math.min(shape.headRadiusM, 0.5 * widthAt(neck, view));
    shape.startRadiusM = Math.min(0.5 * widthAt(start, view), shape.headLengthM < length ? Number.POSITIVE_INFINITY : shape.neckRadiusM);
    if (shape.headRadiusM <= 0 && shape.startRadiusM <= 0) return false;
    rotation.setFromUnitVectors(UP, along.divideScalar(length));
    item.worldFromObject.compose(start, rotation, ONE);
    return true;
  }

  function shapeChanged(): boolean {
    let changed = false;
    for (const name of SIZES) {
      changed ||= shape[name] !== drawn[name];
      drawn[name] = shape[name];
    }
    return changed;
  }

  return {
    update: (frame) => {
      setMaterialColor(material, color.value);
      item.castsShadow = castShadow.value;
      const shown = lay(frame);
      if (shown && shapeChanged()) setArrowShape(geometry, shape);
      show(shown);
    },
    dispose: () => {
      geometry.dispose();
      material.dispose();
    },
  };
}

const SIZES = ['lengthM', 'headLengthM', 'startRadiusM', 'neckRadiusM', 'headRadiusM'] as const;

/** Height that the view covers at the depth of a point, meters. */
function viewHeightM({ x, y, z }: Vector3, { viewFromWorld: m, clipFromView, nearM }: ViewFrame): number {
  const depthM = -((m[2] ?? 0) * x + (m[6] ?? 0) * y + (m[10] ?? 0) * z + (m[14] ?? 0));
  return (2 * Math.max(nearM, depthM)) / (clipFromView[5] || 1);
}
