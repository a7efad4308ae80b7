import { Vector3 } from 'three';
import { addDepthNoise, type DepthNoise } from '../../../export/emulator/depth/depth-noise.ts';
import type { DepthFrame, VoxelSettings } from '../../../nodes/kit/physics.ts';
import { createVoxelGrid } from '../../../nodes/physics/world/voxel-grid.ts';
import { crossesSurface, nearestIn, pointAt, pointsOf, readDepthSession } from './depth-session.ts';
import { ball, createLab } from './lab.ts';

const SETTINGS: VoxelSettings = { edgeM: 0.05, threshold: 0.5, speed: 0.2, farM: 5 };
const FRAMES = 30;

export interface EqualToRays {
  readonly equal: number;
  readonly count: number;
}

/** Visits the voxels along a ray, up to a part of it (Amanatides and Woo, “A Fast Voxel Traversal Algorithm for Ray Tracing”, 1987). */
function traverse(from: Vector3, to: Vector3, most: number, edgeM: number, visit: (x: number, y: number, z: number) => void): void {
  // Numbers instead of arrays: this runs for millions of voxels.
  let [x, y, z] = [Math.floor(from.x / edgeM), Math.floor(from.y / edgeM), Math.floor(from.z / edgeM)];
  const [signX, signY, signZ] = [Math.sign(to.x), Math.sign(to.y), Math.sign(to.z)];
  const [strideX, strideY, strideZ] = [edgeM / Math.abs(to.x), edgeM / Math.abs(to.y), edgeM / Math.abs(to.z)];
  const first = (cell: number, at: number, sign: number, stride: number) => (cell + (sign > 0 ? 1 : 0) - at / edgeM) * sign * stride;
  let nextX = first(x, from.x, signX, strideX);
  let nextY = first(y, from.y, signY, strideY);
  let nextZ = first(z, from.z, signZ, strideZ);
  for (let s = 0; s < most; ) {
    visit(x, y, z);
    if (nextX < nextY && nextX < nextZ) {
      s = nextX;
      x += signX;
      nextX += strideX;
    } else if (nextY < nextZ) {
      s = nextY;
      y += signY;
      nextY += strideY;
    } else {
      s = nextZ;
      z += signZ;
      nextZ += strideZ;
    }
  }
}

/** The part of all voxels that have the same occupancy as by ray traversal, after so many frames. */
function equalToRays(frames: readonly DepthFrame[]): EqualToRays {
  const grid = createVoxelGrid(SETTINGS);
  const { edgeM: e } = SETTINGS;
  const weights = new Map<number, number>();
  // Voxels repeat after 12.8 m, which is more than a room.
  const keyOf = (x: number, y: number, z: number) => ((x & 255) << 16) | ((y & 255) << 8) | (z & 255);
  /** The number of the last frame with a ray through the voxel. */
  const passed = new Uint8Array(2 ** 24);
  let frameNumber = 0;
  const at = (p: Vector3) => keyOf(Math.floor(p.x / e), Math.floor(p.y / e), Math.floor(p.z / e));
  for (const frame of frames) {
    grid.update(frame);
    // Each ray frees the voxels before its end, but for the last edge, and occupies that of its end.
    const hit = new Set<number>();
    frameNumber++;
    const eye = new Vector3().fromArray([...(frame.worldFromDepth as number[])], 12);
    for (let n = 0; n < frame.widthPx * frame.heightPx; n++) {
      const d = frame.meters[n] ?? 0;
      if (d <= 0 || d >= SETTINGS.farM) continue;
      const end = pointAt(frame, n);
      hit.add(at(end));
      traverse(eye, end.sub(eye), 1 - e / d, e, (x, y, z) => {
        passed[keyOf(x, y, z)] = frameNumber;
      });
    }
    for (const key of hit) weights.set(key, (weights.get(key) ?? 0) * 0.8 + 0.2);
    for (const [key, weight] of weights) if (passed[key] === frameNumber && !hit.has(key)) weights.set(key, weight * 0.8);
  }
  const occupied = new Set<number>();
  grid.forEachOccupied((x, y, z) => occupied.add(keyOf(x, y, z)));
  const keys = new Set([...weights.keys(), ...occupied]);
  const equal = [...keys].filter((key) => occupied.has(key) === (weights.get(key) ?? 0) >= 0.5).length;
  return { equal: equal / keys.size, count: keys.size };
}

/** The noise of the emulated headset. */
const NOISE: DepthNoise = { sigmaM: 0.01, sigmaPerM: 0.005, holes: 0.05, seed: 3 };
const RADIUS_M = 0.04;
const BALLS = 100;
/** Balls fall 30 cm inside the area that the last frame shows. */
const INSIDE = 3;

export interface Rain {
  readonly isSmooth: boolean;
  readonly isNoisy: boolean;
  readonly seconds: number;
  /** From the surface that was measured. */
  readonly nearM: number;
}

export interface Rained {
  readonly throughCount: number;
  /** Balls that were slower than 1 cm/s for a second, near the surface. */
  readonly restedCount: number;
  /** Those of them that are still there at the end. */
  readonly keptCount: number;
  readonly lostCount: number;
}

/** What the tool prints. */
export interface RealRoom {
  readonly rays: EqualToRays;
  readonly rained: readonly Rained[];
}

/** What a session shows, and where balls may fall. */
interface Scan {
  readonly frames: readonly DepthFrame[];
  readonly last: DepthFrame;
  distanceTo(p: Vector3): number;
  crosses(from: Vector3, to: Vector3): boolean;
  /** Where the ball of a number begins: 30 cm above the highest point around, in the area that the last frame shows. */
  placeOf(index: number): [number, number, number];
}

function scan(frames: readonly DepthFrame[]): Scan {
  const last = frames.at(-1);
  if (!last) throw new Error('There are no frames.');
  // Columns of 10 cm that the last frame shows, with their highest point.
  const seen = pointsOf(last);
  const cell = (v: number) => Math.floor(v / 0.1);
  const columnOf = (x: number, z: number) => 1e4 * cell(x) + cell(z);
  const columns = new Map<number, number>();
  for (const { x, y, z } of seen) columns.set(columnOf(x, z), Math.max(columns.get(columnOf(x, z)) ?? -9, y));
  const inside = new Set([...columns.keys()].filter((key) => isInside(columns, key)));
  const inner = seen.filter(({ x, z }) => inside.has(columnOf(x, z)));
  return {
    frames,
    last,
    distanceTo: nearestIn(frames.flatMap(pointsOf), 0.1),
    crosses: crossesSurface(last),
    placeOf: (index) => {
      const { x, z } = inner[Math.floor(((index * 0.618034) % 1) * inner.length)] ?? new Vector3();
      return [x, (columns.get(columnOf(x, z)) ?? 0) + 0.3, z];
    },
  };
}

function isInside(columns: ReadonlyMap<number, number>, key: number): boolean {
  for (let i = -INSIDE; i <= INSIDE; i++) for (let j = -INSIDE; j <= INSIDE; j++) if (!columns.has(key + 1e4 * i + j)) return false;
  return true;
}

/** Lets balls rain on the room that a session shows, while its last frame is held. */
function rain({ frames, last, distanceTo, crosses, placeOf }: Scan, { isSmooth, isNoisy, seconds, nearM }: Rain): Rained {
  const lab = createLab({ sleep: true });
  lab.engine.apply({ kind: 'room', room: { ...SETTINGS, isSmooth }, friction: 0.6, restitution: 0.1 });
  // A frame that is held says the same at 5 Hz as at 30; noise differs, so a noisy sensor has its usual 15 Hz.
  const everyFrames = isNoisy ? 4 : 12;
  let shot = 0;
  const see = (frame: DepthFrame, deltaS = 1 / 30) => {
    const meters = isNoisy ? Float32Array.from(frame.meters) : frame.meters;
    if (isNoisy) addDepthNoise(meters as Float32Array, NOISE, `${shot++}`);
    lab.engine.apply({ kind: 'depth', frame: { ...frame, meters, deltaS } });
  };
  for (const frame of frames) see(frame);
  for (let i = 0; i < 15; i++) see(last);
  let drops = 0;
  const place = () => placeOf(drops++);

  const balls: { readonly id: number; readonly before: Vector3; restS: number; bestS: number; restsAt: Vector3 }[] = [];
  let throughCount = 0;
  let lostCount = 0;
  for (let frame = 0; frame < seconds * 60; frame++) {
    if (frame % 3 === 0 && balls.length < BALLS) {
      const positionM = place();
      const id = lab.add({ shapes: ball(RADIUS_M), rollingM: 0.004, massKg: 0.1 }, { positionM });
      balls.push({ id, before: new Vector3(...positionM), restS: 0, bestS: 0, restsAt: new Vector3() });
    }
    if (frame % everyFrames === 0) see(last, everyFrames / 60);
    lab.run(1 / 60);
    const all = lab.all();
    for (const each of balls) {
      const body = all.get(each.id);
      if (!body) throw new Error('A ball is missing.');
      const p = new Vector3(...body.positionM);
      if (p.distanceTo(each.before) > 1e-5 && crosses(each.before, p)) throughCount++;
      each.before.copy(p);
      each.restS = Math.hypot(...body.velocity) < 0.01 ? each.restS + 1 / 60 : 0;
      if (each.restS > 1) each.restsAt.copy(p);
      each.bestS = Math.max(each.bestS, each.restS);
      if (!body.isLost) continue;
      // As a body node recycles it.
      lostCount++;
      const positionM = place();
      each.before.set(...positionM);
      each.bestS = 0;
      const worldFromBody = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, ...positionM, 1];
      lab.engine.apply({ kind: 'move', id: each.id, worldFromBody, velocity: [0, 0, 0] });
    }
  }
  const isNear = (p: Vector3) => Math.abs(distanceTo(p) - RADIUS_M) < nearM;
  const rested = balls.filter(({ bestS, restsAt }) => bestS > 1 && isNear(restsAt));
  const kept = rested.filter(({ before, restsAt }) => before.distanceTo(restsAt) < nearM && isNear(before));
  return { throughCount, restedCount: rested.length, keptCount: kept.length, lostCount };
}

/**
 * Node runs this several times as fast as Jest, whose tests look up each global through another context.
 *
 * @param args Folder of a session; rains as JSON.
 */
export async function main([folder = '', rains = '[]']: readonly string[]): Promise<number> {
  const wanted = JSON.parse(rains) as Rain[];
  const frames = readDepthSession(folder).frames(wanted.length > 0 ? 60 : FRAMES);
  const scanned = wanted.length > 0 ? scan(frames) : null;
  const rained = scanned ? wanted.map((each) => rain(scanned, each)) : [];
  console.log(JSON.stringify({ rays: equalToRays(frames.slice(0, FRAMES)), rained } satisfies RealRoom));
  return 0;
}
