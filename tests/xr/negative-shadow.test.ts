import { resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import type { DeviceName } from '../../export/emulator/profiles.ts';
import { useBrowser } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import { serveProject } from '../support/project-page.ts';
import { openXrPage } from './xr-page.ts';

const EXAMPLE = resolve(import.meta.dirname, '../../nodes/layer/negative-shadow/example');
const chromium = useBrowser();

let served: Awaited<ReturnType<typeof serveProject>>;
beforeAll(async () => {
  served = await serveProject(EXAMPLE);
});
afterAll(() => served.close());

/** What a device shows of the ball on the floor, seen from the front and above, in the first view. */
async function see(device: DeviceName): Promise<{ layer: RgbaImage; seen: RgbaImage; room: RgbaImage; errors: readonly string[] }> {
  const xr = await openXrPage(chromium.browser, served.url, { room: 'studio', device, views: 1, fovYRad: 0.9, sizePx: [320, 240] });
  try {
    await xr.enter();
    // A turn of -0.7 rad about x.
    await xr.setPose({ position: [0, 1.4, 0.2], quaternion: [-0.343, 0, 0, 0.939] });
    await xr.step(3);
    return { layer: await xr.readLayer(), seen: await xr.readComposite(), room: await xr.readRoom(), errors: xr.errors };
  } finally {
    await xr.close();
  }
}

const gray = (picture: RgbaImage, x: number, y: number): number => pixelAt(picture, x, y)[1];

/** All pixels where the layer has no object: only light and shadow, which is gray. */
function floorPixels(layer: RgbaImage): readonly (readonly [x: number, y: number])[] {
  return Array.from({ length: layer.width * layer.height }, (_, i) => [i % layer.width, Math.floor(i / layer.width)] as const).filter(
    ([x, y]) => pixelAt(layer, x, y)[3] === 0,
  );
}

test('glasses show light around the ball, which its shadow interrupts, and nothing beyond', async () => {
  const { layer, seen, room, errors } = await see('glasses');
  expect(errors).toEqual([]);
  const floor = floorPixels(layer);
  const levels = floor.map(([x, y]) => gray(layer, x, y));
  const brightest = Math.max(...levels);
  // The base of 0.055 is level 14.
  expect(brightest).toBe(14);
  const lit = floor.filter(([x, y]) => gray(layer, x, y) === brightest);
  expect(lit.length).toBeGreaterThan(300);
  const [left, right] = [Math.min(...lit.map(([x]) => x)), Math.max(...lit.map(([x]) => x))];
  const [top, bottom] = [Math.min(...lit.map(([, y]) => y)), Math.max(...lit.map(([, y]) => y))];
  const dark = floor.filter(([x, y]) => x > left && x < right && y > top && y < bottom && gray(layer, x, y) === 0);
  expect(dark.length).toBeGreaterThan(100);
  // Light is added in linear light, so it is seen as several levels, and a pixel that the layer leaves black shows the room.
  const step = lit.reduce((sum, [x, y]) => sum + gray(seen, x, y) - gray(room, x, y), 0) / lit.length;
  expect(step).toBeGreaterThanOrEqual(4);
  for (const [x, y] of floor) if (gray(layer, x, y) === 0) expect(gray(seen, x, y)).toBe(gray(room, x, y));
});

test('a phone, which can darken, shows an ordinary shadow of the same project', async () => {
  const { layer, seen, room, errors } = await see('phone');
  expect(errors).toEqual([]);
  const shadow = Array.from(
    { length: layer.width * layer.height },
    (_, i) => [i % layer.width, Math.floor(i / layer.width)] as const,
  ).filter(([x, y]) => {
    const [red, green, blue, alpha] = pixelAt(layer, x, y);
    return red + green + blue === 0 && alpha > 110 && alpha < 135;
  });
  expect(shadow.length).toBeGreaterThan(100);
  for (const [x, y] of shadow) expect(gray(seen, x, y)).toBeLessThanOrEqual(gray(room, x, y));
});
