import { cp, mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { type Acquired, acquire } from '../support/acquisition.ts';
import { type ProjectText, projectText, writeProject } from '../support/project-kit.ts';

const BALL = 'nodes/source/capture/example/assets/glossy-ball.capture';
const CAMERA = ['--shape', 'grid', '--count', '1x1x1', '--extent', '0', '--center', '0,0.7,1.4', '--fov', '60', '--size', '320x240'];
/** Two captured balls, which go through each other and through each other’s floor. */
const LEFT = { 'left-a1': ['source/capture', { file: 'ball', method: 'nearest' }] } as const;
const RIGHT = { 'right-a1': ['source/capture', { file: 'ball', positionM: [0.3, 0.12, -0.1], rotationRad: [0.2, 0.9, 0] }] } as const;

let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-depth-merge-'));
  await cp(resolve(BALL), join(base, 'assets/ball.capture'), { recursive: true });
});
afterAll(() => rm(base, { recursive: true, force: true }));

async function take(nodes: ProjectText['nodes'], ...wires: readonly string[]): Promise<Acquired> {
  const assets = { ball: { path: 'assets/ball.capture/capture.json', kind: 'capture' } } as const;
  await writeProject(base, { 'project.scrim.json': projectText({ nodes: { ...nodes, 'screen-a1': 'output/screen' }, wires, assets }) });
  const out = join(base, 'taken');
  const [picture] = await acquire(base, out, ...CAMERA);
  if (process.env.SCRIM_PICTURES)
    await cp(join(out, 'images'), join(process.env.SCRIM_PICTURES, `merge-${wires.length}`), { recursive: true });
  if (!picture) throw new Error('Nothing was photographed.');
  return picture;
}

/** Fully covered, or empty: edges blend what is in front with what is behind. */
const isWhole = ({ pixels }: Acquired, i: number): boolean => (pixels[4 * i + 3] ?? 0) % 255 === 0;

test.each([
  ['left-a1', 'right-a1'],
  ['right-a1', 'left-a1'],
])('two captures in one place are merged by depth, %s first: each pixel shows and has the nearer one', async (first, second) => {
  const left = await take(LEFT, 'left-a1.layer -> screen-a1.layer');
  const right = await take(RIGHT, 'right-a1.layer -> screen-a1.layer');
  const both = await take(
    { ...LEFT, ...RIGHT, 'merge-a1': 'operator/depth-merge' },
    ...[`${first}.layer -> merge-a1.first`, `${second}.layer -> merge-a1.second`, 'merge-a1.layer -> screen-a1.layer'],
  );
  const count = { left: 0, right: 0, overlapping: 0, wrong: 0 };
  both.meters.forEach((meters, i) => {
    if (!isWhole(left, i) || !isWhole(right, i)) return;
    const [leftM, rightM] = [left.meters[i] ?? 0, right.meters[i] ?? 0];
    if (leftM === 0 && rightM === 0) return;
    const isLeft = rightM === 0 || (leftM > 0 && leftM < rightM);
    count[isLeft ? 'left' : 'right']++;
    if (leftM > 0 && rightM > 0) count.overlapping++;
    const nearer = isLeft ? left : right;
    const differs = [0, 1, 2].some((c) => Math.abs((nearer.pixels[4 * i + c] ?? 0) - (both.pixels[4 * i + c] ?? 0)) > 1);
    if (differs || meters !== nearer.meters[i]) count.wrong++;
  });
  expect(count.overlapping).toBeGreaterThan(4000);
  expect(Math.min(count.left, count.right)).toBeGreaterThan(3000);
  expect(count.wrong).toBe(0);
});
