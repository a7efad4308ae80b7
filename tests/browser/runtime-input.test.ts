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

  interface Followed {
    readonly phases: readonly string[];
    readonly heading: number;
  }
  const pointers = (): Promise<Followed> => page.call<Followed>('pointers');
  const phasesOf = ({ phases }: Followed, by: string) =>
    phases.flatMap((word) => (word.startsWith(by) ? [word.replace(/^\S+ \S+ /, '')] : []));

  test('follows the mouse from hovering through a press to its end', async () => {
    const { mouse } = page.page;
    await mouse.move(100, 100);
    await pointers();
    await mouse.down();
    await pointers();
    await mouse.move(160, 100, { steps: 3 });
    await mouse.up();
    expect(phasesOf(await pointers(), 'mouse')).toEqual(['hold', 'end', 'hover']);
    await mouse.move(600, 600);
    await pointers();
    expect((await pointers()).phases).toEqual([]);
  });

  test('a press that a node claims does not turn the view, and one that no node claims does', async () => {
    const { mouse } = page.page;
    const drag = async () => {
      await mouse.move(200, 200);
      await mouse.down();
      const { heading } = await pointers();
      await mouse.move(260, 200, { steps: 3 });
      const after = await pointers();
      await mouse.up();
      await pointers();
      return after.heading - heading;
    };
    await page.call('claim', true);
    expect(await drag()).toBe(0);
    await page.call('claim', false);
    expect(Math.abs(await drag())).toBeGreaterThan(0.1);
    await seen();
  });

  test('a press that is over before the next frame starts where it was pressed, and turns the view only if no node claims it', async () => {
    const flick = () => page.call<{ start: number[]; heading: number }>('flick');
    await page.page.mouse.move(200, 200);
    const { heading } = await pointers();
    await page.call('claim', true);
    const claimed = await flick();
    expect(claimed.heading).toBe(heading);
    // Along the view's axis, on which the press began.
    expect(Math.atan2(-(claimed.start[0] as number), -(claimed.start[2] as number))).toBeCloseTo(heading, 4);
    await page.call('claim', false);
    const free = await flick();
    expect(Math.abs(free.heading - heading)).toBeGreaterThan(0.1);
    await pointers();
  });

  test('has a pointer for each finger, and two fingers make no tap', async () => {
    const canvas = page.page.locator('canvas');
    const touch = (type: string, pointerId: number, clientX: number) =>
      canvas.dispatchEvent(type, {
        pointerId,
        pointerType: 'touch',
        button: 0,
        clientX,
        clientY: 100,
        bubbles: true,
        isPrimary: pointerId === 11,
      });
    await pointers();
    // Made by a script, they cannot be captured.
    await page.page.evaluate(() => {
      Element.prototype.setPointerCapture = () => {};
    });
    await touch('pointerdown', 11, 100);
    await touch('pointerdown', 12, 200);
    const pressed = await pointers();
    const ids = pressed.phases.flatMap((word) => (word.startsWith('screen') ? [word.split(' ')[1]] : []));
    expect(new Set(ids).size).toBe(2);
    await touch('pointerup', 11, 100);
    await touch('pointercancel', 12, 200);
    const over = await pointers();
    expect([phasesOf(pressed, 'screen'), phasesOf(over, 'screen').sort()].flat()).toEqual(
      expect.arrayContaining(['start', 'start', 'cancel', 'end']),
    );
    expect([pressed, over].flatMap(({ phases }) => phases.filter((word) => word.endsWith('tapped')))).toEqual([]);
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
    const buttons = { primary: false, secondary: false, stickPressed: false };
    const rest = {
      connected: false,
      stick: [0, 0],
      trigger: 0,
      squeeze: 0,
      ...buttons,
      ray: null,
      grip: null,
      bare: false,
      vibrates: false,
    };
    expect(await page.call('gamepad')).toEqual({
      unheard: rest,
      plugged: { ...rest, connected: true, stick: [0.25, 1], trigger: 0.5, primary: true },
      unplugged: rest,
    });
  });

  test('is pointed at by the left stick of a gamepad and pressed by A', async () => {
    const { tap, phases, left } = await page.call<{ tap: TapSeen; phases: string[]; left: string }>('gamepadPointer');
    expect(phases.filter((phase) => phase !== 'mouse hover')).toEqual(['mouse start', 'mouse hold', 'mouse end tapped']);
    // Right of the middle, as high as it, as the ring is.
    const [x = 0, y = 0, z = 0] = tap.direction;
    expect(y).toBeCloseTo(0, 4);
    expect(x / -z).toBeGreaterThan(0.02);
    expect(Number.parseFloat(left)).toBeGreaterThan(204);
  });

  test('hears nothing any more after the end', async () => {
    expect(await page.call('end')).toBe(0);
  });
});

test('over the camera a gamepad points and presses too: at the left of what the camera sees, as its ring shows', async () => {
  interface Told {
    readonly tapped: readonly TapSeen[];
    readonly told: readonly string[];
    readonly axis: readonly number[];
    readonly hasRing: boolean;
    readonly ringStays: boolean;
  }
  const { tapped, told, axis, hasRing, ringStays } = await page.call<Told>('cameraGamepad');
  expect(told.filter((phase) => phase !== 'mouse hover')).toEqual(['mouse start', 'mouse hold', 'mouse end']);
  const [tap, ...more] = tapped;
  expect(more).toEqual([]);
  expect(tap?.origin).toEqual(near([0, 1.5, 2]));
  const [x = 0, y = 0, z = 0] = tap?.direction ?? [];
  const [, down = 0, ahead = 0] = axis;
  // As high in the view as its axis, and left of it.
  expect(x).toBeLessThan(-0.02);
  expect(y / z).toBeCloseTo(down / ahead, 4);
  expect([hasRing, ringStays]).toEqual([true, false]);
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
