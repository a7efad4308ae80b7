import { join } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import type { images } from '../browser/unchanged-objects.page.ts';
import { useModule } from '../support/browser.ts';
import { compileText } from '../support/compile-project.ts';
import { type ProjectText, projectText } from '../support/project-kit.ts';

const page = useModule('tests/browser/unchanged-objects.page.ts', { mounts: { '/nodes/': join(process.cwd(), 'nodes') } });

const open = (text: ProjectText, assetUrl = 'nodes/source/image-file/example/') =>
  page.call('open', compileText(projectText(text)), assetUrl);
const next = (widthPx?: number) => page.call<number>('next', ...(widthPx === undefined ? [] : [widthPx]));
const untilStill = () => page.call<number>('untilStill');
const setParam = (node: string, param: string, value: unknown) => page.call('setParam', node, param, value);

/** Draws the frame after a change and the next one. The canvas then has to show what a full draw would. */
async function drawsOnce(change: string): Promise<void> {
  expect([change, (await next()) > 0, await next()]).toEqual([change, true, 0]);
  const { kept, drawn } = await page.call<ReturnType<typeof images>>('images');
  expect([change, kept]).toEqual([change, drawn]);
}

/** Draws frames until nothing arrives any more. The canvas then has to show what a full draw would. */
async function rests(): Promise<void> {
  await page.call('untilRest');
  const { kept, drawn } = await page.call<ReturnType<typeof images>>('images');
  expect(kept).toBe(drawn);
}

/** A box in Gooch's tones on a phantom floor, with a shadow of its own layer, all of it through a filter. */
const BOX: ProjectText = {
  nodes: {
    'box-a': 'objects/primitive',
    'up-a': ['objects/transform', { positionM: [0, 0.5, 0] }],
    'drawn-a': 'objects/apply-technique',
    'gooch-a': 'technique/gooch',
    'plane-a': ['objects/primitive', { shape: 'plane', sizeM: [4, 0, 4] }],
    'floor-a': 'objects/phantom',
    'sun-a': 'light/directional',
    'scene-a': 'layer/scene',
    'shadow-a': 'layer/shadow',
    'merge-a': 'operator/over',
    'sepia-a': 'filter/sepia',
    'screen-a': 'output/screen',
  },
  wires: [
    'box-a.objects -> up-a.objects',
    'up-a.objects -> drawn-a.objects',
    'gooch-a.technique -> drawn-a.technique',
    'plane-a.objects -> floor-a.objects',
    'drawn-a.objects -> scene-a.objects',
    'sun-a.lights -> scene-a.lights',
    'up-a.objects -> shadow-a.casters',
    'floor-a.objects -> shadow-a.receivers',
    'sun-a.lights -> shadow-a.lights',
    'shadow-a.layer -> merge-a.bottom',
    'scene-a.layer -> merge-a.top',
    'merge-a.layer -> sepia-a.inputImage',
    'sepia-a.layer -> screen-a.layer',
  ],
};

describe('objects that nothing changes', () => {
  test('are not drawn again, with their light, shadow and filter', async () => {
    await open(BOX);
    expect(await next()).toBeGreaterThan(3);
    expect([await next(), await next()]).toEqual([0, 0]);
    const changes: Readonly<Record<string, () => Promise<unknown>>> = {
      'the color of the object': () => setParam('box-a', 'color', [0, 1, 0, 1]),
      'its place': () => setParam('up-a', 'positionM', [0.3, 0.6, 0]),
      'a param of its technique': () => setParam('gooch-a', 'highlight', 0.1),
      'the direction of the light': () => setParam('sun-a', 'azimuthRad', 1.2),
      'the color of the shadow': () => setParam('shadow-a', 'color', [1, 0, 0, 1]),
      'the ambient light': () => setParam('scene-a', 'ambient', 0.9),
      'whether it casts a shadow': () => setParam('box-a', 'castShadow', false),
      'the filter': () => setParam('sepia-a', 'amount', 0.5),
      'the place of the camera': () => page.call('turnCamera'),
      'a reset': () => page.call('reset'),
      'a full draw': () => page.call('images'),
      'a lost context': () => page.call('loseContext'),
    };
    for (const [name, change] of Object.entries(changes)) {
      await change();
      if (name === 'a full draw') expect(await next()).toBe(0);
      else await drawsOnce(name);
    }
    expect([(await next(32)) > 0, await next(32), (await next()) > 0, await next()]).toEqual([true, 0, true, 0]);
  });

  test('are drawn in each frame while the depth of the room may hide them', async () => {
    await open({
      nodes: {
        'box-a': 'objects/primitive',
        'scene-a': 'layer/scene',
        'room-a': 'world/depth',
        'hide-a': 'layer/depth-occlusion',
        'screen-a': 'output/screen',
      },
      wires: [
        'box-a.objects -> scene-a.objects',
        'scene-a.layer -> hide-a.layer',
        'room-a.depth -> hide-a.depth',
        'hide-a.layer -> screen-a.layer',
      ],
    });
    await untilStill();
    await page.call('showRoom', true);
    expect([(await next()) > 0, (await next()) > 0]).toEqual([true, true]);
    await page.call('showRoom', false);
    await drawsOnce('no room any more');
  });

  test('are drawn while an animation plays, and not while it is paused', async () => {
    const wires = ['model-a.objects -> scene-a.objects', 'scene-a.layer -> screen-a.layer'];
    const nodes = {
      'model-a': ['source/model', { model: 'pin', playing: false }],
      'scene-a': 'layer/scene',
      'screen-a': 'output/screen',
    } as const;
    const assets = { pin: { path: 'assets/pinwheel.glb', kind: 'model' } } as const;
    await open({ nodes, wires, assets }, 'nodes/source/model/example/');
    // The first frame comes before the model.
    await untilStill();
    await setParam('model-a', 'playing', true);
    expect([(await next()) > 0, (await next()) > 0, (await next()) > 0]).toEqual([true, true, true]);
    await setParam('model-a', 'playing', false);
    await untilStill();
    const { kept, drawn } = await page.call<ReturnType<typeof images>>('images');
    expect(kept).toBe(drawn);
  });
});

describe('placed objects', () => {
  const PLACED: ProjectText = {
    nodes: {
      'box-a': 'objects/primitive',
      'place-a': 'objects/place',
      'up-a': ['pose/offset', { offsetM: [0, 1, 0] }],
      'line-a': 'objects/line',
      'scene-a': 'layer/scene',
      'screen-a': 'output/screen',
    },
    wires: [
      'box-a.objects -> place-a.objects',
      'place-a.pose -> up-a.pose',
      'place-a.pose -> line-a.from',
      'up-a.pose -> line-a.to',
      'place-a.objects -> scene-a.objects',
      'line-a.objects -> scene-a.objects',
      'scene-a.layer -> screen-a.layer',
    ],
  };
  const point = (type: string, x: number, y: number) => page.call('point', type, x, y);

  test('are drawn while the visitor moves them, with what follows their pose, and not while they rest', async () => {
    await open(PLACED);
    await rests();
    const empty = await page.call<ReturnType<typeof images>>('images');
    await point('pointerdown', 0.5, 0.6);
    await next();
    await point('pointerup', 0.5, 0.6);
    expect(await next()).toBeGreaterThan(3);
    await rests();
    const placed = await page.call<ReturnType<typeof images>>('images');
    expect(placed.kept).not.toBe(empty.kept);
    await point('pointerdown', 0.5, 0.55);
    await next();
    for (const x of [0.55, 0.6, 0.65]) {
      await point('pointermove', x, 0.6);
      expect([x, (await next()) > 0]).toEqual([x, true]);
    }
    // It is held and does not move.
    await rests();
    await point('pointerup', 0.65, 0.6);
    await rests();
    expect((await page.call<ReturnType<typeof images>>('images')).kept).not.toBe(placed.kept);
    for (const change of ['turnCamera', 'loseContext', 'reset']) {
      await page.call(change);
      expect([change, (await next()) > 0]).toEqual([change, true]);
      await rests();
      expect([change, await next()]).toEqual([change, 0]);
    }
  });
});

test('a body is drawn while it falls, and not when it sleeps', async () => {
  await open({
    nodes: {
      'box-a': ['objects/primitive', { sizeM: [0.2, 0.2, 0.2] }],
      'up-a': ['objects/transform', { positionM: [0, 0.4, 0] }],
      'body-a': 'physics/body',
      'world-a': 'physics/world',
      'scene-a': 'layer/scene',
      'screen-a': 'output/screen',
    },
    wires: [
      'box-a.objects -> up-a.objects',
      'up-a.objects -> body-a.objects',
      'body-a.body -> world-a.bodies',
      'body-a.objects -> scene-a.objects',
      'scene-a.layer -> screen-a.layer',
    ],
  });
  await page.call('untilDrawn');
  const high = await page.call<ReturnType<typeof images>>('images');
  await rests();
  const low = await page.call<ReturnType<typeof images>>('images');
  expect(low.kept).not.toBe(high.kept);
  expect([await next(), await next()]).toEqual([0, 0]);
  await page.call('reset');
  await page.call('untilDrawn');
});

describe('pixels of an image that nothing changes', () => {
  const assets = { photo: { path: 'assets/sticker.png', kind: 'image' } } as const;

  test('are read until what depends on them is shown, and not again', async () => {
    await open({
      nodes: {
        'photo-a': ['source/image-file', { file: 'photo' }],
        'cut-a': ['filter/threshold', { level: 0.3 }],
        'mask-a': 'layer/measure-mask',
        'tint-a': 'filter/sepia',
        'screen-a': 'output/screen',
      },
      wires: [
        'photo-a.layer -> cut-a.inputImage',
        'cut-a.layer -> mask-a.mask',
        'mask-a.area -> tint-a.amount',
        'photo-a.layer -> tint-a.inputImage',
        'tint-a.layer -> screen-a.layer',
      ],
      assets,
    });
    await rests();
    const before = await page.call<ReturnType<typeof images>>('images');
    expect(before.kept).toBe(before.drawn);
    await setParam('cut-a', 'level', 0.9);
    expect(await next()).toBeGreaterThan(0);
    await rests();
    // The area of the mask arrives later than the mask.
    const after = await page.call<ReturnType<typeof images>>('images');
    expect(after.kept).not.toBe(before.kept);
    expect([await next(), await next()]).toEqual([0, 0]);
    await page.call('loseContext');
    expect(await next()).toBeGreaterThan(0);
    await rests();
  });
});

describe('splats and captures that nothing changes', () => {
  const cases = [
    ['splats', 'source/splats', 'assets/vase.sog', {}],
    ['capture', 'source/capture', 'assets/glossy-ball.capture/capture.json', {}],
    ['capture', 'source/capture', 'assets/glossy-ball.capture/capture.json', { method: 'lumigraph', updateFrames: 4 }],
  ] as const;

  test.each(cases)('%s are not drawn again', async (kind, type, path, params) => {
    const nodes = { 'seen-a': [type, { file: 'seen', ...params }], 'sepia-a': 'filter/sepia', 'screen-a': 'output/screen' } as const;
    const wires = ['seen-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> screen-a.layer'];
    await open({ nodes, wires, assets: { seen: { path, kind } } }, `nodes/${type}/example/`);
    await rests();
    expect([await next(), await next()]).toEqual([0, 0]);
    await setParam('sepia-a', 'amount', 0.3);
    await drawsOnce('the filter');
    for (const change of ['turnCamera', 'loseContext', 'reset']) {
      await page.call(change);
      expect([change, await next()]).not.toEqual([change, 0]);
      // Sorting, and loading after a lost context, draw once more.
      await rests();
      expect([change, await next()]).toEqual([change, 0]);
    }
    expect([(await next(32)) > 0, await next(32), (await next()) > 0]).toEqual([true, 0, true]);
    await setParam('seen-a', 'scale', 1.2);
    expect(await next()).toBeGreaterThan(0);
  });

  test('a capture with weights per vertex is drawn until all are those of the eye', async () => {
    const seen = ['source/capture', { file: 'seen', method: 'lumigraph', updateFrames: 5 }] as const;
    const wires = ['seen-a.layer -> screen-a.layer'];
    const assets = { seen: { path: 'assets/glossy-ball.capture/capture.json', kind: 'capture' } } as const;
    await open({ nodes: { 'seen-a': seen, 'screen-a': 'output/screen' }, wires, assets }, 'nodes/source/capture/example/');
    await rests();
    await page.call('turnCamera');
    const frames = await untilStill();
    expect(frames).toBeGreaterThan(2);
    expect(frames).toBeLessThan(8);
  });

  test('splats are drawn again when they are sorted', async () => {
    const nodes = { 'seen-a': ['source/splats', { file: 'seen' }], 'screen-a': 'output/screen' } as const;
    const wires = ['seen-a.layer -> screen-a.layer'];
    await open({ nodes, wires, assets: { seen: { path: 'assets/vase.sog', kind: 'splats' } } }, 'nodes/source/splats/example/');
    await rests();
    await page.call('turnCamera');
    expect(await next()).toBeGreaterThan(0);
    // Nothing changes but the order, which comes from a worker.
    await page.call('untilDrawn');
    await rests();
  });
});

describe('what the CPU computes from an image that nothing changes', () => {
  const assets = { photo: { path: 'assets/sticker.png', kind: 'image' } } as const;

  test('is computed until its result is shown', async () => {
    await open({
      nodes: {
        'photo-a': ['source/image-file', { file: 'photo' }],
        'even-a': 'filter/cpu-equalize-histogram',
        'screen-a': 'output/screen',
      },
      wires: ['photo-a.layer -> even-a.inputImage', 'even-a.layer -> screen-a.layer'],
      assets,
    });
    expect(await untilStill()).toBeGreaterThan(1);
    const equalized = await page.call<ReturnType<typeof images>>('images');
    expect(equalized.kept).toBe(equalized.drawn);
    await setParam('even-a', 'amount', 0);
    expect(await untilStill()).toBeGreaterThan(1);
    const plain = await page.call<ReturnType<typeof images>>('images');
    expect(plain.kept).toBe(plain.drawn);
    expect(plain.kept).not.toBe(equalized.kept);
    await page.call('reset');
    expect(await untilStill()).toBeGreaterThan(1);
  });
});
