import { readdir, readFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import sharp from 'sharp';
import type { Intrinsics } from '../../export/runtime/sessions/session-format.ts';
import { fromOpenCv, type PosedFrame, type PosedRecording } from './read-open3d.ts';

const POSE = /^(frame-\d+)\.pose\.txt$/;
const INTRINSICS_FILE = 'camera-intrinsics.txt';
const FRAME_RATE_HZ = 30;
const METERS_PER_UNIT = 0.001;

/** Options for facts that the folder does not contain. */
export interface FrameFolderWishes {
  /** Pixels, in OpenCV’s convention; null to read `camera-intrinsics.txt`. */
  readonly intrinsics: readonly [fx: number, fy: number, cx: number, cy: number] | null;
  readonly frameRateHz?: number;
  readonly metersPerUnit?: number;
}

/** Whether the folder contains `frame-*.pose.txt`. */
export async function isFrameFolder(folder: string): Promise<boolean> {
  return (await readdir(folder)).some((name) => POSE.test(name));
}

/**
 * Reads the raw form in which Microsoft's 7-Scenes and 3DMatch publish recordings: `frame-000000.color.png` (or `.jpg`),
 * `frame-000000.depth.png` in 16-bit millimeters, and `frame-000000.pose.txt`, a row-major 4×4 matrix from camera to world with OpenCV's
 * axes. The intrinsics are a 3×3 matrix in `camera-intrinsics.txt`, in the folder or its parent.
 *
 * @returns The recording, and the names of frames without a usable pose: trackers write NaN or infinity where they were lost.
 * @throws Error that names the file that is missing or wrong.
 */
export async function readFrameFolder(
  folder: string,
  wishes: FrameFolderWishes,
): Promise<{ readonly recording: PosedRecording; readonly lost: readonly string[] }> {
  const names = new Set(await readdir(folder));
  const ids = [...names].flatMap((name) => POSE.exec(name)?.[1] ?? []).sort();
  const frameRateHz = wishes.frameRateHz ?? FRAME_RATE_HZ;
  const frames: PosedFrame[] = [];
  const lost: string[] = [];
  for (const [index, id] of ids.entries()) {
    const matrix = readMatrix(await readFile(join(folder, `${id}.pose.txt`), 'utf8'), 16, `${id}.pose.txt`);
    const worldFromCamera = matrix && fromOpenCv(matrix);
    if (worldFromCamera) frames.push({ timeS: index / frameRateHz, ...imagesOf(id, names), worldFromCamera });
    else lost.push(id);
  }
  const [first] = frames;
  if (!first) throw new Error(`no frame of ${folder} has a pose`);
  const { widthPx, heightPx } = await commonSize(folder, first);
  const recording = {
    title: 'Converted recording',
    credit: null,
    licence: null,
    widthPx,
    heightPx,
    intrinsics: await readIntrinsics(folder, wishes),
    metresPerUnit: wishes.metersPerUnit ?? METERS_PER_UNIT,
    frameRateHz,
    frames,
  };
  return { recording, lost };
}

function imagesOf(id: string, names: ReadonlySet<string>): { readonly color: string; readonly depth: string } {
  const color = ['png', 'jpg', 'jpeg'].map((ending) => `${id}.color.${ending}`).find((name) => names.has(name));
  const depth = `${id}.depth.png`;
  if (color === undefined) throw new Error(`${id}.color.png is missing`);
  if (!names.has(depth)) throw new Error(`${depth} is missing`);
  return { color, depth };
}

/** Size of the color and depth images. Throws if the two sizes differ, because a session has one camera for both. */
async function commonSize(folder: string, { color, depth }: PosedFrame): Promise<{ readonly widthPx: number; readonly heightPx: number }> {
  const [a, b] = await Promise.all([color, depth].map((name) => sharp(join(folder, name)).metadata()));
  if (a?.width === b?.width && a?.height === b?.height && a) return { widthPx: a.width, heightPx: a.height };
  throw new Error(`${color} is ${a?.width} × ${a?.height}, but ${depth} is ${b?.width} × ${b?.height}. Resample them to one size first`);
}

async function readIntrinsics(folder: string, { intrinsics }: FrameFolderWishes): Promise<Intrinsics> {
  const [fx, fy, cx, cy] = intrinsics ?? (await findIntrinsics(folder));
  // OpenCV measures from the center of the top left pixel, sessions from its corner.
  return { fxPx: fx, fyPx: fy, cxPx: cx + 0.5, cyPx: cy + 0.5 };
}

async function findIntrinsics(folder: string): Promise<readonly [number, number, number, number]> {
  for (const place of [folder, dirname(folder)]) {
    const text = await readFile(join(place, INTRINSICS_FILE), 'utf8').catch(() => null);
    if (text === null) continue;
    const matrix = readMatrix(text, 9, INTRINSICS_FILE);
    const [fx = 0, , cx = 0, , fy = 0, cy = 0] = matrix ?? [];
    if (fx > 0 && fy > 0) return [fx, fy, cx, cy];
    throw new Error(`${INTRINSICS_FILE} has to be a 3×3 matrix with positive focal lengths`);
  }
  throw new Error(`there is no ${INTRINSICS_FILE}. Give the camera with --intrinsics fx,fy,cx,cy (7-Scenes: 585,585,320,240)`);
}

/** Reads a matrix of `count` numbers; null if one of them is not finite. */
function readMatrix(text: string, count: number, file: string): readonly number[] | null {
  const words = text.trim().split(/\s+/);
  if (words.length !== count) throw new Error(`${file} has to hold ${count} numbers, but holds ${words.length}`);
  const numbers = words.map((word) => Number(/^[+-]?(inf|infinity|nan)/i.test(word) ? Number.NaN : word));
  return numbers.every(Number.isFinite) ? numbers : null;
}
