import { Matrix4, Quaternion, Vector3 } from 'three';
import type { AnchorService } from '../../kit/anchors.ts';
import type { ObjectList } from '../../kit/scene-lists.ts';
import { createPlacement, type Placement } from './placement.ts';

/** One copy of the objects: whether it is placed, and where. */
export interface Spot {
  /** Number of the copy, from 0. It does not change while the node runs. */
  readonly index: number;
  readonly placement: Placement;
  isPlaced: boolean;
  /** Rigid pose of the copy, with the rotation that the visitor has added. */
  readonly worldFromPose: Matrix4;
  /** Matrix of the placed copy, from the places of the objects in the graph: its pose and its scale. */
  readonly worldFromPlaced: Matrix4;
}

/** The state of a spot at one time, for undoing changes. */
export interface SpotState {
  readonly spot: Spot;
  readonly isPlaced: boolean;
  readonly positionM: Vector3;
  readonly rotation: Quaternion;
  readonly turnRad: number;
  readonly scale: number;
}

// Filled and read within one call.
const scratchPosition = new Vector3();
const scratchRotation = new Quaternion();
const scratchScale = new Vector3();
const ONE = new Vector3(1, 1, 1);

export function createSpot(index: number, anchors: () => AnchorService): Spot {
  return { index, placement: createPlacement(anchors), isPlaced: false, worldFromPose: new Matrix4(), worldFromPlaced: new Matrix4() };
}

/**
 * Updates the matrices of a spot.
 *
 * @param originFromGraph The inverse of the pose in the graph that comes to lie on the surface.
 */
export function writeSpot(
  { placement, worldFromPose, worldFromPlaced }: Spot,
  snapRad: number,
  gridM: number,
  originFromGraph: Matrix4,
): void {
  placement.writePose(worldFromPose, snapRad, gridM);
  worldFromPlaced.copy(worldFromPose).scale(scratchScale.setScalar(placement.scale)).multiply(originFromGraph);
}

/** Writes the inverse of the pose of the first object, without its scale. */
export function writeOrigin(out: Matrix4, inputs: readonly ObjectList[]): void {
  const first = inputs[0]?.items[0];
  if (!first) return;
  first.worldFromObject.decompose(scratchPosition, scratchRotation, scratchScale);
  out.compose(scratchPosition, scratchRotation, ONE).invert();
}

/** Resets a spot that is no longer placed: no anchor, no added rotation, scale 1. */
export function vacate({ placement }: Spot): void {
  placement.release();
  placement.turnRad = 0;
  placement.scale = 1;
}

export function stateOf(spot: Spot): SpotState {
  const { positionM, rotation, turnRad, scale } = spot.placement;
  return { spot, isPlaced: spot.isPlaced, positionM: positionM.clone(), rotation: rotation.clone(), turnRad, scale };
}

/** Sets the pose of a spot back to a stored state. The caller sets `isPlaced` and creates the anchor. */
export function restorePose({ spot, positionM, rotation, turnRad, scale }: SpotState): void {
  spot.placement.positionM.copy(positionM);
  spot.placement.rotation.copy(rotation);
  spot.placement.turnRad = turnRad;
  spot.placement.scale = scale;
}
