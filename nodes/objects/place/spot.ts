import { Matrix4, type Quaternion, Vector3 } from 'three';
import type { AnchorService } from '../../kit/anchors.ts';
import { createPlacement, type Placement } from './placement.ts';

/** One of the copies: where it stands, if it is placed. */
export interface Spot {
  /** From 0; the same copy has the same index as long as the node runs. */
  readonly index: number;
  readonly placement: Placement;
  isPlaced: boolean;
  /** Rigid, with the twist. */
  readonly worldFromPose: Matrix4;
  /** With the scale. */
  readonly worldFromPlaced: Matrix4;
}

/** What a spot was at some time. */
export interface SpotState {
  readonly spot: Spot;
  readonly isPlaced: boolean;
  readonly positionM: Vector3;
  readonly rotation: Quaternion;
  readonly turnRad: number;
  readonly scale: number;
}

// Filled and read within one call.
const scratchScale = new Vector3();

export function createSpot(index: number, anchors: () => AnchorService): Spot {
  return { index, placement: createPlacement(anchors), isPlaced: false, worldFromPose: new Matrix4(), worldFromPlaced: new Matrix4() };
}

/** Updates the matrices of a spot. */
export function writeSpot({ placement, worldFromPose, worldFromPlaced }: Spot, snapRad: number, gridM: number): void {
  placement.writePose(worldFromPose, snapRad, gridM);
  worldFromPlaced.copy(worldFromPose).scale(scratchScale.setScalar(placement.scale));
}

/** Ends the placement of a spot, which stands as before the first tap. */
export function vacate({ placement }: Spot): void {
  placement.release();
  placement.turnRad = 0;
  placement.scale = 1;
}

export function stateOf(spot: Spot): SpotState {
  const { positionM, rotation, turnRad, scale } = spot.placement;
  return { spot, isPlaced: spot.isPlaced, positionM: positionM.clone(), rotation: rotation.clone(), turnRad, scale };
}

/** Sets the pose back; the caller sets `isPlaced` and the anchor. */
export function restorePose({ spot, positionM, rotation, turnRad, scale }: SpotState): void {
  spot.placement.positionM.copy(positionM);
  spot.placement.rotation.copy(rotation);
  spot.placement.turnRad = turnRad;
  spot.placement.scale = scale;
}
