import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import type { TapSeen } from './runtime-input.page.ts';

const chromium = useBrowser();
let page: PageModule;

beforeAll(async () => {
  page = await openModule(chromium.browser, 'tests/browser/runtime-input.page.ts');
  await page.call('begin');
});

afterAll(async () => {
  await page.close();
  expect(page.errors).toEqual([]);
});

const seen = (): Promise<TapSeen[]> => page.call<TapSeen[]>('seen');
const near = (numbers: readonly number[]) => numbers.map((x) => expect.closeTo(x, 4));
const TAN = Math.tan((25 * Math.PI) / 180);

// The tests go on from one another, as a visitor does.
describe('a canvas on a page', () => {
  test('is tapped by a click, through the point that was clicked', async () => {
    await page.page.mouse.click(300, 100);
    const [tap, ...more] = await seen();
    expect(more).toEqual([]);
    const length = Math.hypot(TAN / 2, TAN / 2, 1);
    expect(tap).toEqual({ by: 'screen', origin: near([0, 1, 2]), direction: near([TAN / 2 / length, TAN / 2 / length, -1 / length]) });
    expect(await seen()).toEqual([]);
  });

  test('is not by a drag, nor by the other button', async () => {
    const { mouse } = page.page;
    await mouse.move(200, 200);
    await mouse.down();
    await mouse.move(230, 200, { steps: 3 });
    await mouse.up();
    await mouse.click(200, 200, { button: 'right' });
    expect(await seen()).toEqual([]);
  });

  test('is tapped in its middle by the keyboard', async () => {
    await page.page.focus('canvas');
    await page.page.keyboard.press('Home');
    await page.page.keyboard.press('Enter');
    await page.page.keyboard.press(' ');
    expect(await seen()).toEqual([1, 2].map(() => ({ by: 'screen', origin: near([0, 1, 2]), direction: near([0, 0, -1]) })));
  });

  test('has the halves of a gamepad as controllers, once the browser tells of it', async () => {
    const rest = { connected: false, stick: [0, 0], trigger: 0, squeeze: 0, primary: false, secondary: false, ray: null };
    expect(await page.call('gamepad')).toEqual({
      unheard: rest,
      plugged: { ...rest, connected: true, stick: [0.25, 1], trigger: 0.5, primary: true },
      unplugged: rest,
    });
  });

  test('hears nothing any more after the end', async () => {
    expect(await page.call('end')).toBe(0);
  });
});

describe('an AR session', () => {
  test('is tapped on the screen of a phone: once, when the finger lets go, along the view', async () => {
    const perFrame = await page.call<TapSeen[][]>('phone');
    expect(perFrame.map((taps) => taps.length).sort()).toEqual([0, 0, 0, 0, 0, 1]);
    expect(perFrame.slice(0, 3).flat()).toEqual([]);
    expect(perFrame.flat()).toEqual([{ by: 'screen', origin: near([1, 1.5, 2]), direction: near([0, 0, -1]) }]);
  });

  test('has the controllers of a headset, and is tapped by their triggers', async () => {
    const { held, taps } = await page.call<{ held: object; taps: TapSeen[] }>('headset');
    expect(held).toMatchObject({ connected: true, stick: [0, 0.75], trigger: 1, squeeze: 0, primary: true, secondary: false });
    expect(held).toHaveProperty('ray', near([0.3, 1.2, -0.4]));
    expect(taps).toMatchObject([{ by: 'right', origin: near([0.3, 1.2, -0.4]) }]);
  });
});
