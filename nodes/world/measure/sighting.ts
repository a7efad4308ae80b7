import type { Anchor, AnchorService } from '../../kit/anchors.ts';
import type { Hit } from '../../kit/hit-test.ts';
import type { PoseView } from '../../kit/pose.ts';
import { createSeenPoint, type PointNoise, type SeenPoint, setNoise } from './propagate.ts';

/** A measured point, and the place from which it was seen. */
export interface Sighting {
  readonly point: SeenPoint;
  /** Positions of the viewer and of the point when the point was seen; the line of sight is between them. */
  readonly eyeM: Float64Array;
  readonly seenAtM: Float64Array;
  isSeen: boolean;
  jumps: number;
  /** The anchor that holds a tapped point; null for other points. */
  anchor: Anchor | null;
}

export function createSighting(): Sighting {
  return { point: createSeenPoint(), eyeM: new Float64Array(3), seenAtM: new Float64Array(3), isSeen: false, jumps: 0, anchor: null };
}

/**
 * Sets the point to a pose. Returns false while the pose is not valid.
 *
 * @param moveM A point that has moved by less than this keeps its line of sight.
 */
export function look(sighting: Sighting, pose: PoseView | null, eyeM: Float64Array, moveM: number, noise: PointNoise): boolean {
  if (!pose?.valid) {
    sighting.isSeen = false;
    return false;
  }
  const { positionM } = sighting.point;
  for (let i = 0; i < 3; i++) positionM[i] = pose.worldFromPose[12 + i] ?? 0;
  if (!sighting.isSeen || sighting.jumps !== pose.jumps || squaredDistance(positionM, sighting.seenAtM) >= moveM ** 2) {
    sighting.eyeM.set(eyeM);
    sighting.seenAtM.set(positionM);
  }
  sighting.isSeen = true;
  sighting.jumps = pose.jumps;
  setNoise(sighting.point, sighting.eyeM, noise);
  return true;
}

/** Sets the point to a hit or a pose that is seen from `eyeM`, and creates an anchor for it. The caller deletes the anchor. */
export function mark(sighting: Sighting, at: Hit | ArrayLike<number>, eyeM: Float64Array, anchors: AnchorService): void {
  const matrix = 'worldFromHit' in at ? at.worldFromHit : at;
  for (let i = 0; i < 3; i++) sighting.seenAtM[i] = matrix[12 + i] ?? 0;
  sighting.point.positionM.set(sighting.seenAtM);
  sighting.eyeM.set(eyeM);
  sighting.anchor?.delete();
  sighting.anchor = anchors.create(at);
}

/** Moves a tapped point with its anchor, and its line of sight with it. */
export function followAnchor({ point, eyeM, seenAtM, anchor }: Sighting, noise: PointNoise): void {
  if (!anchor) return;
  for (let i = 0; i < 3; i++) {
    const movedM = (anchor.worldFromAnchor[12 + i] ?? 0) - (seenAtM[i] ?? 0);
    seenAtM[i] = (seenAtM[i] ?? 0) + movedM;
    eyeM[i] = (eyeM[i] ?? 0) + movedM;
  }
  point.positionM.set(seenAtM);
  setNoise(point, eyeM, noise);
}

function squaredDistance(p: Float64Array, q: Float64Array): number {
  return ((p[0] ?? 0) - (q[0] ?? 0)) ** 2 + ((p[1] ?? 0) - (q[1] ?? 0)) ** 2 + ((p[2] ?? 0) - (q[2] ?? 0)) ** 2;
}
