import { execFile } from 'node:child_process';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import process from 'node:process';
import { promisify } from 'node:util';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { encode } from 'fast-png';
import type { FrameScore } from '../../app/cli/score/score.page.ts';
import type { ScoreSummary } from '../../app/cli/score/score-summary.ts';
import { type ProjectText, projectText, writeProject } from '../support/project-kit.ts';
import { scrim } from '../support/scrim.ts';
import { describeWithData } from '../support/shared-data.ts';

const ROOT = resolve(import.meta.dirname, '../..');
const [WIDTH, HEIGHT, FRAMES] = [64, 48, 3];
const WALL_M = 2;
/** The focal length is as wide as the image, so a step of 2 / 64 of the distance moves the wall by 2 px. */
const STEP_PX = 2;

let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-score-'));
});
afterAll(() => rm(base, { recursive: true, force: true }));

interface Recording {
  readonly stepPx: number;
  /** Depth of a column of the image, millimeters. */
  readonly depthMm: (x: number) => number;
}

/** A wall with a drawn-on texture, before which the camera walks to the right. */
async function writeRecording(name: string, { stepPx, depthMm }: Recording): Promise<string> {
  const intrinsics = { fxPx: WIDTH, fyPx: WIDTH, cxPx: WIDTH / 2, cyPx: HEIGHT / 2 };
  const size = { widthPx: WIDTH, heightPx: HEIGHT, intrinsics };
  const files: Record<string, string | Uint8Array> = {};
  const frames = Array.from({ length: FRAMES }, (_, frame) => {
    const pixels = Array.from({ length: WIDTH * HEIGHT }, (_, i) => {
      const [x, y] = [(i % WIDTH) + stepPx * frame, Math.floor(i / WIDTH)];
      return [40 + ((x * x * 7 + y * 3) % 128), 60 + ((x * 31 + y * y) % 128), 80, 255];
    });
    const depth = Array.from({ length: WIDTH * HEIGHT }, (_, i) => depthMm(i % WIDTH));
    files[`${frame}.png`] = encode({ width: WIDTH, height: HEIGHT, data: Uint8Array.from(pixels.flat()), channels: 4, depth: 8 });
    files[`${frame}.depth.png`] = encode({ width: WIDTH, height: HEIGHT, data: Uint16Array.from(depth), channels: 1, depth: 16 });
    const xM = (frame * stepPx * WALL_M) / WIDTH;
    return {
      timeS: frame,
      color: `${frame}.png`,
      depth: `${frame}.depth.png`,
      worldFromCamera: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, xM, 0, 0, 1],
    };
  });
  const head = { format: 'scrim-session', version: 1, title: name, color: size, frameRateHz: 1 };
  files['session.json'] = JSON.stringify({ ...head, depth: { ...size, metresPerUnit: 0.001, kind: 'z' }, frames });
  const folder = join(base, name);
  await writeProject(folder, files);
  return folder;
}

interface Answer extends ScoreSummary {
  readonly ok: boolean;
  readonly frames: readonly FrameScore[];
  readonly diagnostics: readonly { readonly code: string; readonly message: string }[];
}

async function score(project: string, session: string, ...options: string[]): Promise<{ readonly status: number; readonly json: Answer }> {
  const { status, out } = await scrim('score', project, '--session', session, ...options, '--json');
  return { status, json: JSON.parse(out) as Answer };
}

let projects = 0;
async function projectOf(text: ProjectText, files: Readonly<Record<string, string>> = {}): Promise<string> {
  const folder = join(base, `project-${projects++}`);
  await writeProject(folder, { 'project.scrim.json': projectText(text), ...files });
  return folder;
}

/** A box of half a meter, whose front is at 1.75 m: 18 px wide around the middle. */
const box = (occlusion: Readonly<Record<string, unknown>> | null): ProjectText => ({
  nodes: {
    'video-a1b2': 'source/camera-video',
    'depth-a1b2': ['world/depth', { filter: 'nearest', fillHoles: false }],
    'box-a1b2': ['objects/primitive', { sizeM: [0.5, 0.5, 0.5], color: [1, 0, 0, 1] }],
    'place-a1b2': ['objects/transform', { positionM: [0, 0, -2] }],
    'scene-a1b2': 'layer/scene',
    'hide-a1b2': ['layer/depth-occlusion', occlusion ?? {}],
    'over-a1b2': 'operator/over',
    'screen-a1b2': ['output/screen', { antialias: false }],
  },
  wires: [
    'box-a1b2.objects -> place-a1b2.objects',
    'place-a1b2.objects -> scene-a1b2.objects',
    'scene-a1b2.layer -> hide-a1b2.layer',
    'depth-a1b2.depth -> hide-a1b2.depth',
    `${occlusion ? 'hide' : 'scene'}-a1b2.layer -> over-a1b2.top`,
    'video-a1b2.layer -> over-a1b2.bottom',
    'over-a1b2.layer -> screen-a1b2.layer',
  ],
});

/** The camera video through a shader of the project. */
const filtered: ProjectText = {
  nodes: { 'video-a1b2': 'source/camera-video', 'own-a1b2': 'filter/own', 'screen-a1b2': 'output/screen' },
  wires: ['video-a1b2.layer -> own-a1b2.inputImage', 'own-a1b2.layer -> screen-a1b2.layer'],
};
const HEADER = '/*{ "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }] }*/\n';
const PLAIN = `${HEADER}void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }`;
/** White and black columns, two of each, which stay on the screen. */
const SCREEN_STRIPES = `${HEADER}void main() { gl_FragColor = vec4(vec3(step(2.0, mod(gl_FragCoord.x, 4.0))), 1.0); }`;
const BRIGHTER = `${HEADER}void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage) + vec4(vec3(30.0 / 255.0), 0.0); }`;

describe('occlusion over a recording whose left half is nearer than the box', () => {
  let session = '';
  beforeAll(async () => {
    session = await writeRecording('halves', { stepPx: 0, depthMm: (x) => (x < WIDTH / 2 ? 1500 : 3000) });
  });

  test('that is right has an IoU of 1; a static camera has no flicker', async () => {
    const { status, json } = await score(
      await projectOf(box({})),
      session,
      '--min-iou',
      '1',
      '--max-flicker',
      '0',
      '--max-tone-error',
      '0',
    );
    expect(json.diagnostics).toEqual([]);
    expect([status, json.ok]).toEqual([0, true]);
    const right = { visibleIou: 1, hiddenIou: 1, hiddenShare: 0.5 };
    expect(json.occlusion).toEqual({ ...right, layers: [{ layer: 'hide-a1b2.layer', ...right }] });
    expect(json.flicker).toMatchObject({ mean: 0, reference: 0 });
    expect(json.contrastKept).toEqual({ least: 1, reference: 1 });
    expect(json.toneError).toBe(0);
    expect(json.frames).toHaveLength(FRAMES);
  });

  test.each([
    ['that hides nothing because of its bias', { biasM: 0.5 }, 'hide'],
    ['that is missing', null, 'scene'],
  ])('%s has half of the pixels right, and fails the limit', async (_name, occlusion, node) => {
    const { status, json } = await score(await projectOf(box(occlusion)), session, '--min-iou', '0.9');
    expect([status, json.ok]).toEqual([1, false]);
    const half = { visibleIou: 0.5, hiddenIou: 0, hiddenShare: 0.5 };
    expect(json.occlusion).toEqual({
      ...half,
      layers: [{ layer: `${node}-a1b2.layer`, ...half }],
    });
    expect(json.diagnostics).toEqual([
      expect.objectContaining({ code: 'SCR077', message: 'The IoU of what is visible is 0.5, below the limit of 0.9.' }),
    ]);
  });
});

test('a Scene without occlusion counts beside one that has an occlusion', async () => {
  const session = await writeRecording('both', { stepPx: 0, depthMm: (x) => (x < WIDTH / 2 ? 1500 : 3000) });
  const { nodes, wires } = box({});
  const project = await projectOf({
    nodes: { ...nodes, 'bare-a1b2': 'layer/scene', 'both-a1b2': 'operator/over' },
    wires: [
      ...wires.filter((wire) => !wire.endsWith('screen-a1b2.layer')),
      'place-a1b2.objects -> bare-a1b2.objects',
      'over-a1b2.layer -> both-a1b2.bottom',
      'bare-a1b2.layer -> both-a1b2.top',
      'both-a1b2.layer -> screen-a1b2.layer',
    ],
  });
  const { json } = await score(project, session);
  expect(json.occlusion?.layers.map(({ layer, visibleIou }) => [layer, visibleIou])).toEqual([
    ['hide-a1b2.layer', 1],
    ['bare-a1b2.layer', 0.5],
  ]);
});

describe('styles over a walk along a wall', () => {
  let session = '';
  beforeAll(async () => {
    session = await writeRecording('wall', { stepPx: STEP_PX, depthMm: () => WALL_M * 1000 });
  });

  test('the camera video has no flicker, and what stays on the screen has all', async () => {
    const plain = await score(await projectOf(filtered, { 'shaders/own.fs': PLAIN }), session);
    expect(plain.json.flicker).toMatchObject({ mean: 0, worst: 0, reference: 0, compared: (WIDTH - STEP_PX) / WIDTH });
    expect(plain.json.toneError).toBe(0);
    expect(plain.json.occlusion).toBeNull();
    // Two pixels further, white columns are black.
    const stripes = await score(await projectOf(filtered, { 'shaders/own.fs': SCREEN_STRIPES }), session, '--max-flicker', '10');
    expect(stripes.json.flicker).toMatchObject({ mean: 255, worst: 255, reference: 0 });
    expect(stripes.status).toBe(1);
  });

  test('the tone error is what a style adds', async () => {
    const project = await projectOf(filtered, { 'shaders/own.fs': BRIGHTER });
    const { json } = await score(project, session);
    expect(json.toneError).toBeCloseTo(30, 3);
    const itself = await score(project, session, '--reference', 'own-a1b2.layer');
    expect(itself.json.toneError).toBe(0);
    const said = await scrim('score', project, '--session', session, '--frames', '0..1');
    expect(said.out.split('\n')).toEqual([
      'Scored 2 frames of 64 × 48 pixels.',
      '  occlusion   not measured: the output shows no Scene',
      expect.stringMatching(
        /^ {2}flicker {5}0\.00 of 255 per frame, the reference 0\.00; at most 0\.00, in frame 1; 97 % of the image compared$/,
      ),
      expect.stringMatching(/^ {2}contrast {4}\d\.\d\d of the first frame kept, the reference \d\.\d\d$/),
      '  tone error  30.00 of 255',
    ]);
  });
});

test('a reference of another size is a mistake; the camera video has the size of the output', async () => {
  const session = await writeRecording('sizes', { stepPx: 0, depthMm: () => 2000 });
  const project = await projectOf(
    {
      nodes: {
        ...filtered.nodes,
        'image-a1b2': ['source/image-file', { file: 'picture' }],
        'mix-a1b2': ['operator/over', { opacity: 0.5 }],
      },
      wires: [
        'video-a1b2.layer -> own-a1b2.inputImage',
        'own-a1b2.layer -> mix-a1b2.bottom',
        'image-a1b2.layer -> mix-a1b2.top',
        'mix-a1b2.layer -> screen-a1b2.layer',
      ],
      assets: { picture: { path: 'assets/picture.png', kind: 'image' } },
    },
    { 'shaders/own.fs': PLAIN },
  );
  await writeProject(project, {
    'assets/picture.png': encode({ width: 8, height: 6, data: new Uint8Array(8 * 6 * 4).fill(255), channels: 4, depth: 8 }),
  });
  const { status, err } = await scrim('score', project, '--session', session, '--reference', 'image-a1b2.layer');
  expect([status, err]).toEqual([
    1,
    expect.stringContaining('SCR070: The reference Image file (image-a1b2.layer) has 8 × 6 pixels, but the output has 64 × 48.'),
  ]);
  const small = await score(await projectOf(filtered, { 'shaders/own.fs': PLAIN }), session, '--size', '32x24');
  expect([small.status, small.json.toneError]).toEqual([0, 0]);
});

describe('what cannot be scored', () => {
  const project = () => projectOf(filtered, { 'shaders/own.fs': PLAIN });

  test.each([
    [[], 2, '--session FOLDER is missing'],
    [['--session', 'none', '--min-iou', '2'], 2, '--min-iou needs a number from 0 to 1, not "2"'],
    [['--session', 'none'], 1, 'is not a session: it has no session.json'],
    [['--session', 'room:studio'], 1, 'has no measured depth to compare with: it is an emulated room'],
    [['--session', 'none', '--reference', 'sepia-a1b2.layer'], 2, '--reference sepia-a1b2.layer is not a layer of the project'],
  ])('%j', async (options, status, reason) => {
    const said = await scrim('score', await project(), ...options);
    expect([said.status, said.err]).toEqual([status, expect.stringContaining(reason)]);
  });

  test('a session without depth, frames that it lacks, and a project without output', async () => {
    const session = await writeRecording('flat', { stepPx: 0, depthMm: () => 2000 });
    const late = await scrim('score', await project(), '--session', session, '--frames', '0..9');
    expect([late.status, late.err]).toEqual([1, expect.stringContaining('The session has no frame 9')]);
    const file = join(session, 'session.json');
    const { depth: _, ...flat } = JSON.parse(await readFile(file, 'utf8')) as Record<string, unknown>;
    await writeFile(file, JSON.stringify(flat));
    const said = await scrim('score', await project(), '--session', session);
    expect([said.status, said.err]).toEqual([1, expect.stringContaining('its session.json has no "depth"')]);
    const empty = await projectOf({ nodes: { 'video-a1b2': 'source/camera-video' }, wires: [] });
    const none = await scrim('score', empty, '--session', session);
    expect([none.status, none.err]).toEqual([1, expect.stringContaining('SCR017')]);
  });

  test('half a depth image in the second frame', async () => {
    const session = await writeRecording('torn', { stepPx: 0, depthMm: () => 2000 });
    const file = join(session, '1.depth.png');
    const bytes = await readFile(file);
    await writeFile(file, bytes.subarray(0, bytes.length / 2));
    const said = await scrim('score', await project(), '--session', session);
    const reason = 'SCR054: The image "1.depth.png" cannot be used: it is not a whole PNG file.';
    expect([said.status, said.err]).toEqual([1, expect.stringContaining(reason)]);
  });
});

describeWithData('on a recorded living room', 'sessions/icl-livingroom', (recording) => {
  let session = '';
  beforeAll(async () => {
    session = join(base, 'living-room');
    await promisify(execFile)(process.execPath, [join(ROOT, 'tools/run.mjs'), 'sessions/convert-session.ts', recording, session]);
  });

  test('strokes on the surfaces flicker less than strokes on the screen, and keep their contrast', async () => {
    const room = (wires: readonly string[]): ProjectText => ({
      nodes: {
        'video-a1b2': 'source/camera-video',
        'depth-a1b2': ['world/depth', { filter: 'nearest' }],
        'room-a1b2': ['filter/room-drawing', { lines: 0 }],
        'hatched-a1b2': 'filter/hatched-drawing',
        'screen-a1b2': 'output/screen',
      },
      wires,
    });
    const anchored = room([
      'video-a1b2.layer -> room-a1b2.inputImage',
      'depth-a1b2.depth -> room-a1b2.room',
      'room-a1b2.layer -> screen-a1b2.layer',
    ]);
    // A drawing whose strokes have places on the screen.
    const fixed = room(['video-a1b2.layer -> hatched-a1b2.inputImage', 'hatched-a1b2.layer -> screen-a1b2.layer']);
    const scores = {
      anchored: await score(await projectOf(anchored), session, '--frames', '0..3'),
      fixed: await score(await projectOf(fixed), session, '--frames', '0..3'),
    };
    console.info(JSON.stringify(scores, (key, value) => (key === 'frames' ? undefined : value)));
    const [a, b] = [scores.anchored.json, scores.fixed.json];
    expect(a.flicker?.mean).toBeLessThan(0.8 * (b.flicker?.mean ?? 0));
    expect(a.contrastKept?.least).toBeGreaterThan(0.8);
  });
});
