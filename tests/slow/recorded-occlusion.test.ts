import { execFile } from 'node:child_process';
import { copyFile, mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import process from 'node:process';
import { promisify } from 'node:util';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import type { FrameScore } from '../../app/cli/score/score.page.ts';
import { occlusionIou } from '../../export/score/occlusion.ts';
import { projectText, writeProject } from '../support/project-kit.ts';
import { scrim } from '../support/scrim.ts';
import { describeWithData } from '../support/shared-data.ts';

const ROOT = resolve(import.meta.dirname, '../..');
/** Every third frame of the recording. */
const POSES = 20;
const STRIDE = 3;

/** A tripod camera, 0.65 m tall, that stands in the cantilever chair: its seat and arms hide parts from everywhere. */
const GRAPH = {
  nodes: {
    'model-a1b2': ['source/model', { model: 'camera' }],
    'place-a1b2': ['objects/transform', { positionM: [0.3, 0, -1.72], scale: 0.09 }],
    'light-a1b2': 'light/directional',
    'scene-a1b2': 'layer/scene',
    'depth-a1b2': 'world/depth',
    'hide-a1b2': 'layer/depth-occlusion',
    // A pixel is seen or hidden as a whole.
    'screen-a1b2': ['output/screen', { antialias: false }],
  },
  wires: [
    'model-a1b2.objects -> place-a1b2.objects',
    'place-a1b2.objects -> scene-a1b2.objects',
    'light-a1b2.lights -> scene-a1b2.lights',
    'scene-a1b2.layer -> hide-a1b2.layer',
    'depth-a1b2.depth -> hide-a1b2.depth',
    'hide-a1b2.layer -> screen-a1b2.layer',
  ],
  assets: { camera: { path: 'assets/camera.glb', kind: 'model' } },
} as const;

describeWithData('occlusion on a recorded room', 'sessions/icl-livingroom', (recording) => {
  let base = '';
  let frames: readonly FrameScore[] = [];

  beforeAll(async () => {
    base = await mkdtemp(join(tmpdir(), 'scrim-occlusion-'));
    const session = join(base, 'project', 'sessions', 'room');
    await mkdir(dirname(session), { recursive: true });
    await promisify(execFile)(process.execPath, [join(ROOT, 'tools/run.mjs'), 'sessions/convert-session.ts', recording, session]);
    await thinOut(join(session, 'session.json'));
    await writeProject(join(base, 'project'), { 'project.scrim.json': projectText(GRAPH) });
    await mkdir(join(base, 'project', 'assets'));
    await copyFile(resolve(recording, '../../models/AntiqueCamera.glb'), join(base, 'project', 'assets', 'camera.glb'));
    const { out } = await scrim('score', join(base, 'project'), '--session', session, '--json');
    frames = (JSON.parse(out) as { readonly frames: readonly FrameScore[] }).frames;
  });
  afterAll(() => rm(base, { recursive: true, force: true }));

  async function thinOut(file: string): Promise<void> {
    const content = JSON.parse(await readFile(file, 'utf8')) as { frames: unknown[] };
    await writeFile(file, JSON.stringify({ ...content, frames: content.frames.filter((_, i) => i % STRIDE === 1) }));
  }

  test(`at ${POSES} poses, each hiding 30 to 70 % of the model, what is seen and what is hidden are what the depths say`, () => {
    expect(frames).toHaveLength(POSES);
    const scores = frames.map(({ index, occlusion }) => ({ index, ...occlusionIou(occlusion.filter((counts) => counts !== null)) }));
    console.info(
      [
        'frame  hidden  IoU visible  IoU hidden',
        ...scores.map((s) => `${s.index}  ${s.hiddenShare.toFixed(2)}  ${s.visible.toFixed(4)}  ${s.hidden.toFixed(4)}`),
      ].join('\n'),
    );
    for (const pose of scores) {
      expect(Math.abs(pose.hiddenShare - 0.5)).toBeLessThanOrEqual(0.2);
      expect(pose.visible).toBeGreaterThanOrEqual(0.97);
      expect(pose.hidden).toBeGreaterThanOrEqual(0.97);
    }
  });
});
