import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { decode } from 'fast-png';
import { Matrix4, Raycaster, Vector3 } from 'three';
import { addDepthNoise } from '../../export/emulator/depth/depth-noise.ts';
import { createRoom } from '../../export/emulator/rooms/room-source.ts';
import { createRandom } from '../../export/runtime/random.ts';
import { setFrustum } from '../../export/runtime/sessions/matrix.ts';
import { castAtDepth, type DepthImage } from '../../export/runtime/spatial/cast/cast-depth.ts';
import { createMeeting, createRay, type Meeting, setRay } from '../../export/runtime/spatial/ray.ts';
import type { DepthFrame } from '../../nodes/kit/physics.ts';
import { writeVoxelFile } from '../../nodes/kit/voxel-file.ts';
import { createVoxelRays } from '../../nodes/physics/room/voxel-rays.ts';
import { createVoxelGrid } from '../../nodes/physics/world/voxel-grid.ts';
import { addDomPoint } from './dom-point.ts';

// Hit tests on room depth alone, or on the voxels that it fills, against the geometry that the depth is of.

const WIDTH = 160;
const HEIGHT = 120;
/** Farther from the truth, another surface was hit. */
const WRONG_M = 0.1;

export interface Score {
  readonly hits: number;
  /** How many of them are on flat surfaces, where normals are compared. */
  readonly flat: number;
  readonly missed: number;
  readonly wrong: number;
  readonly medianCm: number;
  readonly p95Cm: number;
  /** On flat surfaces. */
  readonly flatP95Cm: number;
  readonly normalMedianDeg: number;
  readonly normalP95Deg: number;
}

interface Truth {
  readonly point: Vector3;
  /** Null where the surface is not flat, so that it has no one normal. */
  readonly normal: Vector3 | null;
}

function pictureOf(meters: Float32Array, halfX: number, halfY: number, worldFromView: Matrix4): DepthImage {
  const picture: DepthImage = {
    meters,
    widthPx: WIDTH,
    heightPx: HEIGHT,
    uvFromViewUv: Float32Array.of(1, 0, 0, 0, -1, 0, 0, 1, 1),
    clipFromView: new Float32Array(16),
    worldFromView: new Float32Array(worldFromView.elements),
    frame: 0,
  };
  setFrustum(picture.clipFromView, -halfX, halfX, -halfY, halfY, 0.05, 100);
  return picture;
}

/** Of a point of a view, in world space; its length is that of 1 m along the view's axis. */
function directionAt(u: number, v: number, halfX: number, halfY: number, worldFromView: Matrix4): Vector3 {
  return new Vector3((2 * u - 1) * halfX, (2 * v - 1) * halfY, -1).applyMatrix4(new Matrix4().extractRotation(worldFromView));
}

function quantile(values: readonly number[], share: number): number {
  return [...values].sort((a, b) => a - b)[Math.floor(share * (values.length - 1))] ?? Number.NaN;
}

interface CastRay {
  readonly origin: Vector3;
  readonly direction: Vector3;
  readonly truth: Truth;
  readonly picture: DepthImage;
}

/** Answers rays by the depth of some images. */
type MakeCast = (pictures: readonly DepthImage[]) => Cast;

type Cast = (out: Meeting, ray: ReturnType<typeof createRay>, picture: DepthImage) => boolean;

function scoreOf(rays: readonly CastRay[], cast: Cast = castAtDepth): Score {
  const ray = createRay();
  const meeting = createMeeting();
  const errors: number[] = [];
  const angles: number[] = [];
  const flatErrors: number[] = [];
  let missed = 0;
  let wrong = 0;
  for (const { origin, direction, truth, picture } of rays) {
    setRay(ray, new Matrix4().lookAt(new Vector3(), direction, new Vector3(0.01, 1, 0.02)).setPosition(origin).elements);
    if (!cast(meeting, ray, picture)) {
      missed++;
      continue;
    }
    const point = new Vector3(ray.dx, ray.dy, ray.dz).multiplyScalar(meeting.distanceM).add(origin);
    const errorM = point.distanceTo(truth.point);
    if (errorM > WRONG_M) wrong++;
    errors.push(100 * errorM);
    if (truth.normal) flatErrors.push(100 * errorM);
    if (truth.normal && errorM <= WRONG_M) {
      const cosine = Math.abs(new Vector3(meeting.nx, meeting.ny, meeting.nz).normalize().dot(truth.normal));
      angles.push((Math.acos(Math.min(1, cosine)) * 180) / Math.PI);
    }
  }
  const rounded = (x: number) => Math.round(x * 100) / 100;
  return {
    hits: errors.length,
    flat: angles.length,
    missed: rounded(missed / rays.length),
    wrong: rounded(wrong / rays.length),
    medianCm: rounded(quantile(errors, 0.5)),
    p95Cm: rounded(quantile(errors, 0.95)),
    flatP95Cm: rounded(quantile(flatErrors, 0.95)),
    normalMedianDeg: rounded(quantile(angles, 0.5)),
    normalP95Deg: rounded(quantile(angles, 0.95)),
  };
}

const HALF_X = 0.6;
const HALF_Y = (HALF_X * HEIGHT) / WIDTH;

/** Depth of a scanned room from where a visitor looks at its floor and furniture, with noise; rays through random points of the view. */
function castInRoom(name: string, makeCast?: MakeCast): Score {
  const room = createRoom({ capture: JSON.parse(readFileSync(`node_modules/@iwer/sem/captures/${name}.json`, 'utf8')) });
  const raycaster = new Raycaster();
  const meet = (origin: Vector3, direction: Vector3) => {
    raycaster.set(origin, direction.clone().normalize());
    const [hit] = raycaster.intersectObject(room.solids, true);
    return hit?.point ?? null;
  };
  const rays: CastRay[] = [];
  [0, 1.5, 3, 4.5].forEach((yawRad, view) => {
    const worldFromView = new Matrix4().makeRotationY(yawRad).multiply(new Matrix4().makeRotationX(-0.5)).setPosition(0, 1.5, 0);
    const origin = new Vector3(0, 1.5, 0);
    const meters = new Float32Array(WIDTH * HEIGHT);
    for (let row = 0; row < HEIGHT; row++) {
      for (let column = 0; column < WIDTH; column++) {
        const direction = directionAt((column + 0.5) / WIDTH, 1 - (row + 0.5) / HEIGHT, HALF_X, HALF_Y, worldFromView);
        const hit = meet(origin, direction);
        meters[row * WIDTH + column] = hit ? hit.distanceTo(origin) / direction.length() : 0;
      }
    }
    addDepthNoise(meters, NOISE, `${name}/${view}`);
    const picture = pictureOf(meters, HALF_X, HALF_Y, worldFromView);
    const random = createRandom(view, name);
    for (let i = 0; i < 150; i++) {
      const [column, row] = [Math.floor(WIDTH * (0.05 + 0.9 * random.next())), Math.floor(HEIGHT * (0.05 + 0.9 * random.next()))];
      const directionOf = (x: number, y: number) => directionAt((x + 0.3) / WIDTH, 1 - (y + 0.7) / HEIGHT, HALF_X, HALF_Y, worldFromView);
      const at = (x: number, y: number) => meet(origin, directionOf(x, y));
      const direction = directionOf(column, row);
      const point = at(column, row);
      if (!point || point.distanceTo(origin) > 5) continue;
      rays.push({ origin, direction, truth: { point, normal: normalAt(at, column, row, 4) }, picture });
    }
  });
  room.dispose();
  return scoreOf(rays, makeCast?.([...new Set(rays.map(({ picture }) => picture))]));
}

/** Of an emulated sensor. */
const NOISE = { sigmaM: 0.01, sigmaPerM: 0.005, holes: 0.05, seed: 3 };

interface Recording {
  readonly width: number;
  readonly height: number;
  readonly intrinsics: { readonly fx: number; readonly fy: number; readonly cx: number; readonly cy: number };
  readonly frames: readonly { readonly depth: string; readonly cameraToWorld: readonly number[] }[];
}

/** Rays by the voxels that depth images have filled, as a physics room answers them. Frames follow each other at 30 Hz. */
function castAtVoxels(pictures: readonly DepthImage[], isSmooth: boolean): Cast {
  const grid = createVoxelGrid({ edgeM: 0.05, threshold: 0.5, speed: 0.2, farM: 6, isSmooth });
  for (const { meters, clipFromView: c, worldFromView } of pictures) {
    const stepX = 2 / ((c[0] ?? 1) * WIDTH);
    const stepY = 2 / ((c[5] ?? 1) * HEIGHT);
    const [left, top] = [((c[8] ?? 0) - 1) / (c[0] ?? 1), ((c[9] ?? 0) + 1) / (c[5] ?? 1)];
    const rayFromTexel = [stepX, 0, left + stepX / 2, 0, -stepY, top - stepY / 2];
    const frame: DepthFrame = { meters, widthPx: WIDTH, heightPx: HEIGHT, worldFromDepth: worldFromView, rayFromTexel, deltaS: 1 / 30 };
    // As long as a visitor looks there.
    for (let i = 0; i < 5; i++) grid.update(frame);
  }
  const rays = createVoxelRays();
  rays.read(writeVoxelFile(grid.save()));
  return (out, ray) => rays.cast(out, ray);
}

/** Depth of every second frame of a recorded session; rays towards what the frame after it shows. */
function castInRecording(folder: string, makeCast?: MakeCast): Score {
  const { width, height, intrinsics, frames } = JSON.parse(readFileSync(join(folder, 'session.json'), 'utf8')) as Recording;
  const { fx, fy, cx, cy } = intrinsics;
  const depthOf = (file: string) => decode(readFileSync(join(folder, file))).data as Uint16Array;
  const poseOf = (rows: readonly number[]) =>
    new Matrix4()
      .fromArray([...rows])
      .transpose()
      .multiply(new Matrix4().makeScale(1, -1, -1));
  const step = width / WIDTH;
  const rays: CastRay[] = [];
  const pictures: DepthImage[] = [];
  for (let i = 0; i + 1 < frames.length; i += 4) {
    const [shown, held] = [frames[i], frames[i + 1]];
    if (!shown || !held) continue;
    const fine = depthOf(shown.depth);
    const meters = Float32Array.from({ length: WIDTH * HEIGHT }, (_, at) => {
      const x = Math.floor(((at % WIDTH) + 0.5) * step);
      const y = Math.floor((Math.floor(at / WIDTH) + 0.5) * step);
      return (fine[y * width + x] ?? 0) / 1000;
    });
    const picture = pictureOf(meters, 1, 1, poseOf(shown.cameraToWorld));
    // Sample (x, y) of the coarse grid is the pixel at its middle, whose center has whole coordinates.
    const u = (x: number) => ((x + 0.5) * step - 0.5 - cx) / fx;
    const v = (y: number) => ((y + 0.5) * step - 0.5 - cy) / fy;
    setFrustum(
      picture.clipFromView,
      u(-0.5) + 0.5 / fx,
      u(WIDTH - 0.5) + 0.5 / fx,
      -(v(HEIGHT - 0.5) + 0.5 / fy),
      -(v(-0.5) + 0.5 / fy),
      0.05,
      100,
    );
    pictures.push(picture);
    const truthDepth = depthOf(held.depth);
    const pose = poseOf(held.cameraToWorld);
    const at = (x: number, y: number): Vector3 | null => {
      const depth = (truthDepth[y * width + x] ?? 0) / 1000;
      return depth > 0 ? new Vector3(((x - cx) / fx) * depth, (-(y - cy) / fy) * depth, -depth).applyMatrix4(pose) : null;
    };
    const origin = new Vector3().setFromMatrixPosition(pose);
    const random = createRandom(i, 'icl');
    for (let n = 0; n < 40; n++) {
      const x = Math.floor(width * (0.1 + 0.8 * random.next()));
      const y = Math.floor(height * (0.1 + 0.8 * random.next()));
      const point = at(x, y);
      if (!point) continue;
      rays.push({ origin, direction: point.clone().sub(origin), truth: { point, normal: normalAt(at, x, y, 12) }, picture });
    }
  }
  return scoreOf(rays, makeCast?.(pictures));
}

/** Of the flat surface around a pixel, by points so many pixels away; null at edges and curves. */
function normalAt(at: (x: number, y: number) => Vector3 | null, x: number, y: number, reach: number): Vector3 | null {
  const [middle, left, right, up, down] = [at(x, y), at(x - reach, y), at(x + reach, y), at(x, y - reach), at(x, y + reach)];
  if (!middle || !left || !right || !up || !down) return null;
  const across = right.clone().sub(left);
  const along = down.clone().sub(up);
  const normal = new Vector3().crossVectors(across, along).normalize();
  const isFlat = [left, right, up, down].every((point) => Math.abs(point.clone().sub(middle).dot(normal)) < 0.006);
  return isFlat ? normal : null;
}

/** What the tool prints: by depth, by voxels, and by a smooth surface through them. */
export interface HitScores {
  readonly depth: Score;
  readonly voxels: Score;
  readonly smooth: Score;
}

/**
 * Node runs this several times as fast as Jest, whose tests look up each global through another context.
 *
 * @param args The folder of a session, or the name of a scanned room.
 */
export async function main([place = '']: readonly string[]): Promise<number> {
  addDomPoint();
  const cast = (makeCast?: MakeCast) => (place.includes('/') ? castInRecording(place, makeCast) : castInRoom(place, makeCast));
  const scores: HitScores = {
    depth: cast(),
    voxels: cast((pictures) => castAtVoxels(pictures, false)),
    smooth: cast((pictures) => castAtVoxels(pictures, true)),
  };
  process.stdout.write(JSON.stringify(scores));
  return 0;
}
