import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import { eventually } from '../support/patience.ts';
import type { Look } from './runtime-orbit.page.ts';

const chromium = useBrowser();
let page: PageModule;

beforeAll(async () => {
  page = await openModule(chromium.browser, 'tests/browser/runtime-orbit.page.ts');
  await page.call('begin');
});

afterAll(async () => {
  await page.close();
  expect(page.errors).toEqual([]);
});

const seen = (): Promise<Look> => page.call<Look>('seen');

/** Wheel events are on their way when the call that makes them returns. */
async function seenWhen(is: (look: Look) => boolean): Promise<Look> {
  return eventually(async () => {
    const look = await seen();
    if (!is(look)) throw new Error('The view never changed as expected.');
    return look;
  });
}

function distance({ position: [x = 0, y = 0, z = 0] }: Look, target = [0, 1, 0]): number {
  return Math.hypot(x - (target[0] ?? 0), y - (target[1] ?? 0), z - (target[2] ?? 0));
}

/** The angle about the vertical at which the viewer stands. */
function azimuth({ position: [x = 0, , z = 0] }: Look): number {
  return Math.atan2(x, z);
}

async function drag(dx: number, dy: number, button: 'left' | 'right' = 'left'): Promise<void> {
  const { mouse } = page.page;
  await mouse.move(200, 150);
  await mouse.down({ button });
  await mouse.move(200 + dx, 150 + dy, { steps: 4 });
  await mouse.up({ button });
}

// The tests go on from one another, as a visitor does.
describe('an orbit', () => {
  test('begins before its point, with half of 50° down and what the shape gives across', async () => {
    const look = await seen();
    const tan = Math.tan((25 * Math.PI) / 180);
    expect(look.position).toEqual([0, 1, 2]);
    expect(look.forward.map((v) => v + 0)).toEqual([expect.closeTo(0), expect.closeTo(0), -1]);
    expect(look.sizePx).toEqual([400, 300]);
    expect(look.tan).toEqual([expect.closeTo((tan * 4) / 3, 5), expect.closeTo(tan, 5)]);
    expect(look.timesRise).toBe(true);
  });

  test('turns with a drag: the height of the canvas is half a turn', async () => {
    await drag(-75, 0);
    const look = await seen();
    expect(azimuth(look)).toBeCloseTo(Math.PI / 4, 4);
    expect(distance(look)).toBeCloseTo(2, 5);
    await drag(75, 30);
    const above = await seen();
    expect(azimuth(above)).toBeCloseTo(0, 4);
    expect(above.position[1]).toBeCloseTo(1 + 2 * Math.sin(Math.PI / 10), 4);
  });

  test('goes nearer with the wheel and with two fingers', async () => {
    await page.page.keyboard.press('Home');
    await page.page.mouse.wheel(0, -100);
    const near = await seenWhen((look) => distance(look) < 1.99);
    expect(distance(near)).toBeCloseTo(2 * Math.exp(-0.1), 3);
    await page.call('pinch', 200, 0);
    expect(distance(await seen())).toBeCloseTo(Math.exp(-0.1), 3);
  });

  test('turns, goes nearer and goes back by keys alone', async () => {
    const { keyboard } = page.page;
    await page.page.focus('canvas');
    await keyboard.press('Home');
    await keyboard.press('ArrowRight');
    await keyboard.press('ArrowRight');
    await keyboard.press('ArrowUp');
    await keyboard.press('+');
    const look = await seen();
    expect(azimuth(look)).toBeCloseTo(0.2, 5);
    expect(distance(look)).toBeCloseTo(2 / 1.1, 5);
    expect(look.position[1]).toBeCloseTo(1 + (2 / 1.1) * Math.sin(0.1), 5);
    await keyboard.press('Home');
    expect((await seen()).position).toEqual([0, 1, 2]);
  });

  test('moves its point with the right button, as far as the mouse', async () => {
    await drag(60, 0, 'right');
    const look = await seen();
    // 60 of 300 px are a fifth of what is seen down at 2 m.
    expect(look.position[0]).toBeCloseTo(-0.2 * 2 * 2 * Math.tan((25 * Math.PI) / 180), 4);
    expect(look.position[2]).toBeCloseTo(2, 5);
  });

  test('follows the size of the canvas; upright, the angle counts across', async () => {
    await page.call('resize', 200, 400);
    const look = await seen();
    const tan = Math.tan((25 * Math.PI) / 180);
    expect(look.sizePx).toEqual([200, 400]);
    expect(look.tan).toEqual([expect.closeTo(tan, 5), expect.closeTo(tan * 2, 5)]);
  });

  test('leaves the canvas as it was', async () => {
    expect(await page.call('end')).toEqual({
      tabIndex: 0,
      after: null,
      touchAction: '',
      framesAfter: 0,
      events: [{ kind: 'ended', by: 'page' }],
    });
  });
});
