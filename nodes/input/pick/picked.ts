import type { Object3D } from 'three';
import type { SessionFrame } from '../../kit/session.ts';
import { setSurfacePose } from '../../kit/surface-pose.ts';
import type { ObjectHit } from './cast-objects.ts';

/** What a ray has met, in a form that may be kept after the frame. The object is reused. */
export interface Picked {
  isMet: boolean;
  /** Id of the pointer whose ray it was; 0 for other rays. */
  pointer: number;
  /** Index of the object list, which is that of its wire. */
  wire: number;
  key: string;
  part: string;
  copy: number;
  distanceM: number;
  /** The `claimant` of the object (`ObjectItem.claimant`). */
  claimant: object | undefined;
  /** The pose of the point that was met: column-major 4×4, rigid; y is the normal of the surface. */
  readonly worldFromPoint: Float32Array;
}

export function createPicked(): Picked {
  const worldFromPoint = Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
  return { isMet: false, pointer: 0, wire: 0, key: '', part: '', copy: 0, distanceM: 0, claimant: undefined, worldFromPoint };
}

export function copyPicked(to: Picked, from: Picked): void {
  to.isMet = from.isMet;
  to.pointer = from.pointer;
  to.wire = from.wire;
  to.key = from.key;
  to.part = from.part;
  to.copy = from.copy;
  to.distanceM = from.distanceM;
  to.claimant = from.claimant;
  to.worldFromPoint.set(from.worldFromPoint);
}

export function isSameObject(a: Picked, b: Picked): boolean {
  return a.isMet === b.isMet && a.wire === b.wire && a.key === b.key && a.copy === b.copy;
}

/** Copies the result of casting a ray to `out`. Does nothing if the ray has met no object. */
export function writePicked(out: Picked, hit: ObjectHit, worldFromRay: ArrayLike<number>, pointer: number, frame: SessionFrame): void {
  const { item, normal, distanceM } = hit;
  if (!item) return;
  const at = (i: number): number => worldFromRay[i] ?? 0;
  const view = frame.viewCount > 0 ? frame.views[0]?.worldFromView : null;
  out.isMet = true;
  out.pointer = pointer;
  out.wire = hit.list;
  out.key = item.key;
  out.part = partOf(hit.mesh, item.root);
  out.copy = hit.copy;
  out.distanceM = distanceM;
  out.claimant = item.claimant;
  setSurfacePose(
    out.worldFromPoint,
    at(12) - at(8) * distanceM,
    at(13) - at(9) * distanceM,
    at(14) - at(10) * distanceM,
    normal.x,
    normal.y,
    normal.z,
    at(12),
    at(13),
    at(14),
    view?.[12] ?? at(12),
    view?.[14] ?? at(14),
  );
}

/** The name of the mesh, or of its nearest named parent within the object; empty if none has a name. */
function partOf(mesh: Object3D | null, root: Object3D): string {
  for (let object = mesh; object; object = object === root ? null : object.parent) if (object.name !== '') return object.name;
  return '';
}
