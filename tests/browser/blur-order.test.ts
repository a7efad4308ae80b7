import { copyFile, mkdir, mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { decode } from 'fast-png';
import { projectText, writeProject } from '../support/project-kit.ts';
import { succeed } from '../support/scrim.ts';

const ROOT = resolve(import.meta.dirname, '../..');
const WIDTH = 480;
const HEIGHT = 360;
/** Standard deviation of the blur; it reaches three of them. */
const BLUR_PX = 3;
const REACH_PX = 3 * BLUR_PX + 3;
/** An edge, in steps of 8 bits. */
const EDGE = 64;

/** What both scenes of the paper's Figure 5 share: a model, a video, a blur, edges; they differ in their wires. */
const NODES = {
  'video-a1b2': 'source/camera-video',
  'model-a1b2': ['source/model', { model: 'robot', playing: false }],
  'place-a1b2': ['objects/transform', { positionM: [0, 0.3, 0], scale: 2 }],
  'light-a1b2': 'light/directional',
  'scene-a1b2': 'layer/scene',
  'blur-a1b2': ['filter/gaussian-blur', { radius: BLUR_PX }],
  'over-a1b2': 'operator/over',
  'edges-a1b2': ['filter/sobel-edges', { strength: 2 }],
  'screen-a1b2': 'output/screen',
} as const;

const SHARED_WIRES = [
  'model-a1b2.objects -> place-a1b2.objects',
  'place-a1b2.objects -> scene-a1b2.objects',
  'light-a1b2.lights -> scene-a1b2.lights',
  'scene-a1b2.layer -> over-a1b2.top',
  'edges-a1b2.layer -> screen-a1b2.layer',
];
const BLUR_BEFORE = [
  'video-a1b2.layer -> blur-a1b2.inputImage',
  'blur-a1b2.layer -> over-a1b2.bottom',
  'over-a1b2.layer -> edges-a1b2.inputImage',
];
const BLUR_AFTER = [
  'video-a1b2.layer -> over-a1b2.bottom',
  'over-a1b2.layer -> blur-a1b2.inputImage',
  'blur-a1b2.layer -> edges-a1b2.inputImage',
];

interface Picture {
  readonly data: ArrayLike<number>;
}

/**
 * "A Mixed-Reality Rendering Framework for Photorealistic and Non-Photorealistic Rendering", §3.1.3: in Scene A the video is
 * blurred before it is merged with the model and edges are found; in Scene B after.
 */
describe('scenes A and B of the mixed-reality paper', () => {
  let base = '';
  let before: Picture;
  let after: Picture;
  let mask: boolean[];

  beforeAll(async () => {
    base = await mkdtemp(join(tmpdir(), 'scrim-blur-'));
    before = await render('a', BLUR_BEFORE);
    after = await render('b', BLUR_AFTER);
    const model = await render('a', BLUR_BEFORE, '--layer', 'scene-a1b2.layer');
    mask = Array.from({ length: WIDTH * HEIGHT }, (_, i) => (model.data[i * 4 + 3] ?? 0) > 127);
  });
  afterAll(() => rm(base, { recursive: true, force: true }));

  async function render(name: string, wires: readonly string[], ...what: string[]): Promise<Picture> {
    const project = join(base, name);
    const assets = { robot: { path: 'assets/robot.glb', kind: 'model' } } as const;
    await writeProject(project, { 'project.scrim.json': projectText({ nodes: NODES, wires: [...SHARED_WIRES, ...wires], assets }) });
    await mkdir(join(project, 'assets'), { recursive: true });
    await copyFile(join(ROOT, 'examples/first-light/assets/robot.glb'), join(project, 'assets/robot.glb'));
    const out = join(base, `${name}.png`);
    const session = join(ROOT, 'examples/sessions/studio');
    await succeed('render', project, '--out', out, '--session', session, '--size', `${WIDTH}x${HEIGHT}`, ...what);
    return decode(await readFile(out));
  }

  /** Of the pixels that `where` chooses, the share that lies on an edge. */
  function edgeDensity({ data }: Picture, where: (i: number) => boolean): number {
    let chosen = 0;
    let edges = 0;
    for (let i = 0; i < WIDTH * HEIGHT; i++) {
      if (!where(i)) continue;
      chosen++;
      if ((data[i * 4] ?? 0) > EDGE) edges++;
    }
    return edges / chosen;
  }

  test('blurring the video first keeps the model’s detailed lines, blurring all of it leaves coarse ones', () => {
    const detailed = edgeDensity(before, (i) => mask[i] ?? false);
    const coarse = edgeDensity(after, (i) => mask[i] ?? false);
    console.info(`edges inside the model: ${detailed.toFixed(3)} with the video blurred, ${coarse.toFixed(3)} with everything blurred`);
    expect(mask.filter(Boolean).length).toBeGreaterThan(4000);
    expect(detailed).toBeGreaterThan(0.15);
    expect(detailed).toBeGreaterThan(5 * coarse);
  });

  test('farther from the model than the blur reaches, both are the same picture', () => {
    const near = grow(mask, REACH_PX);
    let compared = 0;
    let different = 0;
    for (let i = 0; i < WIDTH * HEIGHT; i++) {
      if (near[i]) continue;
      compared++;
      if ([0, 1, 2, 3].some((c) => Math.abs((before.data[i * 4 + c] ?? 0) - (after.data[i * 4 + c] ?? 0)) > 1)) different++;
    }
    expect(compared).toBeGreaterThan(50_000);
    expect(different).toBe(0);
  });
});

/** True within `reach` pixels of a true one, along rows and then along columns. */
function grow(mask: readonly boolean[], reach: number): boolean[] {
  const along = (from: readonly boolean[], step: number, length: number, at: (i: number) => number): boolean[] =>
    from.map((_, i) => {
      const here = at(i);
      for (let d = Math.max(-reach, -here); d <= Math.min(reach, length - 1 - here); d++) if (from[i + d * step]) return true;
      return false;
    });
  const rows = along(mask, 1, WIDTH, (i) => i % WIDTH);
  return along(rows, WIDTH, HEIGHT, (i) => Math.floor(i / WIDTH));
}
