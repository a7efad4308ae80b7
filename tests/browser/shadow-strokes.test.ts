import { expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

/** Strokes of a shadow on a desk. */

const page = useModule('tests/browser/shadow-strokes.page.ts');

test('strokes are denser near the object, and only in its shadow', async () => {
  const { near, far, beyond } = await page.call<Record<'near' | 'far' | 'beyond', number>>('density');
  expect(far).toBeGreaterThan(0.15);
  expect(near / far).toBeGreaterThan(2);
  expect(near).toBeLessThan(0.97);
  expect(beyond).toBe(0);
});

test('below a table, strokes are denser at its foot than under its top', async () => {
  const { foot, top } = await page.call<Record<'foot' | 'top', number>>('belowTable');
  expect(top).toBeGreaterThan(0.15);
  // By the distance to a cylinder around the table, both are equal.
  expect(foot / top).toBeGreaterThan(1.25);
});

test('strokes stay on the desk while the camera moves', async () => {
  const { onDesk, onScreen } = await page.call<{ onDesk: number; onScreen: number }>('anchored');
  expect(onDesk).toBeGreaterThan(0.8);
  expect(onScreen).toBeLessThan(0.3);
});

test('a second light has strokes in another direction', async () => {
  const [first = 0, second = 0] = await page.call<number[]>('directions');
  // Strokes taper, so the tensor is some degrees off.
  expect(Math.abs(first - 0.3)).toBeLessThan(0.15);
  expect(Math.abs(second - 1.4)).toBeLessThan(0.15);
});

test('a contour surrounds the shadow', async () => {
  const [without = 0, contour = 0] = await page.call<number[]>('borders');
  expect(contour).toBeGreaterThan(0.85);
  expect(contour - without).toBeGreaterThan(0.2);
});

test('the contour does not show the texels of a coarse map', async () => {
  const { strayPx, texelPx } = await page.call<{ strayPx: number; texelPx: number }>('straying');
  expect(texelPx).toBeGreaterThan(3);
  // A level of the filtered comparisons strayed by half a texel.
  expect(strayPx / texelPx).toBeLessThan(0.1);
});

test('strokes beside real objects that hide the shadow are those without them', async () => {
  const { changed, inked } = await page.call<{ changed: number; inked: number }>('besideBars');
  expect(inked).toBeGreaterThan(5000);
  // By derivatives beside discarded fragments, they had garbage.
  expect(changed).toBe(0);
});

test('without an error of WebGL', async () => {
  expect(await page.call('error')).toBe(0);
});
