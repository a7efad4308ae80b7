import type { CaptureMesh } from '../../nodes/kit/capture.ts';

/** Height of the camera above the floor: eyes of a person who stands, meters. */
export const DOME_EYE_M = 1.6;
/** Distance from the camera to the dome, meters. */
export const DOME_RADIUS_M = 8;

const COLUMNS = 96;
/** Rings from below the camera to where the floor meets the dome, and from there to the top. */
const FLOOR_RINGS = 16;
const DOME_RINGS = 32;

/**
 * The mesh of a place of which one 360° photograph is all that is known: a level floor below the camera, and a dome around it. What stands on
 * the floor stands at its true distance, if the camera was as high as `DOME_EYE_M`; what is far away is too near. The same proxy as that of
 * `GroundedSkybox` in three.js.
 *
 * @returns In meters, with the camera at the origin and +y up. Its triangles are counter-clockwise as the camera sees them.
 */
export function makeDomeMesh(): CaptureMesh {
  const edgeM = Math.sqrt(DOME_RADIUS_M ** 2 - DOME_EYE_M ** 2);
  const least = -Math.asin(DOME_EYE_M / DOME_RADIUS_M);
  const floor = Array.from({ length: FLOOR_RINGS }, (_, i) => [(edgeM * (i + 1)) / FLOOR_RINGS, -DOME_EYE_M] as const);
  const dome = Array.from({ length: DOME_RINGS - 1 }, (_, i) => {
    const elevation = least + ((Math.PI / 2 - least) * (i + 1)) / DOME_RINGS;
    return [DOME_RADIUS_M * Math.cos(elevation), DOME_RADIUS_M * Math.sin(elevation)] as const;
  });
  const rings = [...floor, ...dome];
  const around = rings.flatMap(([radiusM, heightM]) =>
    Array.from({ length: COLUMNS }, (_, column) => {
      const turn = (2 * Math.PI * column) / COLUMNS;
      return [radiusM * Math.sin(turn), heightM, -radiusM * Math.cos(turn)];
    }),
  );
  const positions = [[0, -DOME_EYE_M, 0], ...around, [0, DOME_RADIUS_M, 0]];
  const at = (ring: number, column: number) => 1 + ring * COLUMNS + (column % COLUMNS);
  const top = positions.length - 1;
  const indices: number[] = [];
  for (let column = 0; column < COLUMNS; column++) {
    indices.push(0, at(0, column + 1), at(0, column));
    for (let ring = 0; ring + 1 < rings.length; ring++) {
      const [near, beside, above, diagonal] = [at(ring, column), at(ring, column + 1), at(ring + 1, column), at(ring + 1, column + 1)];
      indices.push(near, beside, above, above, beside, diagonal);
    }
    indices.push(at(rings.length - 1, column), at(rings.length - 1, column + 1), top);
  }
  return { positions: Float32Array.from(positions.flat()), indices: Uint32Array.from(indices) };
}
