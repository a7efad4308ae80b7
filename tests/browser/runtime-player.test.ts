import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/browser/runtime-player.page.ts');

const NO_ERROR = 0;

describe('passes', () => {
  test('draw in order with live params, whatever state the context is in', async () => {
    expect(await page.call('playsPasses')).toEqual({
      before: [204, 153, 102, 255],
      after: [0, 0, 255, 255],
      accepted: [true, false, false],
      error: NO_ERROR,
    });
  });

  test('get the automatic uniforms and every type of slot', async () => {
    expect(await page.call('builtins')).toEqual({ result: [0, 255, 0, 255], error: NO_ERROR });
  });

  test('get the properties of an image without sampling it', async () => {
    expect(await page.call('asideFromImage')).toEqual({ size: [20, 10, 0, 255], placement: [51, 102, 0, 255], decode: [0, 255, 0, 255] });
  });

  test('a persistent buffer counts frames per view, keeps its picture over a resize and forgets it on reset', async () => {
    expect(await page.call('persistent')).toEqual({ left: 48, right: 48, resized: 64, restarted: 16, error: NO_ERROR });
  });

  test('targets follow their size expressions every frame', async () => {
    // 64×32 view: small = floor(64/4) × max(8, 5) = 16×8, smaller = 14 × ceil(8/3).
    // At one half: 32×16 → 30×6. View 40×30 at one half: 20×15 → 18×5.
    expect(await page.call('sizes')).toEqual({
      quarter: [14, 3, 0, 255],
      half: [30, 6, 0, 255],
      other: [18, 5, 0, 255],
      error: NO_ERROR,
    });
  });
});

test('each view has its own part of the screen and its own world behind', async () => {
  expect(await page.call('views')).toEqual({
    // A fifth of blue over red, over the mirrored picture's green.
    world: [
      [255, 0, 0, 255],
      [204, 0, 51, 255],
      [255, 255, 255, 255],
      [0, 204, 51, 255],
    ],
    device: [
      [0, 0, 0, 0],
      [0, 0, 51, 51],
    ],
    colored: [
      [102, 102, 0, 102],
      [82, 82, 51, 133],
    ],
    error: NO_ERROR,
  });
});

test('nodes that draw to the screen come one over the other, inside their view', async () => {
  expect(await page.call('screenDraws')).toEqual({
    over: [0, 0, 255, 255],
    last: [0, 255, 0, 255],
    beside: [0, 0, 0, 0],
    error: NO_ERROR,
  });
});

test('views of different sizes have targets of their own, equal ones share', async () => {
  expect(await page.call('unequalViews')).toEqual({
    shown: [
      [40, 30, 0, 255],
      [20, 10, 0, 255],
    ],
    kept: true,
    shared: 1,
    error: NO_ERROR,
  });
});
