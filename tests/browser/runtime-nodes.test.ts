import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/browser/runtime-nodes.page.ts');

const NO_ERROR = 0;
const NOTHING = [0, 0, 0, 0];

test('the camera picture lies as the session says; without it the world shows, or a color', async () => {
  expect(await page.call('camera')).toEqual({
    seen: [
      [0, 255, 0, 255],
      [0, 0, 255, 255],
    ],
    transparent: NOTHING,
    // Orange at half alpha, premultiplied.
    color: [128, 64, 0, 128],
    changed: [0, 0, 255, 255],
    leaks: [],
    error: NO_ERROR,
  });
});

describe('a picture from a file', () => {
  test('is upright and premultiplied, and loaded once for all programs that use it', async () => {
    expect(await page.call('image')).toEqual({
      corners: [[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 100, 128], NOTHING],
      still: [255, 0, 0, 255],
      without: NOTHING,
      freed: 1,
      loads: ['assets/photo.png'],
      diagnostics: [],
      leaks: [],
      error: NO_ERROR,
    });
  });

  test('that cannot be had is told at the node, with what to do', async () => {
    const told = await page.call<{ code: string; nodeId: string; message: string; fix: string }[]>('brokenAssets');
    expect(told.map(({ code, nodeId, message }) => `${code} ${nodeId}: ${message}`)).toEqual([
      expect.stringMatching(/^SCR032 source\/image-file: The image "assets\/torn.png" cannot be decoded: /),
      'SCR030 source/image-file: The image "assets/gone.png" cannot be read: there is no such file.',
      'SCR033 source/image-file: "assets/robot.glb" is a model, but the node needs an image.',
      'SCR030 source/image-file: The asset "nowhere" is not in the project.',
    ]);
    expect(told.every((diagnostic) => diagnostic.fix.length > 0)).toBe(true);
  });
});

interface Hidden {
  readonly alphas: number[][];
  readonly reds: number[][];
  readonly unknown: number[];
  readonly error: number;
}

describe('depth occlusion', () => {
  /** The layer's depth in its four columns; 0 is none. */
  const LAYER_M = [0, 1, 2, 3];

  test('hides what lies behind the room, and nothing where either depth is unknown', async () => {
    const { alphas, unknown, error } = await page.call<Hidden>('hide', 0, 0, [0, 0.5, 1, 2.5]);
    expect(alphas).toEqual([
      [255, 255, 255, 255],
      [255, 0, 0, 0],
      [255, 255, 0, 0],
      [255, 255, 255, 0],
    ]);
    // A session without depth.
    expect(unknown).toEqual([255, 0, 0, 255]);
    expect(error).toBe(NO_ERROR);
  });

  test('lets things be behind by the tolerance', async () => {
    const { alphas } = await page.call<Hidden>('hide', 0.25, 0, [0.8, 0.7]);
    expect(alphas).toEqual([
      [255, 255, 0, 0],
      [255, 0, 0, 0],
    ]);
  });

  test('fades over the softness, color and alpha alike', async () => {
    const [biasM, softnessM, roomM] = [0.1, 4, [0.7, 1.5]];
    const { alphas, reds } = await page.call<Hidden>('hide', biasM, softnessM, roomM);
    const expected = roomM.map((room) =>
      LAYER_M.map((layer) => Math.round(255 * (layer === 0 ? 1 : 1 - Math.min(Math.max((layer - room - biasM) / softnessM, 0), 1)))),
    );
    expect(alphas).toEqual(expected);
    expect(reds).toEqual(expected);
  });
});
