import { Matrix4, Vector3 } from 'three';
import { aimZ } from '../../kit/rigid.ts';
import type { SessionFrame, ViewFrame } from '../../kit/session.ts';
import { writeViewerPosition } from '../../kit/viewer.ts';
import type { ScreenBox } from './board.ts';
import { FONT_PX } from './layout.ts';

/** A shorter leader line is not drawn. */
const LEAST_LEADER_M = 0.001;
/** Thickness of the leader line, label pixels. */
const LEADER_PX = 3;

/** Where a label and its leader line are in the world. */
export interface LabelPose {
  /** The pose of the label's center: column-major, rigid; x to the right, y up, z toward the reader. */
  readonly worldFromLabel: Matrix4;
  readonly metersPerPx: number;
  readonly widthM: number;
  readonly heightM: number;
  /** Distance from the viewer to the center. */
  readonly distanceM: number;
  /** The ends of the leader line, and its thickness; 0 where there is none. */
  readonly leaderFrom: Vector3;
  readonly leaderTo: Vector3;
  readonly leaderM: number;
  /**
   * Computes the pose of the label for a frame.
   *
   * @param size Font size: meters, or a part of the height of the view.
   * @param box Receives the rectangle that the label covers on the screen of the first view.
   * @returns False if it is not seen: outside of the view, too near, from behind or without a size.
   */
  set(
    worldFromPose: Float32Array,
    frame: SessionFrame,
    widthPx: number,
    heightPx: number,
    size: number,
    liftM: number,
    box: ScreenBox,
  ): boolean;
  /** Moves the label up on the screen by a fraction of the height of the view. */
  moveUp(part: number): void;
  /** Writes the ray from the viewer to the center of the label, column-major, rigid. */
  writeRay(worldFromRay: Float32Array): void;
}

// Filled and read within one call.
const eyeM = new Float64Array(3);
const eye = new Vector3();
const corner = new Vector3();
const cameraUp = new Vector3();

export function createLabelPose(facing: 'viewer' | 'surface' | 'pose', sizeIn: 'room' | 'screen'): LabelPose {
  const turned = new Float32Array(16);
  const worldFromLabel = new Matrix4();
  const middle = new Vector3();
  const right = new Vector3();
  const up = new Vector3();
  const normal = new Vector3();
  const seenFrom = new Vector3();
  let view: ViewFrame | null = null;

  const pose = {
    worldFromLabel,
    metersPerPx: 0,
    widthM: 0,
    heightM: 0,
    distanceM: 0,
    leaderFrom: new Vector3(),
    leaderTo: new Vector3(),
    leaderM: 0,
    set: (...[worldFromPose, frame, widthPx, heightPx, size, liftM, box]: Parameters<LabelPose['set']>): boolean => {
      view = frame.views[0] ?? null;
      if (!view || !writeViewerPosition(eyeM, frame)) return false;
      seenFrom.fromArray(eyeM);
      pose.leaderFrom.fromArray(worldFromPose, 12);
      findAxes(worldFromPose);
      const scale = sizeIn === 'room' ? size : size * viewHeightM(pose.leaderFrom, view);
      pose.metersPerPx = scale / FONT_PX;
      pose.widthM = widthPx * pose.metersPerPx;
      pose.heightM = heightPx * pose.metersPerPx;
      // A label that faces the viewer stands on its lift; others have their middle there.
      if (facing === 'viewer') middle.copy(pose.leaderFrom).setY(pose.leaderFrom.y + liftM);
      else middle.copy(pose.leaderFrom).addScaledVector(normal, liftM);
      pose.leaderTo.copy(middle);
      if (facing === 'viewer') middle.addScaledVector(up, pose.heightM / 2);
      write();
      if (!(pose.heightM > 0) || corner.subVectors(seenFrom, middle).dot(normal) <= 0) return false;
      return findBox(box, view);
    },
    moveUp: (part: number): void => {
      if (!view || part === 0) return;
      const m = view.worldFromView;
      cameraUp.set(m[4] ?? 0, m[5] ?? 0, m[6] ?? 0).multiplyScalar(part * viewHeightM(middle, view));
      middle.add(cameraUp);
      pose.leaderTo.add(cameraUp);
      write();
    },
    writeRay: (worldFromRay: Float32Array): void => {
      worldFromLabel.toArray(worldFromRay);
      aimZ(worldFromRay, seenFrom.x - middle.x, seenFrom.y - middle.y, seenFrom.z - middle.z);
      seenFrom.toArray(worldFromRay, 12);
    },
  };

  function findAxes(worldFromPose: Float32Array): void {
    turned.set(worldFromPose);
    if (facing === 'viewer') aimZ(turned, seenFrom.x - (turned[12] ?? 0), seenFrom.y - (turned[13] ?? 0), seenFrom.z - (turned[14] ?? 0));
    right.fromArray(turned, 0);
    // On surfaces y is the normal, and z points down the wall or to who reads it on the floor (docs/CONVENTIONS.md, “Poses”).
    if (facing === 'surface') up.fromArray(turned, 8).negate();
    else up.fromArray(turned, 4);
    normal.fromArray(turned, facing === 'surface' ? 4 : 8);
  }

  function write(): void {
    worldFromLabel.makeBasis(right, up, normal).setPosition(middle);
    pose.distanceM = seenFrom.distanceTo(middle);
    pose.leaderM = pose.leaderFrom.distanceTo(pose.leaderTo) > LEAST_LEADER_M ? LEADER_PX * pose.metersPerPx : 0;
  }

  function findBox(box: ScreenBox, { viewFromWorld, clipFromView, nearM }: ViewFrame): boolean {
    box.left = box.bottom = Number.POSITIVE_INFINITY;
    box.right = box.top = Number.NEGATIVE_INFINITY;
    const aspect = (clipFromView[5] ?? 1) / (clipFromView[0] || 1);
    for (let i = 0; i < 4; i++) {
      corner
        .copy(middle)
        .addScaledVector(right, i % 2 === 0 ? -pose.widthM / 2 : pose.widthM / 2)
        .addScaledVector(up, i < 2 ? -pose.heightM / 2 : pose.heightM / 2);
      toView(corner, viewFromWorld);
      if (-corner.z < nearM) return false;
      // Half of the normalized device coordinates: from -0.5 to 0.5 over the height of the view.
      const x = (0.5 * aspect * ((clipFromView[0] ?? 0) * corner.x + (clipFromView[8] ?? 0) * corner.z)) / -corner.z;
      const y = (0.5 * ((clipFromView[5] ?? 0) * corner.y + (clipFromView[9] ?? 0) * corner.z)) / -corner.z;
      box.left = Math.min(box.left, x);
      box.right = Math.max(box.right, x);
      box.bottom = Math.min(box.bottom, y);
      box.top = Math.max(box.top, y);
    }
    const side = 0.5 * aspect;
    return box.left < side && box.right > -side && box.bottom < 0.5 && box.top > -0.5;
  }
  return pose;
}

/** Height that the view covers at the depth of a point, meters. */
export function viewHeightM(point: Vector3, { viewFromWorld, clipFromView, nearM }: ViewFrame): number {
  const depthM = -toView(eye.copy(point), viewFromWorld).z;
  return (2 * Math.max(nearM, depthM)) / (clipFromView[5] || 1);
}

function toView(point: Vector3, m: Float32Array): Vector3 {
  const { x, y, z } = point;
  return point.set(
    (m[0] ?? 0) * x + (m[4] ?? 0) * y + (m[8] ?? 0) * z + (m[12] ?? 0),
    (m[1] ?? 0) * x + (m[5] ?? 0) * y + (m[9] ?? 0) * z + (m[13] ?? 0),
    (m[2] ?? 0) * x + (m[6] ?? 0) * y + (m[10] ?? 0) * z + (m[14] ?? 0),
  );
}
