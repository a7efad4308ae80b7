import { execFile } from 'node:child_process';
import { copyFile, mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import process from 'node:process';
import { promisify } from 'node:util';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { decode } from 'fast-png';
import { projectText, writeProject } from '../support/project-kit.ts';
import { succeed } from '../support/scrim.ts';
import { describeWithData } from '../support/shared-data.ts';

const ROOT = resolve(import.meta.dirname, '../..');
/** Every third frame of the recording. */
const POSES = 20;
const STRIDE = 3;
/** Depth pictures and rendered depths are in millimeters. */
const MM = 0.001;

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

interface Grid {
  readonly width: number;
  readonly height: number;
  readonly channels: number;
  readonly data: ArrayLike<number>;
}

interface Scores {
  readonly frame: number;
  readonly hiddenShare: number;
  readonly visible: number;
  readonly hidden: number;
}

describeWithData('occlusion on a recorded room', 'sessions/icl-livingroom', (recording) => {
  let base = '';
  let scores: Scores[] = [];

  beforeAll(async () => {
    base = await mkdtemp(join(tmpdir(), 'scrim-occlusion-'));
    const session = join(base, 'project', 'sessions', 'room');
    await mkdir(dirname(session), { recursive: true });
    await promisify(execFile)(process.execPath, [join(ROOT, 'tools/run.mjs'), 'sessions/convert-session.ts', recording, session]);
    const frames = await thinOut(join(session, 'session.json'));
    await writeProject(join(base, 'project'), { 'project.scrim.json': projectText(GRAPH) });
    await mkdir(join(base, 'project', 'assets'));
    await copyFile(resolve(recording, '../../models/AntiqueCamera.glb'), join(base, 'project', 'assets', 'camera.glb'));
    await render('occluded', '--layer', 'hide-a1b2.layer');
    await render('depth', '--depth', 'scene-a1b2.layer');
    scores = await Promise.all(frames.map(({ depth }, frame) => score(frame, join(session, depth))));
  });
  afterAll(() => rm(base, { recursive: true, force: true }));

  async function thinOut(file: string): Promise<readonly { readonly depth: string }[]> {
    const content = JSON.parse(await readFile(file, 'utf8')) as { frames: { depth: string }[] };
    const frames = content.frames.filter((_, i) => i % STRIDE === 1);
    await writeFile(file, JSON.stringify({ ...content, frames }));
    return frames;
  }

  function render(name: string, ...what: string[]): Promise<void> {
    return succeed('render', join(base, 'project'), '--out', join(base, name), '--frames', `0..${POSES - 1}`, ...what);
  }

  /**
   * What is seen and what is hidden, as the rendered layer has it and as the model's own depth against the recording's raw depth
   * has it. Pixels whose depth the recording does not know are left out.
   */
  async function score(frame: number, rawDepthFile: string): Promise<Scores> {
    const name = `${String(frame).padStart(6, '0')}.png`;
    const [occluded, model, raw] = await Promise.all(
      [join(base, 'occluded', name), join(base, 'depth', name), rawDepthFile].map(
        async (path): Promise<Grid> => decode(await readFile(path)),
      ),
    );
    if (!occluded || !model || !raw) throw new Error('A picture is missing.');
    expect([occluded.width, occluded.height, model.width, raw.width]).toEqual([640, 480, 640, 640]);
    const visible = { both: 0, either: 0 };
    const hidden = { both: 0, either: 0 };
    let truth = 0;
    let covered = 0;
    for (let i = 0; i < raw.data.length; i++) {
      const modelM = (model.data[i] ?? 0) * MM;
      const roomM = (raw.data[i] ?? 0) * MM;
      if (modelM === 0 || roomM === 0) continue;
      const shown = (occluded.data[i * 4 + 3] ?? 0) > 127;
      const isHidden = modelM > roomM;
      covered++;
      if (isHidden) truth++;
      if (shown || !isHidden) visible.either++;
      if (shown && !isHidden) visible.both++;
      if (!shown || isHidden) hidden.either++;
      if (!shown && isHidden) hidden.both++;
    }
    return { frame, hiddenShare: truth / covered, visible: visible.both / visible.either, hidden: hidden.both / hidden.either };
  }

  test(`at ${POSES} poses, each hiding 30 to 70 % of the model, what is seen and what is hidden are what the depths say`, () => {
    expect(scores).toHaveLength(POSES);
    for (const { hiddenShare } of scores) expect(Math.abs(hiddenShare - 0.5)).toBeLessThanOrEqual(0.2);
    console.info(
      [
        'frame  hidden  IoU visible  IoU hidden',
        ...scores.map((s) => `${s.frame}  ${s.hiddenShare.toFixed(2)}  ${s.visible.toFixed(4)}  ${s.hidden.toFixed(4)}`),
      ].join('\n'),
    );
    for (const pose of scores) {
      expect(pose.visible).toBeGreaterThanOrEqual(0.97);
      expect(pose.hidden).toBeGreaterThanOrEqual(0.97);
    }
  });
});
