import { cosineDirections, createSolidScene, type Meeting, type Solid, type SolidScene, type Triple } from './solid.ts';

/** Light from outside: a bright rectangle in a wall, and sunlight through it. */
export interface Daylight {
  readonly window: { readonly center: Triple; readonly heightM: number; readonly widthM: number; readonly normal: Triple };
  /** Linear-sRGB radiance of the window. */
  readonly sky: Triple;
  /** Direction towards the sun, and irradiance on a surface that faces it. */
  readonly sunDirection: Triple;
  readonly sun: Triple;
}

/**
 * Computes the light that falls on points of surfaces.
 *
 * @param positions Three numbers per point, world space.
 * @param normals Unit vectors.
 * @returns Irradiance divided by π, linear-sRGB.
 */
export type LightBaker = (positions: ArrayLike<number>, normals: ArrayLike<number>) => Float32Array;

const WINDOW_SAMPLES = [5, 3] as const;
const PATCH_RAYS = 48;
const VERTEX_RAYS = 36;
const BOUNCES = 4;
const PATCH_M = 0.45;
/** Offset from the surface, in meters, so that a point does not shade itself. */
const LIFT_M = 0.012;

/**
 * Creates a function that computes the indirect light at points: radiosity over the faces of boxes that approximate the furniture, then one
 * final gather per vertex (Cohen and Wallace, “Radiosity and Realistic Image Synthesis”, ch. 4 and 10.3). Direct sunlight is excluded: a
 * shadow map renders its hard edges better. About 0.3 s for 10,000 points.
 */
export function createLightBaker(solids: readonly Solid[], daylight: Daylight): LightBaker {
  const scene = createSolidScene(solids);
  const patches = solvePatches(scene, daylight);
  const gather = createGather(scene, patches, cosineDirections(VERTEX_RAYS));
  return (positions, normals) => bake(scene, daylight, patches.sunlit, gather, positions, normals);
}

function bake(
  scene: SolidScene,
  daylight: Daylight,
  sunlit: readonly SunlitPatch[],
  gather: ReturnType<typeof createGather>,
  positions: ArrayLike<number>,
  normals: ArrayLike<number>,
): Float32Array {
  const out = new Float32Array(positions.length);
  const sum = new Float64Array(3);
  for (let i = 0; i < positions.length; i += 3) {
    const [nx, ny, nz] = [normals[i] ?? 0, normals[i + 1] ?? 0, normals[i + 2] ?? 0];
    const [x, y, z] = [(positions[i] ?? 0) + nx * LIFT_M, (positions[i + 1] ?? 0) + ny * LIFT_M, (positions[i + 2] ?? 0) + nz * LIFT_M];
    sum.fill(0);
    gather(x, y, z, nx, ny, nz, sum);
    addSky(scene, daylight, x, y, z, nx, ny, nz, sum);
    addSunlit(scene, sunlit, x, y, z, nx, ny, nz, sum);
    for (let c = 0; c < 3; c++) out[i + c] = (sum[c] ?? 0) / Math.PI;
  }
  return out;
}

/** Patches of the solids' faces with their radiosity. */
interface Patches {
  /** Index of the patch at a point of a solid's face. */
  at(solid: number, face: number, x: number, y: number, z: number): number;
  readonly count: number;
  /** Three numbers per patch. */
  readonly centers: number[];
  readonly normals: number[];
  readonly albedo: number[];
  readonly areas: number[];
  /** Radiosity divided by π, without the first reflection of sunlight, which `sunlit` contributes. */
  radiance: Float64Array;
  /** Patches in sunlight. They are few and bright, so random rays that hit them would leave spots. */
  sunlit: readonly SunlitPatch[];
}

interface SunlitPatch {
  readonly center: Triple;
  readonly normal: Triple;
  readonly areaM2: number;
  readonly radiance: Triple;
}

function solvePatches(scene: SolidScene, daylight: Daylight): Patches {
  const patches = cutPatches(scene.solids);
  const direct = new Float64Array(patches.count * 3);
  const fromSun = new Float64Array(patches.count * 3);
  const sum = new Float64Array(3);
  for (let i = 0; i < patches.count * 3; i += 3) {
    const [x, y, z, nx, ny, nz] = pointOf(patches, i);
    sum.fill(0);
    addSky(scene, daylight, x, y, z, nx, ny, nz, sum);
    direct.set(sum, i);
    sum.fill(0);
    addSun(scene, daylight, x, y, z, nx, ny, nz, sum);
    fromSun.set(sum, i);
  }
  patches.sunlit = findSunlit(patches, reflect(patches, fromSun));
  for (let i = 0; i < patches.count * 3; i += 3) {
    const [x, y, z, nx, ny, nz] = pointOf(patches, i);
    sum.set(direct.subarray(i, i + 3));
    addSunlit(scene, patches.sunlit, x, y, z, nx, ny, nz, sum);
    direct.set(sum, i);
  }
  const met = meetings(scene, patches);
  let radiance = reflect(patches, direct);
  for (let bounce = 0; bounce < BOUNCES; bounce++) {
    const irradiance = Float64Array.from(direct);
    for (let patch = 0; patch < patches.count; patch++) {
      for (let ray = 0; ray < PATCH_RAYS; ray++) {
        const other = (met[patch * PATCH_RAYS + ray] ?? 0) * 3;
        for (let c = 0; c < 3; c++)
          irradiance[patch * 3 + c] = (irradiance[patch * 3 + c] ?? 0) + ((radiance[other + c] ?? 0) * Math.PI) / PATCH_RAYS;
      }
    }
    radiance = reflect(patches, irradiance);
  }
  patches.radiance = radiance;
  return patches;
}

function findSunlit({ centers, normals, areas, count }: Patches, radiance: Float64Array): SunlitPatch[] {
  const triple = (values: ArrayLike<number>, i: number): Triple => [values[i] ?? 0, values[i + 1] ?? 0, values[i + 2] ?? 0];
  const lit = Array.from({ length: count }, (_, patch) => patch).filter((patch) => (radiance[patch * 3] ?? 0) > 0);
  return lit.map((patch) => ({
    center: triple(centers, patch * 3),
    normal: triple(normals, patch * 3),
    areaM2: areas[patch] ?? 0,
    radiance: triple(radiance, patch * 3),
  }));
}

/** Adds light from sunlit patches, each treated as a point light at its center. */
function addSunlit(
  scene: SolidScene,
  sunlit: readonly SunlitPatch[],
  x: number,
  y: number,
  z: number,
  nx: number,
  ny: number,
  nz: number,
  sum: Float64Array,
): void {
  for (const { center, normal, areaM2, radiance } of sunlit) {
    const vx = center[0] + normal[0] * LIFT_M - x;
    const vy = center[1] + normal[1] * LIFT_M - y;
    const vz = center[2] + normal[2] * LIFT_M - z;
    const distance = Math.hypot(vx, vy, vz);
    const here = (nx * vx + ny * vy + nz * vz) / distance;
    const there = -(normal[0] * vx + normal[1] * vy + normal[2] * vz) / distance;
    if (!(here > 0 && there > 0)) continue;
    if (scene.blocked(x, y, z, vx / distance, vy / distance, vz / distance, distance - LIFT_M)) continue;
    const weight = (here * there * areaM2) / Math.max(distance * distance, areaM2);
    for (let c = 0; c < 3; c++) sum[c] = (sum[c] ?? 0) + (radiance[c] ?? 0) * weight;
  }
}

function reflect(patches: Patches, irradiance: Float64Array): Float64Array {
  return irradiance.map((value, i) => (value * (patches.albedo[i] ?? 0)) / Math.PI);
}

function pointOf({ centers, normals }: Patches, i: number): readonly [number, number, number, number, number, number] {
  const [nx, ny, nz] = [normals[i] ?? 0, normals[i + 1] ?? 0, normals[i + 2] ?? 0];
  return [(centers[i] ?? 0) + nx * LIFT_M, (centers[i + 1] ?? 0) + ny * LIFT_M, (centers[i + 2] ?? 0) + nz * LIFT_M, nx, ny, nz];
}

/** Finds the patch that each ray of each patch hits. The result is the same for every bounce, so it is computed once. */
function meetings(scene: SolidScene, patches: Patches): Uint16Array {
  const directions = cosineDirections(PATCH_RAYS);
  const out = new Uint16Array(patches.count * PATCH_RAYS);
  const meeting: Meeting = { distanceM: 0, solid: 0, face: 0 };
  for (let patch = 0; patch < patches.count; patch++) {
    const [x, y, z, nx, ny, nz] = pointOf(patches, patch * 3);
    const turn = frameOf(nx, ny, nz);
    directions.forEach((local, ray) => {
      const [dx, dy, dz] = turn(local);
      scene.cast(x, y, z, dx, dy, dz, meeting);
      const d = meeting.distanceM;
      out[patch * PATCH_RAYS + ray] = patches.at(meeting.solid, meeting.face, x + dx * d, y + dy * d, z + dz * d);
    });
  }
  return out;
}

function createGather(scene: SolidScene, patches: Patches, directions: readonly Triple[]) {
  const meeting: Meeting = { distanceM: 0, solid: 0, face: 0 };
  return (x: number, y: number, z: number, nx: number, ny: number, nz: number, sum: Float64Array): void => {
    const turn = frameOf(nx, ny, nz);
    for (const local of directions) {
      const [dx, dy, dz] = turn(local);
      scene.cast(x, y, z, dx, dy, dz, meeting);
      const d = meeting.distanceM;
      const patch = patches.at(meeting.solid, meeting.face, x + dx * d, y + dy * d, z + dz * d) * 3;
      for (let c = 0; c < 3; c++) sum[c] = (sum[c] ?? 0) + ((patches.radiance[patch + c] ?? 0) * Math.PI) / directions.length;
    }
  };
}

/** Adds area light of the window, sampled at fixed points. */
function addSky(
  scene: SolidScene,
  { window, sky }: Daylight,
  x: number,
  y: number,
  z: number,
  nx: number,
  ny: number,
  nz: number,
  sum: Float64Array,
): void {
  const [columns, rows] = WINDOW_SAMPLES;
  const area = (window.heightM * window.widthM) / (columns * rows);
  for (let i = 0; i < columns * rows; i++) {
    const s = ((i % columns) + 0.5) / columns - 0.5;
    const t = (Math.floor(i / columns) + 0.5) / rows - 0.5;
    // The window is in the y–z plane.
    const [vx, vy, vz] = [window.center[0] - x, window.center[1] + t * window.heightM - y, window.center[2] + s * window.widthM - z];
    const distance = Math.hypot(vx, vy, vz);
    const [dx, dy, dz] = [vx / distance, vy / distance, vz / distance];
    const here = nx * dx + ny * dy + nz * dz;
    const there = -(window.normal[0] * dx + window.normal[1] * dy + window.normal[2] * dz);
    if (here <= 0 || there <= 0 || scene.blocked(x, y, z, dx, dy, dz, distance - 0.12)) continue;
    // The lower limit of the squared distance avoids spots beside the window, which the few samples would cause.
    const weight = (here * there * area) / Math.max(distance * distance, 0.08);
    for (let c = 0; c < 3; c++) sum[c] = (sum[c] ?? 0) + (sky[c] ?? 0) * weight;
  }
}

function addSun(
  scene: SolidScene,
  { window, sunDirection, sun }: Daylight,
  x: number,
  y: number,
  z: number,
  nx: number,
  ny: number,
  nz: number,
  sum: Float64Array,
): void {
  const [dx, dy, dz] = sunDirection;
  const here = nx * dx + ny * dy + nz * dz;
  const distance = (window.center[0] - x) / dx;
  if (here <= 0 || distance <= 0) return;
  const off = [y + dy * distance - window.center[1], z + dz * distance - window.center[2]] as const;
  if (Math.abs(off[0]) > window.heightM / 2 || Math.abs(off[1]) > window.widthM / 2) return;
  if (scene.blocked(x, y, z, dx, dy, dz, distance - 0.12)) return;
  for (let c = 0; c < 3; c++) sum[c] = (sum[c] ?? 0) + (sun[c] ?? 0) * here;
}

/** An orthonormal frame around a normal (Duff et al., "Building an Orthonormal Basis, Revisited", 2017). */
function frameOf(nx: number, ny: number, nz: number): (local: Triple) => Triple {
  const sign = nz >= 0 ? 1 : -1;
  const a = -1 / (sign + nz);
  const b = nx * ny * a;
  const t: Triple = [1 + sign * nx * nx * a, sign * b, -sign * nx];
  const s: Triple = [b, sign + ny * ny * a, -ny];
  return ([x, y, z]) => [t[0] * x + s[0] * y + nx * z, t[1] * x + s[1] * y + ny * z, t[2] * x + s[2] * y + nz * z];
}

function cutPatches(solids: readonly Solid[]): Patches {
  const centers: number[] = [];
  const normals: number[] = [];
  const albedo: number[] = [];
  const areas: number[] = [];
  /** First patch, columns and rows per face. */
  const faces: (readonly [number, number, number])[] = [];
  solids.forEach((solid, index) => {
    for (let face = 0; face < 6; face++) {
      const axis = face >> 1;
      const [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
      const side = face % 2 === 0 ? -1 : 1;
      const [columns, rows] = [a, b].map((k) => Math.max(1, Math.round((2 * (solid.half[k] ?? 0)) / PATCH_M))) as [number, number];
      faces.push([centers.length / 3, columns, rows]);
      for (let j = 0; j < rows; j++) {
        for (let i = 0; i < columns; i++) {
          const local = [0, 0, 0];
          local[axis] = side * (solid.half[axis] ?? 0);
          local[a] = (solid.half[a] ?? 0) * ((2 * (i + 0.5)) / columns - 1);
          local[b] = (solid.half[b] ?? 0) * ((2 * (j + 0.5)) / rows - 1);
          const normal = [0, 0, 0];
          // The shell is seen from inside.
          normal[axis] = index === 0 ? -side : side;
          centers.push(...toWorld(solid, local, true));
          normals.push(...toWorld(solid, normal, false));
          albedo.push(...solid.albedo);
          areas.push((4 * (solid.half[a] ?? 0) * (solid.half[b] ?? 0)) / (columns * rows));
        }
      }
    }
  });
  return {
    count: centers.length / 3,
    centers,
    normals,
    albedo,
    areas,
    sunlit: [],
    radiance: new Float64Array(centers.length),
    at: (solidIndex, face, x, y, z) => {
      const solid = solids[solidIndex];
      const [first, columns, rows] = faces[solidIndex * 6 + face] ?? [0, 1, 1];
      if (!solid) return first;
      const axis = face >> 1;
      const local = toLocal(solid, x, y, z);
      const cell = (k: number, cells: number): number => {
        const t = ((local[k] ?? 0) / (solid.half[k] || 1) + 1) / 2;
        return Math.min(Math.max(Math.floor(t * cells), 0), cells - 1);
      };
      return first + cell((axis + 2) % 3, rows) * columns + cell((axis + 1) % 3, columns);
    },
  };
}

function toWorld({ center, yawRad }: Solid, [x = 0, y = 0, z = 0]: readonly number[], isPoint: boolean): number[] {
  const [sin, cos] = [Math.sin(yawRad), Math.cos(yawRad)];
  const move = isPoint ? center : [0, 0, 0];
  return [x * cos + z * sin + (move[0] ?? 0), y + (move[1] ?? 0), -x * sin + z * cos + (move[2] ?? 0)];
}

function toLocal({ center, yawRad }: Solid, x: number, y: number, z: number): number[] {
  const [sin, cos] = [Math.sin(yawRad), Math.cos(yawRad)];
  const [px, pz] = [x - center[0], z - center[2]];
  return [px * cos - pz * sin, y - center[1], px * sin + pz * cos];
}
