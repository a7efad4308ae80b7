import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { link, mkdir, mkdtemp, readdir, readFile, rm, stat, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import process from 'node:process';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import sharp from 'sharp';
import { readCapture } from '../../nodes/kit/capture.ts';
import { projectText, writeProject } from '../support/project-kit.ts';

let base = '';
let scan = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-large-'));
  scan = join(base, 'scan');
  await writeScan();
});
afterAll(() => rm(base, { recursive: true, force: true }));

const [WIDTH, HEIGHT] = [4000, 3000];
const COUNT = 200;
const DIFFERENT = 4;
const MOST_MB = 1500;
/** Longest side of what 200 photographs are packed to. Smaller ones are encoded in a tenth of the time; the encoder takes 300 MB less then. */
const SIDE_PX = 400;
const MOST_SMALL_MB = MOST_MB - 300;
/** When an import of the usual size is canceled: two photographs are packed at a time, and memory does not grow with their number. */
const FEW = 8;
const SMALL = ['--size', String(SIDE_PX)];
/** When the first import is canceled. */
const CANCELED_AT = 60;

/** Writes photographs of 12 megapixels with the detail of an enlarged one, and cameras on a circle around a square. */
async function writeScan(): Promise<void> {
  await mkdir(join(scan, 'images'), { recursive: true });
  const noise = { type: 'gaussian', mean: 128, sigma: 60 } as const;
  for (let i = 0; i < DIFFERENT; i++) {
    const coarse = await sharp({ create: { width: WIDTH / 8, height: HEIGHT / 8, channels: 3, background: 'gray', noise } })
      .png({ compressionLevel: 0 })
      .toBuffer();
    await sharp(coarse)
      .resize(WIDTH, HEIGHT)
      .jpeg({ quality: 90 })
      .toFile(join(scan, `images/${i}.jpg`));
  }
  for (let i = DIFFERENT; i < COUNT; i++) await link(join(scan, `images/${i % DIFFERENT}.jpg`), join(scan, `images/${i}.jpg`));
  const frames = Array.from({ length: COUNT }, (_, i) => {
    const [sin, cos] = [Math.sin(i / 2), Math.cos(i / 2)];
    const transform_matrix = [
      [cos, 0, sin, 2 * sin],
      [0, 1, 0, 0],
      [-sin, 0, cos, 2 * cos],
      [0, 0, 0, 1],
    ];
    // Each has another lens, so that all are drawn, and none is taken from the cache.
    return { file_path: `images/${i}.jpg`, transform_matrix, fl_x: 3200 + i, fl_y: 3200, k1: -0.08, p1: 0.001 };
  });
  const camera = { camera_model: 'OPENCV', w: WIDTH, h: HEIGHT, cx: WIDTH / 2, cy: HEIGHT / 2 };
  await writeFile(join(scan, 'transforms.json'), JSON.stringify({ ...camera, frames }));
  await writeFile(join(scan, 'mesh.obj'), 'v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n');
}

/** Shows progress as in a terminal, and prints the peak of the memory of the process with its threads at its end, in KB. */
const PRELOAD = `import { readFileSync } from 'node:fs';
process.stderr.isTTY = true;
process.on('exit', () => process.stderr.write('peak ' + /VmHWM:\\s+(\\d+)/.exec(readFileSync('/proc/self/status', 'utf8'))?.[1]));`;

interface Import {
  readonly status: number | null;
  readonly said: string;
  readonly errors: string;
  readonly peakMb: number;
}

/** @param cancelAt Cancels it, as Ctrl-C does, when it says that it packs this photograph. */
async function importScan(project: string, cancelAt: number | null, ...options: readonly string[]): Promise<Import> {
  const args = [resolve('bin/scrim.mjs'), 'import', 'capture', scan, '--project', project, '--name', 'scan', ...options, '--json'];
  const { NODE_OPTIONS: _, ...env } = process.env;
  const preload = `data:text/javascript,${encodeURIComponent(PRELOAD)}`;
  const child = spawn(process.execPath, ['--import', preload, ...args], { env, stdio: ['ignore', 'pipe', 'pipe'] });
  let [said, errors] = ['', ''];
  let isCanceled = false;
  child.stdout.on('data', (chunk) => {
    said += String(chunk);
  });
  child.stderr.on('data', (chunk) => {
    errors += String(chunk);
    if (isCanceled || !errors.includes(`(${cancelAt} of ${COUNT})`)) return;
    isCanceled = true;
    child.kill('SIGINT');
  });
  try {
    const [status] = (await once(child, 'close')) as [number | null];
    return { status, said, errors, peakMb: Number(/peak (\d+)/.exec(errors)?.[1]) / 1024 };
  } finally {
    child.kill('SIGKILL');
  }
}

/** The files of packed photographs that the project keeps, with the numbers that tell whether one was written again. */
async function keptPhotographs(project: string): Promise<ReadonlyMap<string, number>> {
  const folder = join(project, '.scrim/cache');
  const names = (await readdir(folder)).filter((name) => name.startsWith('packed-'));
  return new Map(await Promise.all(names.map(async (name) => [name, (await stat(join(folder, name))).ino] as const)));
}

async function newProject(name: string): Promise<string> {
  const project = join(base, name);
  await writeProject(project, { 'project.scrim.json': projectText({ nodes: { 'screen-a1': 'output/screen' }, wires: [] }) });
  return project;
}

test('200 photographs of 12 megapixels are imported in 1.5 GB, with progress, and after a cancel from where it was', async () => {
  const project = await newProject('project');
  const before = await readFile(join(project, 'project.scrim.json'), 'utf8');

  const canceled = await importScan(project, CANCELED_AT, ...SMALL);
  expect(canceled.errors).toContain('Interrupted. Nothing was written.');
  expect(canceled.status).toBe(130);
  expect(await readdir(join(project, 'assets')).catch(() => [])).toEqual([]);
  expect(await readFile(join(project, 'project.scrim.json'), 'utf8')).toBe(before);
  const kept = await keptPhotographs(project);
  expect(kept.size).toBeGreaterThanOrEqual(CANCELED_AT - 1);
  expect(kept.size).toBeLessThan(CANCELED_AT + 10);

  const { status, said, errors, peakMb } = await importScan(project, null, ...SMALL);
  expect(status).toBe(0);
  expect(JSON.parse(said)).toMatchObject({ ok: true, path: 'assets/scan.capture/capture.json', views: { length: COUNT } });
  for (const i of [1, CANCELED_AT, COUNT]) expect(errors).toContain(`Packing photographs (${i} of ${COUNT})…`);
  const all = await keptPhotographs(project);
  expect(all.size).toBe(COUNT);
  expect([...kept].filter(([name, written]) => all.get(name) !== written)).toEqual([]);
  const folder = join(project, 'assets/scan.capture');
  const { views } = readCapture(await readFile(join(folder, 'capture.json'), 'utf8'));
  expect(views).toHaveLength(COUNT);
  for (const i of [0, CANCELED_AT, COUNT - 1]) {
    const { width, height } = await sharp(join(folder, views[i]?.file ?? '')).metadata();
    expect([width, height]).toEqual([SIDE_PX, (SIDE_PX * HEIGHT) / WIDTH]);
  }

  if (process.env.SCRIM_PICTURES) console.log(canceled.peakMb, peakMb);
  for (const peak of [canceled.peakMb, peakMb]) {
    expect(peak).toBeGreaterThan(100);
    expect(peak).toBeLessThan(MOST_SMALL_MB);
  }
});

test('photographs of 12 megapixels that are packed in the usual size take 1.5 GB', async () => {
  const { errors, status, peakMb } = await importScan(await newProject('usual'), FEW);
  expect(errors).toContain('Interrupted.');
  expect(status).toBe(130);
  if (process.env.SCRIM_PICTURES) console.log(peakMb);
  expect(peakMb).toBeGreaterThan(100);
  expect(peakMb).toBeLessThan(MOST_MB);
});
