import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { SessionFile, SessionFileFrame } from '../../export/runtime/sessions/session-format.ts';
import { backProject, type DepthImage, project, type SurfacePoint, surfacePoints } from '../../tools/sessions/depth-image.ts';
import { invertRigid, transformDirection, transformPoint } from '../../tools/sessions/vector.ts';
import { readPng16 } from './png16.ts';

export interface LoadedSession {
  readonly file: SessionFile;
  /** Of the frames with depth, in order. */
  readonly depths: readonly DepthImage[];
}

export async function loadSession(folder: string, every = 1): Promise<LoadedSession> {
  const file = JSON.parse(await readFile(join(folder, 'session.json'), 'utf8')) as SessionFile;
  const frames = file.frames.filter((_, i) => i % every === 0);
  const metresPerUnit = file.depth?.metresPerUnit ?? Number.NaN;
  const depths = await Promise.all(frames.map(async ({ depth }) => readPng16(await readFile(join(folder, depth ?? '')), metresPerUnit)));
  return { file: { ...file, frames }, depths };
}

/** What all frames see, in world space. */
export function worldPoints({ file, depths }: LoadedSession, stridePx: number): SurfacePoint[] {
  const { intrinsics } = file.depth ?? file.color;
  return file.frames.flatMap(({ worldFromCamera }, i) => {
    const depth = depths[i];
    if (!depth) return [];
    return surfacePoints(depth, intrinsics, stridePx).map(({ point, normal }) => ({
      point: transformPoint(worldFromCamera, point),
      normal: transformDirection(worldFromCamera, normal),
    }));
  });
}

/** Differences of depth where what frame `a` sees is looked up in frame `b`, meters; what leaves the picture is left out. */
export function reproject({ file, depths }: LoadedSession, a: number, b: number, stridePx: number): number[] {
  const { intrinsics } = file.depth ?? file.color;
  const [from, to] = [depths[a], depths[b]];
  const [poseA, poseB] = [file.frames[a], file.frames[b]] as [SessionFileFrame, SessionFileFrame];
  if (!from || !to) throw new Error('No such frames.');
  const cameraFromWorld = invertRigid(poseB.worldFromCamera);
  const differences: number[] = [];
  for (let row = 0; row < from.heightPx; row += stridePx) {
    for (let column = 0; column < from.widthPx; column += stridePx) {
      const distanceM = from.meters[row * from.widthPx + column] ?? 0;
      if (distanceM === 0) continue;
      const world = transformPoint(poseA.worldFromCamera, backProject(intrinsics, column, row, distanceM));
      const inB = transformPoint(cameraFromWorld, world);
      const [x, y] = project(intrinsics, inB);
      const there =
        x >= 0 && y >= 0 && x < to.widthPx && y < to.heightPx && inB[2] < 0 ? to.meters[Math.floor(y) * to.widthPx + Math.floor(x)] : 0;
      if (there) differences.push(Math.abs(-inB[2] - there));
    }
  }
  return differences.sort((p, q) => p - q);
}

export function quantile(sorted: readonly number[], q: number): number {
  return sorted[Math.min(Math.floor(sorted.length * q), sorted.length - 1)] ?? Number.NaN;
}

export function toDegrees(rad: number): number {
  return (rad * 180) / Math.PI;
}
