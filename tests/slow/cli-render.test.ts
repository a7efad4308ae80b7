import { mkdtemp, readdir, readFile, rm, truncate, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, beforeEach, describe, expect, test } from '@jest/globals';
import { decode, encode } from 'fast-png';
import { decodeImage } from '../support/image.ts';
import { countColors } from '../support/pixels.ts';
import { type ProjectText, projectText, writeProject } from '../support/project-kit.ts';
import { scrim } from '../support/scrim.ts';

const MODEL = resolve(import.meta.dirname, '../../examples/first-light/assets/robot.glb');

const WIDTH = 32;
const HEIGHT = 24;
const FRAMES = 4;
/** One second between frames makes their numbers easy to read in a picture. */
const FRAME_S = 1;

/** A box of half a meter straight ahead, two meters away: its front at 1.75 m. */
const BOX_FRONT_M = 1.75;
/** Room depth: a wall on the left half at one meter, hiding the box; on the right at three. */
const WALL_MM = [1000, 3000] as const;

const BOX: ProjectText = {
  title: 'Box',
  nodes: {
    'video-a1b2': 'source/camera-video',
    'depth-a1b2': 'world/depth',
    'box-a1b2': ['objects/primitive', { sizeM: [0.5, 0.5, 0.5], color: [1, 0, 0, 1] }],
    'place-a1b2': ['objects/transform', { positionM: [0, 0, -2] }],
    'scene-a1b2': 'layer/scene',
    'hide-a1b2': 'layer/depth-occlusion',
    'over-a1b2': 'operator/over',
    'screen-a1b2': 'output/screen',
  },
  wires: [
    'box-a1b2.objects -> place-a1b2.objects',
    'place-a1b2.objects -> scene-a1b2.objects',
    'scene-a1b2.layer -> hide-a1b2.layer',
    'depth-a1b2.depth -> hide-a1b2.depth',
    'hide-a1b2.layer -> over-a1b2.top',
    'video-a1b2.layer -> over-a1b2.bottom',
    'over-a1b2.layer -> screen-a1b2.layer',
  ],
};

let base = '';
let project = '';
let session = '';
let outputs = 0;
let out = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-render-'));
  project = join(base, 'project');
  session = join(project, 'sessions', 'desk');
  await writeProject(project, { 'project.scrim.json': projectText(BOX) });
  await writeProject(session, recording());
});
beforeEach(() => {
  out = join(base, `out-${outputs++}`);
});
afterAll(() => rm(base, { recursive: true, force: true }));

/** The color that a frame's picture has at a pixel: different everywhere and in every frame. */
function colorAt(frame: number, x: number, y: number): readonly [number, number, number] {
  return [x * 7, y * 9, 40 + frame * 50];
}

function recording(): Record<string, string | Uint8Array> {
  const intrinsics = { fxPx: 40, fyPx: 40, cxPx: WIDTH / 2, cyPx: HEIGHT / 2 };
  const size = { widthPx: WIDTH, heightPx: HEIGHT, intrinsics };
  const worldFromCamera = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const frames = Array.from({ length: FRAMES }, (_, i) => ({
    timeS: i * FRAME_S,
    color: `${i}.png`,
    depth: `${i}.depth.png`,
    worldFromCamera,
  }));
  const file = {
    format: 'scrim-session',
    version: 1,
    title: 'Desk',
    color: size,
    depth: { ...size, metresPerUnit: 0.001, kind: 'z' },
    frameRateHz: 1,
    frames,
  };
  const files: Record<string, string | Uint8Array> = { 'session.json': JSON.stringify(file) };
  for (let i = 0; i < FRAMES; i++) {
    const pixels = Array.from({ length: WIDTH * HEIGHT }, (_, at) => [...colorAt(i, at % WIDTH, Math.floor(at / WIDTH)), 255]);
    const depth = Array.from({ length: WIDTH * HEIGHT }, (_, at) => WALL_MM[at % WIDTH < WIDTH / 2 ? 0 : 1]);
    files[`${i}.png`] = encode({ width: WIDTH, height: HEIGHT, data: Uint8Array.from(pixels.flat()), channels: 4, depth: 8 });
    files[`${i}.depth.png`] = encode({ width: WIDTH, height: HEIGHT, data: Uint16Array.from(depth), channels: 1, depth: 16 });
  }
  return files;
}

interface Answer {
  readonly files?: readonly string[];
  readonly diagnostics: readonly { readonly code: string; readonly message: string; readonly file?: string; readonly line?: number }[];
}

async function render(...args: string[]) {
  const { status, out } = await scrim('render', ...args, '--json');
  return { status, json: JSON.parse(out) as Answer };
}

async function readPng(path: string) {
  const png = decode(await readFile(path));
  return {
    ...png,
    at: (x: number, y: number) => [...png.data.slice((y * png.width + x) * png.channels, (y * png.width + x + 1) * png.channels)],
  };
}

describe('scrim render', () => {
  test('writes what a visitor sees: the camera’s picture to the bit, the model before it, hidden by the wall', async () => {
    const file = `${out}.png`;
    expect(await render(project, '--out', file)).toMatchObject({ status: 0, json: { files: [file] } });
    const png = await readPng(file);
    expect(png).toMatchObject({ width: WIDTH, height: HEIGHT, channels: 4, depth: 8 });
    for (const [x, y] of [
      [0, 0],
      [WIDTH - 1, 0],
      [0, HEIGHT - 1],
      [3, 20],
    ] as const)
      expect(png.at(x, y)).toEqual([...colorAt(0, x, y), 255]);
    const [red = 0, , blue = 255] = png.at(WIDTH / 2 + 2, HEIGHT / 2);
    expect(red - blue).toBeGreaterThan(80);
    expect(png.at(WIDTH / 2 - 3, HEIGHT / 2)).toEqual([...colorAt(0, WIDTH / 2 - 3, HEIGHT / 2), 255]);
  });

  test('writes the same bytes each time, and a range that is the same as its frames alone', async () => {
    const range = await render(project, '--out', out, '--frames', '1..3');
    expect(range.json.files?.map((path) => path.slice(out.length + 1))).toEqual(['000001.png', '000002.png', '000003.png']);
    await render(project, '--out', `${out}-again`, '--frames', '2');
    const [first, again] = await Promise.all([out, `${out}-again`].map((folder) => readFile(join(folder, '000002.png'))));
    expect(Buffer.compare(first as Buffer, again as Buffer)).toBe(0);
    const png = await readPng(join(out, '000003.png'));
    expect(png.at(1, 2)).toEqual([...colorAt(3, 1, 2), 255]);
  });

  test('draws a capture the same each time, to the byte', async () => {
    const args = [resolve('nodes/source/capture/example'), '--size', '160x120', '--frames', '1..2'];
    for (const to of [out, `${out}-again`]) expect(await render(...args, '--out', to)).toMatchObject({ status: 0 });
    for (const name of ['000001.png', '000002.png']) {
      const once = await readFile(join(out, name));
      expect(countColors(decodeImage(once))).toBeGreaterThan(100);
      expect(once.equals(await readFile(join(`${out}-again`, name)))).toBe(true);
    }
  });

  test('renders the last frame of a range as it is after all frames before, where nodes keep state', async () => {
    const counting: ProjectText = {
      title: 'Counting',
      nodes: {
        'video-a1b2': 'source/camera-video',
        'every-a1b2': ['pulse/every', { periodS: FRAME_S }],
        'count-a1b2': ['value/counter', { step: 0.3 }],
        'sepia-a1b2': 'filter/sepia',
        'screen-a1b2': 'output/screen',
      },
      wires: [
        'every-a1b2.pulse -> count-a1b2.up',
        'count-a1b2.number -> sepia-a1b2.amount',
        'video-a1b2.layer -> sepia-a1b2.inputImage',
        'sepia-a1b2.layer -> screen-a1b2.layer',
      ],
    };
    const folder = join(base, 'counting');
    await writeProject(folder, { 'project.scrim.json': projectText(counting) });
    const [all, end] = [`${out}-all`, `${out}-end`];
    for (const [range, to] of [
      ['0..3', all],
      ['2..3', end],
    ] as const)
      expect(await render(folder, '--session', session, '--frames', range, '--out', to)).toMatchObject({ status: 0 });
    for (const name of ['000002.png', '000003.png']) {
      expect(Buffer.compare(await readFile(join(all, name)), await readFile(join(end, name)))).toBe(0);
    }
    // After three steps of 0.3, the blue picture is brown.
    const [red = 0, , blue = 255] = (await readPng(join(end, '000003.png'))).at(5, 5);
    expect(red).toBeGreaterThan(blue);
  });

  test('writes a node’s layer with straight alpha, before anything behind it is drawn', async () => {
    const file = `${out}.png`;
    await render(project, '--out', file, '--layer', 'scene-a1b2.layer');
    const png = await readPng(file);
    expect(png.at(0, 0)).toEqual([0, 0, 0, 0]);
    const [red = 0, green = 255, , alpha] = png.at(WIDTH / 2 - 2, HEIGHT / 2);
    expect(red - green).toBeGreaterThan(80);
    expect(alpha).toBe(255);
  });

  test('writes depth in millimeters', async () => {
    const file = `${out}.png`;
    await render(project, '--depth', 'scene-a1b2.layer', '--out', file);
    const png = await readPng(file);
    expect(png).toMatchObject({ channels: 1, depth: 16 });
    expect(png.at(0, 0)).toEqual([0]);
    expect(Math.abs((png.at(WIDTH / 2, HEIGHT / 2)[0] ?? 0) - BOX_FRONT_M * 1000)).toBeLessThanOrEqual(2);
  });

  test('writes the depth of what is on the screen unless a layer is named, and the size that is asked for', async () => {
    const file = `${out}.png`;
    await render(project, '--out', file, '--size', '64x48', '--depth');
    const png = await readPng(file);
    expect(png).toMatchObject({ width: 64, height: 48 });
    // The box is hidden on the left of the middle.
    expect(png.at(28, 24)).toEqual([0]);
    expect(png.at(36, 24)[0]).toBeGreaterThan(1700);
  });

  test('plays an emulated room', async () => {
    const file = `${out}.png`;
    expect((await render(project, '--out', file, '--session', 'room:office_small', '--size', '96x64')).status).toBe(0);
    const png = await readPng(file);
    expect(png).toMatchObject({ width: 96, height: 64 });
    expect(new Set(Array.from({ length: 96 }, (_, x) => png.at(x, 32).join())).size).toBeGreaterThan(4);
  });
});

describe('scrim render in trouble writes nothing and says why', () => {
  async function refused(args: readonly string[], code: string, words = '') {
    const folder = join(base, `refused-${outputs++}`);
    const { status, json } = await render(...args, '--out', folder);
    expect([status, json.diagnostics.map((diagnostic) => diagnostic.code)]).toEqual([1, expect.arrayContaining([code])]);
    expect(JSON.stringify(json.diagnostics)).toContain(words);
    await expect(readdir(folder)).rejects.toMatchObject({ code: 'ENOENT' });
    return json.diagnostics;
  }

  test('a layer that is not there, or has no depth', async () => {
    await refused([project, '--layer', 'box-a1b2.layer'], 'SCR012', 'scene-a1b2.layer');
    await refused([project, '--depth', 'video-a1b2.layer'], 'SCR012', 'no depth');
  });

  test('a session that is not there, or is broken, or has fewer frames', async () => {
    await refused([project, '--session', join(base, 'nowhere')], 'SCR054');
    await refused([project, '--session', 'room:cellar'], 'SCR054', 'living_room');
    await refused([project, '--frames', '2..4'], 'SCR070', '0 to 3');
    const broken = join(base, 'broken');
    await writeProject(broken, { ...recording(), '2.png': 'no picture' });
    await refused([project, '--session', broken, '--frames', '0..3'], 'SCR054', '2.png');
    await writeFile(join(broken, 'session.json'), '{"format":"scrim-session","version":7}');
    await refused([project, '--session', broken], 'SCR054', '7');
  });

  test('a picture or a model that cannot be decoded', async () => {
    const damaged = join(base, 'damaged');
    const robot = { path: 'assets/robot.glb', kind: 'model' } as const;
    const nodes = { ...BOX.nodes, 'box-a1b2': ['source/model', { model: 'robot' }] as const };
    await writeProject(damaged, {
      'project.scrim.json': projectText({ ...BOX, nodes, assets: { robot } }),
      'assets/robot.glb': await readFile(MODEL),
    });
    await truncate(join(damaged, 'assets', 'robot.glb'), 3000);
    await refused([damaged, '--session', session], 'SCR032', 'is incomplete: it has 3000 of');
    // Whole by its header, torn inside: only decoding it can tell.
    const torn = new Uint8Array(await readFile(MODEL));
    torn.fill(0x20, 20, 400);
    await writeProject(damaged, { 'assets/robot.glb': torn });
    await refused([damaged, '--session', session], 'SCR032', 'robot.glb');
  });

  test('a shader that the driver refuses, at its author’s word', async () => {
    const shader = `/*{ "ISFVSN": "2", "INPUTS": [ { "NAME": "inputImage", "TYPE": "image" } ] }*/
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  gl_FragColor = c * notDeclared;
}
`;
    const own = join(base, 'own');
    const nodes = { 'video-a1b2': 'source/camera-video', 'own-a1b2': 'filter/own', 'screen-a1b2': 'output/screen' };
    const wires = ['video-a1b2.layer -> own-a1b2.inputImage', 'own-a1b2.layer -> screen-a1b2.layer'];
    await writeProject(own, { 'project.scrim.json': projectText({ nodes, wires }), 'shaders/own.fs': shader });
    const diagnostics = await refused([own, '--session', session], 'SCR042', 'notDeclared');
    expect(diagnostics.find(({ code }) => code === 'SCR042')).toMatchObject({ file: 'shaders/own.fs', line: 4, column: 22 });
  });
});
