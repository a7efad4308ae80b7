import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { Matrix4, Ray, Vector3 } from 'three';
import { decodeDepth } from '../../../export/runtime/sessions/recorded/decode-depth.ts';
import { readSessionFile, SESSION_FILE } from '../../../export/runtime/sessions/recorded/read-session-file.ts';
import type { DepthFrame } from '../../../nodes/kit/physics.ts';

/** Images are thinned to at most so many columns, as the physics room does it. */
const MAX_WIDTH_PX = 160;

/** The depth of a recorded session, as the voxel grid takes it. */
export function readDepthSession(folder: string): { frames(count: number): DepthFrame[] } {
  const { output: session, diagnostics } = readSessionFile(JSON.parse(readFileSync(join(folder, SESSION_FILE), 'utf8')));
  if (!session?.depth) throw new Error(`There is no depth in ${folder}: ${JSON.stringify(diagnostics)}`);
  const images = session.depth;
  const { widthPx, heightPx, intrinsics: k } = images;
  const stride = Math.ceil(widthPx / MAX_WIDTH_PX);
  const width = Math.floor(widthPx / stride);
  const height = Math.floor(heightPx / stride);
  const frameAt = (index: number): DepthFrame => {
    const { depth, worldFromCamera } = session.frames[index] ?? {};
    if (depth === undefined || worldFromCamera === undefined) throw new Error(`Frame ${index} has no depth.`);
    const all = decodeDepth(new Uint8Array(readFileSync(join(folder, depth))).buffer, images);
    const meters = Float32Array.from(
      { length: width * height },
      (_, n) => all[Math.floor(n / width) * stride * widthPx + (n % width) * stride] ?? 0,
    );
    const rayFromTexel = [stride / k.fxPx, 0, (0.5 - k.cxPx) / k.fxPx, 0, -stride / k.fyPx, (k.cyPx - 0.5) / k.fyPx];
    return { meters, widthPx: width, heightPx: height, worldFromDepth: worldFromCamera, rayFromTexel, deltaS: 1 / 30 };
  };
  return { frames: (count) => Array.from({ length: Math.min(count, session.frames.length) }, (_, i) => frameAt(i)) };
}

/** Where the ray of a texel ends, world space. */
export function pointAt({ meters, widthPx, worldFromDepth: m, rayFromTexel: r }: DepthFrame, n: number): Vector3 {
  const d = meters[n] ?? 0;
  const x = (r[0] ?? 0) * (n % widthPx) + (r[2] ?? 0);
  const y = (r[4] ?? 0) * Math.floor(n / widthPx) + (r[5] ?? 0);
  return new Vector3(x * d, y * d, -d).applyMatrix4(new Matrix4().fromArray([...(m as number[])]));
}

const isMeasured = (d: number | undefined) => d !== undefined && d > 0.3 && d < 4.5;

export function pointsOf(frame: DepthFrame): Vector3[] {
  return Array.from({ length: frame.widthPx * frame.heightPx }, (_, n) => n).flatMap((n) =>
    isMeasured(frame.meters[n]) ? [pointAt(frame, n)] : [],
  );
}

/** The distance from a point to the nearest of many, up to `mostM`. */
export function nearestIn(points: readonly Vector3[], mostM: number): (p: Vector3) => number {
  const cells = new Map<string, Vector3[]>();
  const cell = (v: number) => Math.floor(v / mostM);
  for (const p of points) {
    const key = `${cell(p.x)} ${cell(p.y)} ${cell(p.z)}`;
    const list = cells.get(key);
    if (list) list.push(p);
    else cells.set(key, [p]);
  }
  return (p) => {
    let least = mostM;
    for (let i = -1; i <= 1; i++)
      for (let j = -1; j <= 1; j++)
        for (let k = -1; k <= 1; k++)
          for (const q of cells.get(`${cell(p.x) + i} ${cell(p.y) + j} ${cell(p.z) + k}`) ?? []) least = Math.min(least, q.distanceTo(p));
    return least;
  };
}

/** Neighboring texels that are further apart show two things with a gap between. */
const BORDER_M = 0.06;

/** Whether a path crosses the surface that a depth image shows: triangles between neighboring texels. */
export function crossesSurface(frame: DepthFrame): (from: Vector3, to: Vector3) => boolean {
  const { widthPx: width, heightPx: height, rayFromTexel: r } = frame;
  const points = Array.from({ length: width * height }, (_, n) => pointAt(frame, n));
  const viewFromWorld = new Matrix4().fromArray([...(frame.worldFromDepth as number[])]).invert();
  const texelOf = (p: Vector3): readonly [number, number] | null => {
    const v = p.clone().applyMatrix4(viewFromWorld);
    if (v.z >= 0) return null;
    return [(v.x / -v.z - (r[2] ?? 0)) / (r[0] ?? 1), (v.y / -v.z - (r[5] ?? 0)) / (r[4] ?? 1)];
  };
  const ray = new Ray();
  const hit = new Vector3();
  return (from, to) => {
    const [a, b] = [texelOf(from), texelOf(to)];
    if (!a || !b) return false;
    const lengthM = from.distanceTo(to);
    ray.set(from, to.clone().sub(from).normalize());
    const range = (axis: 0 | 1, size: number) =>
      [Math.max(0, Math.floor(Math.min(a[axis], b[axis])) - 1), Math.min(size - 2, Math.ceil(Math.max(a[axis], b[axis])) + 1)] as const;
    const [i0, i1] = range(0, width);
    const [j0, j1] = range(1, height);
    for (let j = j0; j <= j1; j++) {
      for (let i = i0; i <= i1; i++) {
        const n = j * width + i;
        const corners = [n, n + 1, n + width + 1, n + width];
        if (!corners.every((k) => isMeasured(frame.meters[k]))) continue;
        const [p, q, s, t] = corners.map((k) => points[k]) as [Vector3, Vector3, Vector3, Vector3];
        if (Math.max(p.distanceTo(q), q.distanceTo(s), s.distanceTo(t), t.distanceTo(p)) > BORDER_M) continue;
        for (const [u, v] of [
          [q, s],
          [s, t],
        ] as const) {
          const met = ray.intersectTriangle(p, u, v, false, hit);
          if (met && met.distanceTo(from) <= lengthM) return true;
        }
      }
    }
    return false;
  };
}
