import { readdir } from 'node:fs/promises';
import { extname, join } from 'node:path';
import { inflateSync } from 'node:zlib';
import { decode as decodePng } from 'fast-png';
import { depthSeen } from '../../export/captures/depth/depth-from-mesh.ts';
import { checkDepthMap, type DepthMap, depthForPinhole, pinholeOfDepth } from '../../export/captures/depth/depth-map.ts';
import { depthOfPoints } from '../../export/captures/depth/depth-of-points.ts';
import type { DepthAnswers, DepthSample, DepthScale, DepthUnit } from '../../export/captures/depth/depth-scale.ts';
import { depthScaleOf } from '../../export/captures/depth/depth-scale.ts';
import { readExr } from '../../export/captures/depth/exr.ts';
import { checkSize, readColmapDepth, readPfm } from '../../export/captures/depth/read-depth.ts';
import { pinholeFor } from '../../export/captures/undistort.ts';
import { CaptureError, type CaptureMesh, isInside, type Pinhole } from '../../nodes/kit/capture.ts';
import type { FoundView } from './read-capture-folder.ts';
import { readSource } from './read-source.ts';

/** Folders in which depth maps are kept; the last ones are those of COLMAP. */
const DEPTH_FOLDERS = ['depth', 'depths', 'depth_maps', 'stereo/depth_maps', 'dense/stereo/depth_maps', 'images', ''];
/** What follows the name of a photograph without its ending, by format; the surest first. */
const STEM_ENDINGS = ['.png', '.exr', '.pfm', '_depth.png', '_depth_mm.png', '_depth.exr', '_depth.pfm', '.depth.png'];
/** What follows the whole name of a photograph. */
const NAME_ENDINGS = ['.geometric.bin', '.photometric.bin'];
const MAX_DEPTH_BYTES = 2 ** 30;
/** Number of depth maps, and their longest side, by which the unit is found. */
const SAMPLES = 4;
const SAMPLE_SIDE_PX = 160;

/**
 * Finds the depth map of each photograph by its name.
 *
 * @returns Absolute paths in the order of the views; null where there is none.
 */
export async function findDepths(folder: string, views: readonly FoundView[]): Promise<readonly (string | null)[]> {
  const listed = new Map<string, ReadonlySet<string>>();
  const isFile = async (path: string): Promise<boolean> => {
    const at = path.lastIndexOf('/');
    const place = path.slice(0, at);
    if (!listed.has(place)) listed.set(place, new Set(await readdir(place).catch(() => [])));
    return listed.get(place)?.has(path.slice(at + 1)) ?? false;
  };
  const found: (string | null)[] = [];
  for (const { view, file } of views) {
    if (view.depthName !== null && !isInside(view.depthName)) {
      throw new CaptureError(`the depth ${JSON.stringify(view.depthName)} is outside the folder`);
    }
    const stem = view.name.slice(0, view.name.length - extname(view.name).length);
    const names = [
      ...STEM_ENDINGS.map((ending) => stem + ending),
      ...NAME_ENDINGS.map((ending) => view.name + ending),
      ...STEM_ENDINGS.slice(3).map((ending) => stem.replace(/_color$/, '') + ending),
    ];
    const paths = DEPTH_FOLDERS.flatMap((place) => names.map((name) => join(folder, place, name)));
    if (view.depthName !== null) paths.unshift(join(folder, view.depthName));
    let depth: string | null = null;
    for (const path of paths) {
      // A photograph that is a PNG file is not its own depth.
      if (path === file || !(await isFile(path))) continue;
      depth = path;
      break;
    }
    found.push(depth);
  }
  return found;
}

/** Reads a depth map as it is. @throws CaptureError */
export async function readDepthFile(path: string, name: string): Promise<DepthMap> {
  const bytes = await readSource(path, MAX_DEPTH_BYTES);
  const ending = extname(path).toLowerCase();
  if (ending === '.pfm') return readPfm(bytes, name);
  if (ending === '.bin') return readColmapDepth(bytes, name);
  if (ending === '.exr') return readExr(bytes, name, (packed) => new Uint8Array(inflateSync(packed)));
  return readPng(bytes, name);
}

function readPng(bytes: Uint8Array, name: string): DepthMap {
  let image: ReturnType<typeof decodePng>;
  try {
    image = decodePng(bytes);
  } catch {
    throw new CaptureError(`the depth of ${name} is not a whole PNG file`);
  }
  const { width, height, data, channels, depth } = image;
  if (depth !== 16) throw new CaptureError(`the depth of ${name} has ${depth} bits, which are too few. Save it with 16 bits`);
  if (channels !== 1) throw new CaptureError(`the depth of ${name} has ${channels} channels. Save it in gray with 16 bits`);
  const [widthPx, heightPx] = checkSize(width, height, name);
  return { widthPx, heightPx, values: Float32Array.from(data) };
}

/** A depth map of a few pixels, and the camera of its pixels. */
export interface SampledDepth extends DepthSample {
  readonly pinhole: Pinhole;
}

/**
 * Reads some of the depth files, by which their unit and kind are found.
 *
 * @param mesh In units of the reconstruction; null if there is none.
 * @param sidePx Longest side of the samples.
 * @throws CaptureError
 */
export async function readDepthSamples(
  views: readonly FoundView[],
  depths: readonly (string | null)[],
  mesh: CaptureMesh | null,
  sidePx = SAMPLE_SIDE_PX,
): Promise<readonly SampledDepth[]> {
  const withDepth = [...views.keys()].filter((i) => depths[i] != null);
  const step = Math.max(1, Math.floor(withDepth.length / SAMPLES));
  const samples: SampledDepth[] = [];
  for (const i of withDepth.filter((_, at) => at % step === 0).slice(0, SAMPLES)) {
    const found = views[i];
    const path = depths[i];
    if (!found || !path) continue;
    const { view, lens } = found;
    const map = await readDepthFile(path, view.name);
    checkDepthMap(map, view.name, lens);
    const pinhole = pinholeFor(lens, sidePx);
    const points = mesh ? null : depthOfPoints(view, pinhole);
    samples.push({
      name: view.name,
      pinhole,
      file: { z: depthForPinhole(map, lens, pinhole, 'z', 1), ray: depthForPinhole(map, lens, pinhole, 'ray', 1) },
      surface: mesh ? { kind: 'mesh', map: depthSeen(mesh, pinhole, view.worldFromCamera) } : points && { kind: 'points', map: points },
      usualUnit: usualUnit(path),
    });
  }
  return samples;
}

/**
 * Finds out the unit and the kind of the depth files by some of them.
 *
 * @param mesh In units of the reconstruction; null if there is none.
 * @param isGuess Whether `metersPerUnit` is a guess, which depth in meters corrects.
 * @throws CaptureError
 */
export async function readDepthScale(
  views: readonly FoundView[],
  depths: readonly (string | null)[],
  mesh: CaptureMesh | null,
  answers: DepthAnswers,
  metersPerUnit: number,
  isGuess: boolean,
): Promise<DepthScale> {
  const samples = await readDepthSamples(views, depths, mesh);
  return depthScaleOf(samples, answersFor(samples, answers), metersPerUnit, isGuess);
}

/** A 360° camera has no axis: its depths are distances. */
function answersFor(samples: readonly SampledDepth[], answers: DepthAnswers): DepthAnswers {
  return samples.every(({ pinhole }) => pinhole.projection !== undefined) ? { ...answers, kind: 'ray' } : answers;
}

function usualUnit(path: string): DepthUnit {
  const ending = extname(path).toLowerCase();
  if (ending === '.png') return 'mm';
  return ending === '.bin' ? 'reconstruction' : 'm';
}

/** The depth of one photograph in meters along the axis of its pinhole camera, at most as large as the photograph. @throws CaptureError */
export async function readDepthM(
  path: string,
  { view, lens }: FoundView,
  pinhole: Pinhole,
  { kind, scale }: DepthScale,
  metersPerUnit: number,
): Promise<DepthMap> {
  const map = await readDepthFile(path, view.name);
  checkDepthMap(map, view.name, lens);
  return depthForPinhole(map, lens, pinholeOfDepth(pinhole, map), kind, scale * metersPerUnit);
}
