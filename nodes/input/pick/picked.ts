import type { Object3D } from 'three';
import type { SessionFrame } from '../../kit/session.ts';
import { setSurfacePose } from '../../kit/surface-pose.ts';
import type { ObjectHit } from './cast-objects.ts';

/** What a ray met, kept beyond the frame. Reused. */
export interface Picked {
  isMet: boolean;
  /** Id of the pointer; 0 for other rays. */
  pointer: number;
  /** Index of the list. */
  wire: number;
  key: string;
  part: string;
  copy: number;
  distanceM: number;
  /** `ObjectItem.claimant`. */
  claimant: object | undefined;
  /** Column-major 4×4, rigid; y is the normal. */
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

/** Writes what a ray met. Nothing happens where it met nothing. */
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

/** The name of the mesh or of the nearest parent that has one. */
function partOf(mesh: Object3D | null, root: Object3D): string {
  for (let object = mesh; object; object = object === root ? null : object.parent) if (object.name !== '') return object.name;
  return '';
}
