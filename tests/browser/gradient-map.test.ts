import { expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import { expectSamePixels } from '../support/pixels.ts';
import { PAGE, paint } from './glsl-kit.ts';
import { applyShader, expectedImage, type Params } from './shader-library-kit.ts';

const page = useModule(PAGE);

/** Blue up to a half, there green, then to red. */
const GRADIENT = [0, 0, 0, 1, 1, 2, 0.5, 0, 1, 0, 1, 0, 1, 1, 0, 0, 1, 0];

function expected(position: number): readonly [number, number, number] {
  const at = Math.min(Math.max(position, 0), 1);
  return at < 0.5 ? [0, 0, 255] : [510 * (at - 0.5), 510 * (1 - at), 0];
}

const luma = ([r, g, b]: readonly number[]) => ((r ?? 0) * 0.2126 + (g ?? 0) * 0.7152 + (b ?? 0) * 0.0722) / 255;

/** Near the step at a half the table has one color for two positions. */
const isAtStep = (position: number) => Math.abs(position - 0.5) < 1 / 255;

async function expectMapped(name: string, params: Params, position: (pixel: readonly number[]) => number): Promise<void> {
  const image = await expectedImage('generated');
  const drawn = await applyShader(page, 'filters/gradient-map.fs', { inputImage: image }, { gradient: GRADIENT, ...params });
  // Pixels have premultiplied alpha.
  const wanted: RgbaImage = paint(image.width, image.height, (x, y) => {
    const pixel = pixelAt(image, x, y);
    const alpha = pixel[3] / 255;
    const at = position(pixel.map((channel) => (alpha > 0 ? channel / alpha : 0)));
    if (isAtStep(at)) return pixelAt(drawn, x, y);
    const [r, g, b] = expected(at);
    return [r * alpha, g * alpha, b * alpha, pixel[3]];
  });
  await expectSamePixels(name, drawn, wanted, { tolerance: 2 });
}

test('the brightness of a pixel chooses its color, before and after a step, and its alpha stays', async () => {
  await expectMapped('gradient-brightness', {}, luma);
});

test('a channel chooses it, shifted and mirrored', async () => {
  await expectMapped('gradient-mirrored', { channel: 1, shift: 0.6, beyond: 2 }, ([r = 0]) => 1 - Math.abs(1 - (r / 255 + 0.6)));
});

test('from alpha, a transparent layer gets the colors of the gradient with their own alpha', async () => {
  const fading = paint(4, 1, (x) => [90, 20, 200, x * 85]);
  const gradient = [0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0.2, 0];
  const drawn = await applyShader(page, 'filters/gradient-map.fs', { inputImage: fading }, { gradient, channel: 4 });
  expect(pixelAt(drawn, 0, 0)).toEqual([255, 0, 0, 255]);
  // A third of the way, premultiplied: red 2/3, blue 1/3 of 0.2.
  expect(pixelAt(drawn, 1, 0)[3]).toBeCloseTo(255 * (2 / 3 + 0.2 / 3), -0.5);
  expect(pixelAt(drawn, 3, 0)[3]).toBe(51);
});

test('without amount, nothing changes', async () => {
  const image = await expectedImage('generated');
  const drawn = await applyShader(page, 'filters/gradient-map.fs', { inputImage: image }, { amount: 0 });
  await expectSamePixels('gradient-identity', drawn, image, { tolerance: 1 });
});
