import { createHit, type HitSource } from '../../kit/hit-test.ts';
import type { SessionService } from '../../kit/runtime.ts';

/** How far away the room is in the directions of lamps. */
export interface RoomDistances {
  /**
   * @param index The lamp, by which distances are kept.
   * @returns Meters; null where the ray meets nothing, or the room is not asked.
   */
  along(index: number, fromWorld: ArrayLike<number>, towardsWorld: ArrayLike<number>): number | null;
}

/** Surfaces that were measured; an assumed floor is none. */
const SOURCES: readonly HitSource[] = ['mesh', 'plane', 'depth'];
/** Lamps do not move, and rooms are scanned slowly: a ray is cast once in so many frames. */
const FRAMES_BETWEEN = 30;

export function createRoomDistances(session: SessionService, isAsked: boolean): RoomDistances {
  const hit = createHit();
  const worldFromRay = new Float32Array(16);
  const known: { distanceM: number | null; frames: number; readonly at: Float32Array }[] = [];
  return {
    along: (index, from, towards) => {
      if (!isAsked) return null;
      const entry = known[index] ?? { distanceM: null, frames: 0, at: new Float32Array(6) };
      known[index] = entry;
      let hasMoved = false;
      for (let c = 0; c < 3; c++) {
        const [origin, way] = [Math.fround(from[c] ?? 0), Math.fround(towards[c] ?? 0)];
        hasMoved ||= entry.at[c] !== origin || entry.at[c + 3] !== way;
        entry.at[c] = origin;
        entry.at[c + 3] = way;
      }
      if (hasMoved) entry.distanceM = null;
      if (!hasMoved && entry.frames-- > 0) return entry.distanceM;
      entry.frames = FRAMES_BETWEEN;
      writeRay(worldFromRay, from, towards);
      // A hit that is lost, as by a hand in front of the sensor, keeps its place.
      if (session.castRay(worldFromRay, hit, SOURCES)) entry.distanceM = hit.distanceM;
      return entry.distanceM;
    },
  };
}

/** A rigid matrix with the origin of the ray, whose -z axis is its direction. */
function writeRay(into: Float32Array, from: ArrayLike<number>, towards: ArrayLike<number>): void {
  const [x = 0, y = 0, z = 0] = [towards[0], towards[1], towards[2]];
  // Any axis across the ray: that across y, or across x for a ray straight up.
  const isUpright = Math.abs(y) > 0.999;
  const [rightX, rightY, rightZ] = isUpright ? [0, z, -y] : [-z, 0, x];
  const length = Math.hypot(rightX, rightY, rightZ);
  const right = [rightX / length, rightY / length, rightZ / length] as const;
  // back × right, with back = -towards.
  into.set([right[0], right[1], right[2], 0]);
  into.set([-y * right[2] + z * right[1], -z * right[0] + x * right[2], -x * right[1] + y * right[0], 0], 4);
  into.set([-x, -y, -z, 0], 8);
  into.set([from[0] ?? 0, from[1] ?? 0, from[2] ?? 0, 1], 12);
}
