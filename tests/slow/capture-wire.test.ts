import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import type { Program } from '../../export/program/program.ts';
import { useModule } from '../support/browser.ts';
import { compileText } from '../support/compile-project.ts';
import { type ProjectText, projectText } from '../support/project-kit.ts';

const page = useModule('tests/browser/unchanged-objects.page.ts', { mounts: { '/nodes/': join(process.cwd(), 'nodes') } });

const FILES = {
  coarse: 'capture-mesh/example/assets/glossy-ball.capture/capture.json',
  fine: 'capture/example/assets/glossy-ball.capture/capture.json',
  // It is not a capture.
  broken: 'capture/example/project.layout.json',
} as const;

interface Place {
  readonly file: keyof typeof FILES;
  readonly positionM: readonly number[];
  readonly rotationRad: readonly number[];
  readonly scale: number;
}

const FIRST: Place = { file: 'coarse', positionM: [0, -0.5, 0], rotationRad: [0, 0, 0], scale: 2 };
const MOVED: Place = { file: 'coarse', positionM: [0.3, -0.4, 0.1], rotationRad: [0.2, 0.7, 0], scale: 1.6 };
const RIGHT: Place = { ...FIRST, file: 'fine', positionM: [0.5, -0.5, 0.3] };

interface MeshChoice {
  /** The node that the mesh is wired to; else it has a file and a place of its own, if any. */
  readonly wired?: string;
  readonly own?: Place;
}

/** A yellow block behind a captured ball, or between two, with its shadow on the mesh of one. */
function compileBlock(places: Readonly<Record<string, Place>>, { wired, own }: MeshChoice): Program {
  const [below = '', above] = Object.keys(places);
  const captures: ProjectText['nodes'] = Object.fromEntries(
    Object.entries(places).map(([id, place]) => [id, ['source/capture', { method: 'plain', ...place }]]),
  );
  const text = projectText({
    nodes: {
      ...captures,
      ...(wired || own ? { 'mesh-a': ['source/capture-mesh', { ...own }] } : {}),
      'block-a': ['objects/primitive', { color: [1, 0.9, 0, 1], sizeM: [0.5, 1, 0.3] }],
      'stand-a': ['objects/transform', { positionM: [0.2, 0.1, -0.35] }],
      'sun-a': ['light/directional', { azimuthRad: 2, elevationRad: 0.7 }],
      'scene-a': 'layer/scene',
      'shadow-a': 'layer/shadow',
      'places-a': 'operator/over',
      'under-a': 'operator/over',
      'over-a': 'operator/over',
      'screen-a': 'output/screen',
    },
    wires: [
      ...(wired ? [`${wired}.capture -> mesh-a.capture`] : []),
      ...(wired || own ? ['mesh-a.objects -> scene-a.objects', 'mesh-a.objects -> shadow-a.receivers'] : []),
      'block-a.objects -> stand-a.objects',
      'stand-a.objects -> scene-a.objects',
      'sun-a.lights -> scene-a.lights',
      'stand-a.objects -> shadow-a.casters',
      'sun-a.lights -> shadow-a.lights',
      'shadow-a.layer -> under-a.top',
      `${below}.layer -> places-a.bottom`,
      `${above ?? below}.layer -> places-a.top`,
      'places-a.layer -> under-a.bottom',
      'scene-a.layer -> over-a.top',
      'under-a.layer -> over-a.bottom',
      'over-a.layer -> screen-a.layer',
    ],
    assets: Object.fromEntries(Object.keys(FILES).map((id) => [id, { path: `assets/${id}.capture/capture.json`, kind: 'capture' }])),
  });
  const program = compileText(text);
  return { ...program, assets: program.assets.map((asset) => ({ ...asset, path: FILES[asset.id as keyof typeof FILES] })) };
}

const pixels = () => page.call<number[]>('pixels');
async function open(program: Program): Promise<number[]> {
  await page.call('open', program, 'nodes/source/');
  await page.call('untilRest');
  return pixels();
}

/** The image of the next frame alone, which has to be that of the change. */
async function frameAfter(change: Promise<unknown>): Promise<number[]> {
  await change;
  await page.call('next');
  return pixels();
}

const yellow = (image: readonly number[]) =>
  image.filter((red, i) => i % 4 === 0 && red > 90 && (image[i + 1] ?? 0) > 70 && (image[i + 2] ?? 0) < 40).length;

test('the mesh of a wired capture hides and receives shadows as one with the same file and place, and moves in the same frame', async () => {
  const bare = await open(compileBlock({ 'ball-a': FIRST }, {}));
  const own = await open(compileBlock({ 'ball-a': FIRST }, { own: FIRST }));
  const ownMoved = await open(compileBlock({ 'ball-a': MOVED }, { own: MOVED }));
  const wired = await open(compileBlock({ 'ball-a': FIRST }, { wired: 'ball-a' }));
  expect(yellow(own)).toBeLessThan(yellow(bare) - 20);
  expect(yellow(own)).toBeGreaterThan(10);
  expect(wired).toEqual(own);

  await page.call('setParam', 'ball-a', 'positionM', MOVED.positionM);
  await page.call('setParam', 'ball-a', 'rotationRad', MOVED.rotationRad);
  const moved = await frameAfter(page.call('setParam', 'ball-a', 'scale', MOVED.scale));
  expect(moved).not.toEqual(wired);
  expect(moved).toEqual(ownMoved);
  // Params of its own say nothing.
  expect(await frameAfter(page.call('setParam', 'mesh-a', 'positionM', [5, 5, 5]))).toEqual(ownMoved);
});

test('of two captures the mesh is that of the wired one, also after the wire or a file is changed', async () => {
  const two = { 'ball-a': FIRST, 'right-a': RIGHT };
  const left = compileBlock(two, { wired: 'ball-a' });
  const right = compileBlock(two, { wired: 'right-a' });
  const ownLeft = await open(compileBlock(two, { own: FIRST }));
  const ownRight = await open(compileBlock(two, { own: RIGHT }));
  expect(ownLeft).not.toEqual(ownRight);
  expect(await open(left)).toEqual(ownLeft);
  await page.call('replace', right);
  await page.call('untilRest');
  expect(await pixels()).toEqual(ownRight);
  await page.call('loseContext');
  await page.call('untilRest');
  expect(await pixels()).toEqual(ownRight);

  const swap = (file: Place['file']) => ({ 'ball-a': FIRST, 'right-a': { ...RIGHT, file } });
  const ownSwapped = await open(compileBlock(swap('coarse'), { own: { ...RIGHT, file: 'coarse' } }));
  const withoutMesh = await open(compileBlock(swap('broken'), {}));
  await open(right);
  await page.call('replace', compileBlock(swap('coarse'), { wired: 'right-a' }));
  await page.call('untilRest');
  expect(await pixels()).toEqual(ownSwapped);
  // Its file cannot be loaded: nothing of the one before stays.
  await page.call('replace', compileBlock(swap('broken'), { wired: 'right-a' }));
  await page.call('untilRest');
  expect(await pixels()).toEqual(withoutMesh);
});
