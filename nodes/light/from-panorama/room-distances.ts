import { createHit, type HitSource } from '../../kit/hit-test.ts';
import type { SessionService } from '../../kit/runtime.ts';

/** Measures how far away the room is in the directions of lamps. */
export interface RoomDistances {
  /**
   * Measures the distance to the room along a direction.
   *
   * @param index The lamp; its last distance is kept between measurements.
   * @returns Meters; null if the ray meets nothing, or if the node does not measure the room.
   */
  along(index: number, fromWorld: ArrayLike<number>, towardsWorld: ArrayLike<number>): number | null;
}

/** The sources whose hits count: measured surfaces, not an assumed floor. */
const SOURCES: readonly HitSource[] = ['mesh', 'plane', 'depth'];
/** The number of frames between two rays for the same lamp. Lamps do not move, and a room is scanned slowly. */
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

/** Writes a rigid matrix for a ray: its origin is the ray's, its -z axis the ray's direction. */
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
