import { cp, mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { decode } from 'fast-png';
import { runCli } from '../../app/cli/run-cli.ts';
import { installationAt } from '../../app/services/installation.ts';
import { type Acquired, acquire, likenessOf, placeText } from '../support/acquisition.ts';
import { projectText, writeProject } from '../support/project-kit.ts';
import { scrim, succeed } from '../support/scrim.ts';

let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-acquire-'));
});
afterAll(() => rm(base, { recursive: true, force: true }));

/** A matte ball and a box on a floor, all in view of the cameras below. */
const SCENE = projectText({
  nodes: {
    'ball-a1': ['objects/primitive', { shape: 'sphere', sizeM: [0.5, 0.5, 0.5], color: [0.8, 0.3, 0.2, 1], roughness: 1 }],
    'lift-a1': ['objects/transform', { positionM: [-0.3, 0.25, 0] }],
    'box-b1': ['objects/primitive', { shape: 'box', sizeM: [0.4, 0.6, 0.4], color: [0.2, 0.5, 0.8, 1], roughness: 1 }],
    'lift-b1': ['objects/transform', { positionM: [0.35, 0.3, -0.3], rotationRad: [0, 0.5, 0] }],
    'floor-c1': ['objects/primitive', { shape: 'plane', sizeM: [4, 0, 4], color: [0.6, 0.6, 0.5, 1], roughness: 1 }],
    'sun-d1': 'light/directional',
    'scene-e1': ['layer/scene', { shadows: true }],
    'screen-f1': 'output/screen',
  },
  wires: [
    ...['ball-a1.objects -> lift-a1.objects', 'box-b1.objects -> lift-b1.objects'],
    ...['lift-a1.objects -> scene-e1.objects', 'lift-b1.objects -> scene-e1.objects', 'floor-c1.objects -> scene-e1.objects'],
    ...['sun-d1.lights -> scene-e1.lights', 'scene-e1.layer -> screen-f1.layer'],
  ],
});

const PERSPECTIVE = [
  '--count',
  '9',
  '--center',
  '0,0.3,0',
  '--extent',
  '3,2.4,3',
  '--elevation',
  '15..60',
  '--fov',
  '45',
  '--size',
  '96x96',
];
const AROUND = ['--around', '--shape', 'grid', '--count', '2x1x1', '--center', '0,1,1', '--extent', '0.4,0,0', '--size', '256x128'];

async function sceneProject(): Promise<string> {
  const project = join(base, 'scene');
  await writeProject(project, { 'project.scrim.json': SCENE });
  return project;
}

/** The scene as it was photographed with these options, and the project that has the photographs as a capture. */
interface Imported {
  readonly photos: string;
  readonly place: string;
  readonly truth: readonly Acquired[];
  readonly path: string;
}

const captures = new Map<readonly string[], Promise<Imported>>();
/** Photographs and imports the scene once for all methods. */
function imported(options: readonly string[]): Promise<Imported> {
  const known = captures.get(options) ?? photographAndImport(options, String(captures.size));
  captures.set(options, known);
  return known;
}

async function photographAndImport(options: readonly string[], name: string): Promise<Imported> {
  const [photos, place] = [join(base, name, 'photos'), join(base, name, 'place')];
  const truth = await acquire(await sceneProject(), photos, ...options);
  await writeProject(place, { 'project.scrim.json': projectText({ nodes: { 'screen-a1': 'output/screen' }, wires: [] }) });
  const { status, out, err } = await scrim('import', 'capture', photos, '--project', place, '--json');
  expect([status, err]).toEqual([0, '']);
  const { path, depth, up } = JSON.parse(out) as { path: string; depth: { unit: string; kind: string }; up: string };
  expect([depth.unit, up]).toEqual(['m', '+y']);
  return { photos, place, truth, path };
}

test.each([
  ['lumigraph', PERSPECTIVE, { psnrDb: 32, covered: 0.97 }],
  ['depth-meshes', PERSPECTIVE, { psnrDb: 28, covered: 0.97 }],
  ['depth-meshes', AROUND, { psnrDb: 40, covered: 0.97 }],
] as const)(
  'a scene that is photographed, imported and shown by %s looks from the cameras as it did (%#)',
  async (method, options, bars) => {
    const { photos, place, truth, path } = await imported(options);
    await writeProject(place, { 'project.scrim.json': placeText(path, { method }) });
    const shown = await acquire(place, join(base, 'again'), ...options);
    expect(shown).toHaveLength(truth.length);
    if (process.env.SCRIM_PICTURES) {
      await cp(photos, join(process.env.SCRIM_PICTURES, `${method}-${options.length}-photos`), { recursive: true });
      await cp(join(base, 'again'), join(process.env.SCRIM_PICTURES, `${method}-${options.length}-again`), { recursive: true });
    }
    for (const [i, picture] of truth.entries()) {
      const likeness = likenessOf(picture, shown[i] ?? picture);
      if (process.env.SCRIM_PICTURES) console.log(method, i, likeness);
      expect(likeness.psnrDb).toBeGreaterThan(bars.psnrDb);
      expect(likeness.covered).toBeGreaterThan(bars.covered);
      expect(likeness.depthMedian).toBeLessThan(0.01);
    }
  },
);

test('the same scene gives the same bytes, over an earlier acquisition but not over other files', async () => {
  const scene = await sceneProject();
  const out = join(base, 'twice');
  const options = ['--out', out, '--count', '2', '--center', '0,0.3,0', '--extent', '3', '--size', '48x48', '--depth-format', 'png'];
  await succeed('capture', scene, ...options);
  const first = await contentOf(out);
  await succeed('capture', scene, ...options);
  expect(await contentOf(out)).toEqual(first);
  expect(Object.keys(first).sort()).toEqual(
    ['acquisition.json', 'depth/0000.png', 'depth/0001.png', 'images/0000.png', 'images/0001.png', 'transforms.json'].sort(),
  );
  await writeFile(join(out, 'notes.txt'), 'mine');
  const refused = await scrim('capture', scene, ...options);
  expect([refused.status, refused.err]).toEqual([1, expect.stringContaining('notes.txt')]);
});

test('says what is wrong, and writes nothing', async () => {
  const scene = await sceneProject();
  const out = join(base, 'wrong');
  const small = ['--size', '32x32', '--count', '2'];
  const away = await scrim('capture', scene, '--out', out, ...small, '--center', '0,500,0', '--extent', '2');
  expect([away.status, away.err]).toEqual([1, expect.stringContaining('No photograph shows anything of Scene (scene-e1.layer)')]);
  const flat = join(base, 'flat');
  await writeProject(flat, {
    'project.scrim.json': projectText({
      nodes: { 'video-a1': 'source/camera-video', 'screen-b1': 'output/screen' },
      wires: ['video-a1.layer -> screen-b1.layer'],
    }),
  });
  const without = await scrim('capture', flat, '--out', out, ...small);
  expect([without.status, without.err]).toEqual([1, expect.stringContaining('has no depth')]);
  expect((await readdir(base)).filter((name) => name.startsWith('wrong'))).toEqual([]);
});

test('Ctrl-C leaves nothing', async () => {
  const scene = await sceneProject();
  const folder = join(base, 'stopped');
  await mkdir(folder);
  const interruption = new AbortController();
  const said: string[] = [];
  const status = await runCli(
    ['capture', scene, '--out', join(folder, 'deep/out'), '--size', '32x32', '--count', '50', '--center', '0,0.3,0'],
    installationAt(resolve('.'), '1.2.3'),
    {
      out: () => {},
      err: (text) => said.push(text),
      interactive: true,
      progress: (text) => {
        if (text?.includes('(2 of 50)')) interruption.abort();
      },
    },
    interruption.signal,
  );
  expect([status, said]).toEqual([130, ['Interrupted. Nothing was written.']]);
  expect(await readdir(folder)).toEqual([]);
});

async function contentOf(folder: string): Promise<Readonly<Record<string, string>>> {
  const names = (await readdir(folder, { recursive: true, withFileTypes: true })).filter((entry) => entry.isFile());
  const entries = names.map(async ({ parentPath, name }) => {
    const path = join(parentPath, name);
    return [path.slice(folder.length + 1), (await readFile(path)).toString('base64')] as const;
  });
  return Object.fromEntries(await Promise.all(entries));
}

test('each of two 360° photographs is rendered from the other', async () => {
  const { place, path } = await imported(AROUND);
  const out = join(base, 'around-report');
  await succeed('rephotograph', join(place, dirname(path)), '--out', out, '--method', 'lumigraph');
  const { views } = JSON.parse(await readFile(join(out, 'report.json'), 'utf8')) as {
    views: { shots: { psnrDb: number; covered: number }[] }[];
  };
  expect(views).toHaveLength(2);
  for (const { shots } of views) {
    expect(shots).toMatchObject([{ method: 'lumigraph' }]);
    // What only one of them sees has no color in the other.
    expect(shots[0]?.psnrDb).toBeGreaterThan(20);
    expect(shots[0]?.covered).toBeGreaterThan(0.2);
  }
  expect(decode(await readFile(join(out, 'views/001-lumigraph-error.png')))).toMatchObject({ width: 256, height: 128 });
});
