import { copyFile, mkdir, readdir, readFile, writeFile } from 'node:fs/promises';
import { dirname, join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { printSession } from '../../export/runtime/sessions/print-session.ts';
import type { SessionFile } from '../../export/runtime/sessions/session-format.ts';
import type { ToolMain } from '../lib/tool.ts';
import { alignToFloor, meanUp } from './align.ts';
import { convexHull, simplifyPolygon } from './convex-hull.ts';
import { decodeDepthPng, type SurfacePoint, surfacePoints, withoutInvalid } from './depth-image.ts';
import { type Floor, findFloor } from './find-floor.ts';
import { type FrameFolderWishes, isFrameFolder, readFrameFolder } from './read-frame-folder.ts';
import { type PosedRecording, readOpen3d } from './read-open3d.ts';
import { type Matrix, multiply, transformDirection, transformPoint } from './vector.ts';

const USAGE = `Turns a recording with known camera poses into a Scrim session.

  npm run convert-session -- IN OUT [--intrinsics fx,fy,cx,cy] [--fps N] [--depth-unit METERS]

IN   a folder with session.json (see docs/SESSION-FORMAT.md, "Converting"), or one with frame-000000.color.png, .depth.png and
     .pose.txt for each frame, as 7-Scenes and 3DMatch have them
OUT  a new or empty folder

The options are for the second form: the camera in pixels (unless camera-intrinsics.txt tells it), frames per second (30) and meters
per unit of depth (0.001).`;

/** Number of frames in which the floor is searched, and the approximate number of points in each. */
const FRAMES_LOOKED_AT = 30;
const PLACES_PER_FRAME = 3000;
const HULL_TOLERANCE_M = 0.05;

/** Below this number of points, a warning says that the floor is uncertain: it may be a table, a step, or noise. */
const FEW_POINTS = 300;

export const main: ToolMain = async (args) => {
  const call = readCall(args);
  if (call === null) {
    console.log(USAGE);
    return args.includes('--help') ? 0 : 1;
  }
  try {
    const from = resolve(call.input);
    const to = resolve(call.output);
    if ((await readdir(to).catch(() => [])).length > 0) throw new Error(`${to} is not empty. Name a new folder`);
    const recording = await readRecording(from, call.wishes);
    const floor = await lookForFloor(from, recording);
    if (!floor) throw new Error('no floor was found: nothing in the depth images faces up. Record with the floor in view');
    await copyImages(from, to, recording);
    await writeFile(join(to, 'session.json'), printSession(toSession(recording, floor)));
    console.log(`${to}: ${recording.frames.length} frames, gravity from ${floor.points.length} points of the floor`);
    if (floor.points.length < FEW_POINTS) {
      console.warn(
        `Warning: the floor rests on ${floor.points.length} points. Check that the room stands level, or record more of the floor.`,
      );
    }
    return 0;
  } catch (error) {
    console.error(`The recording could not be converted: ${error instanceof Error ? error.message : String(error)}.`);
    return 1;
  }
};

interface Call {
  readonly input: string;
  readonly output: string;
  readonly wishes: FrameFolderWishes;
}

/** Parses the command line; null if it is invalid. */
function readCall(args: readonly string[]): Call | null {
  try {
    const options = { intrinsics: { type: 'string' }, fps: { type: 'string' }, 'depth-unit': { type: 'string' } } as const;
    const { values, positionals } = parseArgs({ args: [...args], options, allowPositionals: true });
    const [input, output, ...more] = positionals;
    if (input === undefined || output === undefined || more.length > 0) return null;
    const numbers = [values.intrinsics?.split(','), [values.fps ?? 1], [values['depth-unit'] ?? 1]]
      .flatMap((list) => list ?? [])
      .map(Number);
    if (!numbers.every((number) => Number.isFinite(number) && number > 0)) return null;
    const camera = values.intrinsics?.split(',').map(Number) ?? null;
    if (camera !== null && camera.length !== 4) return null;
    const wishes = {
      intrinsics: camera as FrameFolderWishes['intrinsics'],
      ...(values.fps === undefined ? {} : { frameRateHz: Number(values.fps) }),
      ...(values['depth-unit'] === undefined ? {} : { metersPerUnit: Number(values['depth-unit']) }),
    };
    return { input, output, wishes };
  } catch {
    return null;
  }
}

async function readRecording(from: string, wishes: FrameFolderWishes): Promise<PosedRecording> {
  const session = await readFile(join(from, 'session.json'), 'utf8').catch(() => null);
  if (session !== null) return readOpen3d(JSON.parse(session));
  if (!(await isFrameFolder(from))) throw new Error(`${from} holds neither session.json nor frame-*.pose.txt`);
  const { recording, lost } = await readFrameFolder(from, wishes);
  if (lost.length > 0) console.warn(`Warning: frames without a pose are left out: ${lost.length}, the first is ${lost[0]}.`);
  return recording;
}

async function lookForFloor(from: string, { frames, intrinsics, metresPerUnit, widthPx, heightPx }: PosedRecording): Promise<Floor | null> {
  const stridePx = Math.max(1, Math.round(Math.sqrt((widthPx * heightPx) / PLACES_PER_FRAME)));
  const every = Math.ceil(frames.length / FRAMES_LOOKED_AT);
  const surface: SurfacePoint[] = [];
  for (const { depth, worldFromCamera } of frames.filter((_, i) => i % every === 0)) {
    const image = decodeDepthPng(await readFile(join(from, depth)), metresPerUnit);
    for (const { point, normal } of surfacePoints(image, intrinsics, stridePx)) {
      surface.push({ point: transformPoint(worldFromCamera, point), normal: transformDirection(worldFromCamera, normal) });
    }
  }
  return findFloor(surface, meanUp(frames.map((frame) => frame.worldFromCamera)), createSeeded());
}

async function copyImages(from: string, to: string, { frames }: PosedRecording): Promise<void> {
  for (const { color, depth } of frames) {
    for (const path of [color, depth]) await mkdir(dirname(join(to, path)), { recursive: true });
    await copyFile(join(from, color), join(to, color));
    const png = await readFile(join(from, depth));
    await writeFile(join(to, depth), withoutInvalid(png) ?? png);
  }
}

function toSession(recording: PosedRecording, floor: Floor): SessionFile {
  const { widthPx, heightPx, intrinsics, metresPerUnit, frameRateHz, frames, title, credit, licence } = recording;
  const alignedFromRecorded = alignToFloor(floor, frames[0]?.worldFromCamera ?? []);
  return {
    format: 'scrim-session',
    version: 1,
    title,
    ...(credit === null ? {} : { credit }),
    ...(licence === null ? {} : { licence }),
    color: { widthPx, heightPx, intrinsics },
    depth: { widthPx, heightPx, intrinsics, metresPerUnit, kind: 'z' },
    frameRateHz,
    surfaces: [floorSurface(floor, alignedFromRecorded)],
    frames: frames.map(({ timeS, color, depth, worldFromCamera }) => ({
      timeS,
      color,
      depth,
      worldFromCamera: multiply(alignedFromRecorded, worldFromCamera),
    })),
  };
}

function floorSurface(floor: Floor, alignedFromRecorded: Matrix): NonNullable<SessionFile['surfaces']>[number] {
  const seen = floor.points.map((point) => transformPoint(alignedFromRecorded, point));
  const corners = simplifyPolygon(convexHull(seen.map(([x, , z]) => [x, z] as const)), HULL_TOLERANCE_M);
  return {
    id: 'floor',
    kind: 'plane',
    orientation: 'horizontal',
    label: 'floor',
    worldFromPlane: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
    polygonXZ: corners,
  };
}

/** Random numbers with a fixed seed (Mulberry32), so that the same recording gives the same session. */
function createSeeded(): () => number {
  let state = 0x5c71;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}
