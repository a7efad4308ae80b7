import { execFile } from 'node:child_process';
import { copyFile, mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import process from 'node:process';
import { promisify } from 'node:util';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import sharp from 'sharp';
import { projectText, writeProject } from '../support/project-kit.ts';

let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-large-'));
});
afterAll(() => rm(base, { recursive: true, force: true }));

const [WIDTH, HEIGHT] = [4000, 3000];
/** Prints the peak of the memory of a process at its end, in KB. */
const PEAK = 'data:text/javascript,process.on("exit",()=>process.stderr.write("peak "+process.resourceUsage().maxRSS))';

/** Imports photographs of 12 megapixels, which are distorted and so are drawn again. Returns the peak of memory in MB. */
async function importMany(photograph: Buffer, count: number): Promise<number> {
  const [scan, project] = [join(base, `scan-${count}`), join(base, `project-${count}`)];
  await mkdir(join(scan, 'images'), { recursive: true });
  await writeFile(join(scan, 'images/0.jpg'), photograph);
  for (let i = 1; i < count; i++) await copyFile(join(scan, 'images/0.jpg'), join(scan, `images/${i}.jpg`));
  // Cameras on a circle around a square; each has another lens, so that none is taken from the cache.
  const frames = Array.from({ length: count }, (_, i) => {
    const [sin, cos] = [Math.sin(i / 2), Math.cos(i / 2)];
    const transform_matrix = [
      [cos, 0, sin, 2 * sin],
      [0, 1, 0, 0],
      [-sin, 0, cos, 2 * cos],
      [0, 0, 0, 1],
    ];
    return { file_path: `images/${i}.jpg`, transform_matrix, fl_x: 3200 + i, fl_y: 3200, k1: -0.08, p1: 0.001 };
  });
  const camera = { camera_model: 'OPENCV', w: WIDTH, h: HEIGHT, cx: WIDTH / 2, cy: HEIGHT / 2 };
  await writeFile(join(scan, 'transforms.json'), JSON.stringify({ ...camera, frames }));
  await writeFile(join(scan, 'mesh.obj'), 'v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n');
  await writeProject(project, { 'project.scrim.json': projectText({ nodes: { 'screen-a1': 'output/screen' }, wires: [] }) });
  const args = ['--import', PEAK, resolve('bin/scrim.mjs'), 'import', 'capture', scan, '--project', project, '--json'];
  const { stdout, stderr } = await promisify(execFile)(process.execPath, args);
  expect(JSON.parse(stdout)).toMatchObject({ ok: true, views: { length: count } });
  return Number(/peak (\d+)/.exec(stderr)?.[1]) / 1024;
}

test('photographs of 12 megapixels are imported one by one: many take no more memory than a few', async () => {
  const create = { width: WIDTH, height: HEIGHT, channels: 3, noise: { type: 'gaussian', mean: 128, sigma: 30 } } as const;
  const photograph = await sharp({ create: { ...create, background: 'gray' } })
    .jpeg({ quality: 85 })
    .toBuffer();
  const few = await importMany(photograph, 2);
  const many = await importMany(photograph, 6);
  if (process.env.SCRIM_PICTURES) console.log(few, many);
  expect(few).toBeGreaterThan(100);
  expect(many).toBeLessThan(few + 150);
  expect(many).toBeLessThan(1500);
});
