import { copyFile, mkdir, readdir, readFile, writeFile } from 'node:fs/promises';
import { dirname, join, resolve } from 'node:path';
import type { SessionFile } from '../../export/runtime/sessions/format.ts';
import type { ToolMain } from '../lib/tool.ts';
import { alignToFloor, meanUp } from './align.ts';
import { convexHull, simplifyPolygon } from './convex-hull.ts';
import { decodeDepthPng, type SurfacePoint, surfacePoints } from './depth-image.ts';
import { type Floor, findFloor } from './find-floor.ts';
import { printSession } from './print-session.ts';
import { type PosedRecording, readOpen3d } from './read-open3d.ts';
import { type Matrix, multiply, transformDirection, transformPoint } from './vector.ts';

const USAGE = `Turns a recording with known camera poses into a Scrim session.

  npm run convert-session -- IN OUT

IN   a folder with session.json (see docs/SESSION-FORMAT.md, "Converting"), colour pictures and 16-bit depth PNGs
OUT  a new or empty folder`;

/** The floor is looked for in so many frames, at about so many places of each. */
const FRAMES_LOOKED_AT = 30;
const PLACES_PER_FRAME = 3000;
const HULL_TOLERANCE_M = 0.05;

export const main: ToolMain = async (args) => {
  const [input, output, ...more] = args;
  if (input === undefined || output === undefined || more.length > 0 || args.includes('--help')) {
    console.log(USAGE);
    return args.includes('--help') ? 0 : 1;
  }
  try {
    const from = resolve(input);
    const to = resolve(output);
    if ((await readdir(to).catch(() => [])).length > 0) throw new Error(`${to} is not empty. Name a new folder`);
    const recording = readOpen3d(JSON.parse(await readFile(join(from, 'session.json'), 'utf8')));
    const floor = await lookForFloor(from, recording);
    if (!floor) throw new Error('no floor was found: nothing in the depth pictures faces up. Record with the floor in view');
    await copyPictures(from, to, recording);
    await writeFile(join(to, 'session.json'), printSession(toSession(recording, floor)));
    console.log(`${to}: ${recording.frames.length} frames, gravity from ${floor.points.length} points of the floor`);
    return 0;
  } catch (error) {
    console.error(`The recording could not be converted: ${error instanceof Error ? error.message : String(error)}.`);
    return 1;
  }
};

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

async function copyPictures(from: string, to: string, { frames }: PosedRecording): Promise<void> {
  for (const path of frames.flatMap(({ color, depth }) => [color, depth])) {
    await mkdir(dirname(join(to, path)), { recursive: true });
    await copyFile(join(from, path), join(to, path));
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

/** Mulberry32: the same recording gives the same session. */
function createSeeded(): () => number {
  let state = 0x5c71;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}
