import { Matrix4, Raycaster, Vector3 } from 'three';
import type { Room, RoomPlane } from '../rooms/room.ts';

export interface RayHit {
  readonly distanceM: number;
  readonly pointWorld: Vector3;
  /** Unit vector on the side of the ray's origin. */
  readonly normalWorld: Vector3;
}

export type HitKind = 'plane' | 'mesh' | 'point';

/** Hits of a ray in the room, nearest first. `plane` tests detected planes; `mesh` and `point` test the solids. */
export function castRay(room: Room, originWorld: Vector3, directionWorld: Vector3, kinds: ReadonlySet<HitKind>): RayHit[] {
  const hits: RayHit[] = [];
  if (kinds.has('mesh') || kinds.has('point')) hits.push(...castAtSolids(room, originWorld, directionWorld));
  if (kinds.has('plane')) {
    for (const plane of room.planes) {
      const hit = castAtPlane(plane, originWorld, directionWorld);
      if (hit) hits.push(hit);
    }
  }
  return hits.sort((a, b) => a.distanceM - b.distanceM);
}

function castAtSolids(room: Room, originWorld: Vector3, directionWorld: Vector3): RayHit[] {
  const raycaster = new Raycaster(originWorld, directionWorld);
  return raycaster.intersectObject(room.solids, true).flatMap(({ distance, point, face, object }) => {
    if (!face) return [];
    const normalWorld = face.normal.clone().transformDirection(object.matrixWorld);
    if (normalWorld.dot(directionWorld) > 0) normalWorld.negate();
    return [{ distanceM: distance, pointWorld: point, normalWorld }];
  });
}

function castAtPlane(plane: RoomPlane, originWorld: Vector3, directionWorld: Vector3): RayHit | null {
  const worldFromPlane = new Matrix4().fromArray([...plane.worldFromPlane]);
  const planeFromWorld = worldFromPlane.clone().invert();
  const origin = originWorld.clone().applyMatrix4(planeFromWorld);
  const direction = directionWorld.clone().transformDirection(planeFromWorld);
  const distanceM = -origin.y / direction.y;
  if (!Number.isFinite(distanceM) || distanceM <= 0) return null;
  const at = origin.addScaledVector(direction, distanceM);
  if (!isInside(at.x, at.z, plane.polygonXZ)) return null;
  const normalWorld = new Vector3(0, 1, 0).transformDirection(worldFromPlane);
  if (normalWorld.dot(directionWorld) > 0) normalWorld.negate();
  return { distanceM, pointWorld: at.applyMatrix4(worldFromPlane), normalWorld };
}

/** Whether a point is inside a polygon, by the even–odd rule. */
export function isInside(x: number, z: number, polygon: readonly (readonly [number, number])[]): boolean {
  let inside = false;
  polygon.forEach(([ax, az], i) => {
    const [bx, bz] = polygon[(i + 1) % polygon.length] ?? [ax, az];
    if (az > z !== bz > z && x < ax + ((z - az) / (bz - az)) * (bx - ax)) inside = !inside;
  });
  return inside;
}
