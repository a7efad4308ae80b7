import { Matrix4, Quaternion, Vector3 } from 'three';
import type { Anchor, AnchorService } from '../../kit/anchors.ts';
import type { Hit } from '../../kit/hit-test.ts';
import type { SessionFrame } from '../../kit/session.ts';

/**
 * Where a copy of the objects stands: a rigid pose on a surface, held by an anchor, with the rotation and scale that the visitor has added.
 */
export interface Placement {
  /** Position of the copy, meters, world space. */
  readonly positionM: Vector3;
  /** Axes of the surface at the tap; drags tilt them with the surface. */
  readonly rotation: Quaternion;
  /** Rotation about the normal that the visitor has added, radians, counterclockwise seen from its tip. */
  turnRad: number;
  scale: number;
  /** Copies the pose of the anchor. Call it once per frame. */
  follow(): void;
  /** Takes the position and the axes of a hit. */
  stand(hit: Hit): void;
  /** Moves to a point of a surface, and tilts with its normal; the heading stays. */
  slide(pointM: Vector3, normal: Vector3): void;
  /**
   * Moves the current pose to the grid and creates an anchor there. `hit` is the one that the pose comes from; the device can anchor it if
   * the pose has not changed since.
   *
   * @param gridM Spacing of the grid; 0: none.
   */
  fasten(frame: SessionFrame, gridM: number, hit?: Hit): void;
  /** Deletes the anchor. */
  release(): void;
  /** Places the copy in another session: relative to the viewer of this frame as it was relative to the viewer at the last `fasten`. */
  recall(frame: SessionFrame): void;
  /** Writes the rigid pose with the visitor's rotation. Without an anchor, as during a drag, the pose is on the grid. */
  writePose(out: Matrix4, snapRad: number, gridM: number): void;
}

const UP = new Vector3(0, 1, 0);
const ONE = new Vector3(1, 1, 1);
/** Cosine of the angle below which two normals count as equal, so that rounding errors do not add up over a drag. */
const SAME_NORMAL = 1 - 1e-6;

// Filled and read within one call.
const scratchMatrix = new Matrix4();
const scratchLevel = new Matrix4();
const scratchNormal = new Vector3();
const scratchScale = new Vector3();
const scratchQuaternion = new Quaternion();
const scratchPoint = new Vector3();
const scratchAcross = new Vector3();
const scratchAlong = new Vector3();

export function createPlacement(anchors: () => AnchorService): Placement {
  const positionM = new Vector3();
  const rotation = new Quaternion();
  const levelFromBase = new Matrix4();
  let anchor: Anchor | null = null;

  function release(): void {
    anchor?.delete();
    anchor = null;
  }
  const placement: Placement = {
    positionM,
    rotation,
    turnRad: 0,
    scale: 1,
    follow: () => {
      if (anchor) scratchMatrix.fromArray(anchor.worldFromAnchor).decompose(positionM, rotation, scratchScale);
    },
    stand: ({ worldFromHit }) => {
      scratchMatrix.fromArray(worldFromHit).decompose(positionM, rotation, scratchScale);
      positionM.y = Math.max(0, positionM.y);
    },
    slide: (pointM, normal) => {
      positionM.copy(pointM);
      positionM.y = Math.max(0, positionM.y);
      scratchNormal.copy(UP).applyQuaternion(rotation);
      if (scratchNormal.dot(normal) > SAME_NORMAL) return;
      rotation.premultiply(scratchQuaternion.setFromUnitVectors(scratchNormal, normal)).normalize();
    },
    fasten: (frame, gridM, hit) => {
      release();
      if (gridM > 0) snapToGrid(positionM, rotation, gridM);
      scratchMatrix.compose(positionM, rotation, ONE);
      writeLevelViewer(scratchLevel, frame);
      levelFromBase.copy(scratchLevel).invert().multiply(scratchMatrix);
      // A hit below the floor was raised to it, one beside the grid moved.
      const isUnchanged = hit !== undefined && gridM === 0 && (hit.worldFromHit[13] ?? 0) >= 0;
      anchor = anchors().create(isUnchanged ? hit : scratchMatrix.elements);
    },
    release,
    recall: (frame) => {
      release();
      writeLevelViewer(scratchLevel, frame);
      scratchMatrix.multiplyMatrices(scratchLevel, levelFromBase).decompose(positionM, rotation, scratchScale);
    },
    writePose: (out, snapRad, gridM) => {
      const turnRad = snapRad > 0 ? Math.round(placement.turnRad / snapRad) * snapRad : placement.turnRad;
      scratchPoint.copy(positionM);
      if (anchor === null && gridM > 0) snapToGrid(scratchPoint, rotation, gridM);
      out.compose(scratchPoint, scratchQuaternion.setFromAxisAngle(UP, turnRad).premultiply(rotation), ONE);
    },
  };
  return placement;
}

/**
 * Moves a point along its surface to the nearest point of a grid with the axes of world space: x and z on floors; the horizontal and
 * the steepest direction on others. The grid goes through the projection of the origin.
 */
function snapToGrid(pointM: Vector3, rotation: Quaternion, gridM: number): void {
  scratchNormal.copy(UP).applyQuaternion(rotation);
  scratchAcross.crossVectors(UP, scratchNormal);
  // On a level surface every direction is horizontal: x.
  if (scratchAcross.length() < 0.05) scratchAcross.set(1, 0, 0).addScaledVector(scratchNormal, -scratchNormal.x);
  scratchAcross.normalize();
  scratchAlong.crossVectors(scratchNormal, scratchAcross);
  const acrossM = pointM.dot(scratchAcross);
  const alongM = pointM.dot(scratchAlong);
  pointM.addScaledVector(scratchAcross, Math.round(acrossM / gridM) * gridM - acrossM);
  pointM.addScaledVector(scratchAlong, Math.round(alongM / gridM) * gridM - alongM);
  pointM.y = Math.max(0, pointM.y);
}

/** Writes a level frame for the viewer: on the floor at y = 0 below the viewer, with -z ahead. */
function writeLevelViewer(out: Matrix4, { views }: SessionFrame): void {
  const m = views[0]?.worldFromView;
  const at = (i: number): number => m?.[i] ?? 0;
  let aheadX = -at(8);
  let aheadZ = -at(10);
  // Straight down or up: ahead is where the top of the view points to, or away from it.
  if (Math.hypot(aheadX, aheadZ) < 1e-3) {
    const side = at(9) > 0 ? 1 : -1;
    aheadX = side * at(4);
    aheadZ = side * at(6);
  }
  out.makeRotationY(Math.atan2(-aheadX, -aheadZ)).setPosition(at(12), 0, at(14));
}
