import { describe, expect, test } from '@jest/globals';
import sharp, { type Sharp } from 'sharp';
import { useModule } from '../support/browser.ts';
import type { load } from './image-formats.page.ts';

const page = useModule('tests/browser/image-formats.page.ts');

const WIDTH = 48;
const HEIGHT = 32;

/** Four quarters, so that every turn and mirror image differs. `alpha` is that of the lower right one. */
function quarters(alpha = 1): Sharp {
  const colors = [
    [230, 30, 30, 255],
    [30, 200, 30, 255],
    [30, 30, 220, 255],
    [200, 200, 40, Math.round(alpha * 255)],
  ] as const;
  const pixels = Buffer.alloc(WIDTH * HEIGHT * 4);
  for (let y = 0; y < HEIGHT; y++)
    for (let x = 0; x < WIDTH; x++) pixels.set(colors[(x < WIDTH / 2 ? 0 : 1) + (y < HEIGHT / 2 ? 0 : 2)] ?? [], 4 * (y * WIDTH + x));
  return sharp(pixels, { raw: { width: WIDTH, height: HEIGHT, channels: 4 } });
}

/** Compares what a page loads with what another decoder shows of the file, in the middle of each quarter. */
async function expectSame(file: Buffer, tolerance: number): Promise<void> {
  const { data, info } = await sharp(file)
    .rotate()
    .ensureAlpha()
    .toColorspace('srgb')
    .raw({ depth: 'uchar' })
    .toBuffer({ resolveWithObject: true });
  const { widthPx, heightPx, pixels } = await page.call<Awaited<ReturnType<typeof load>>>('load', [...file]);
  expect([widthPx, heightPx]).toEqual([info.width, info.height]);
  for (const [u, v] of [
    [0.25, 0.25],
    [0.75, 0.25],
    [0.25, 0.75],
    [0.75, 0.75],
  ] as const) {
    const [x, y] = [Math.floor(u * widthPx), Math.floor(v * heightPx)];
    const at = 4 * ((heightPx - 1 - y) * widthPx + x);
    const expected = data.subarray(4 * (y * widthPx + x), 4 * (y * widthPx + x) + 4);
    const alpha = (expected[3] ?? 0) / 255;
    for (let c = 0; c < 4; c++) {
      const channel = (expected[c] ?? 0) * (c < 3 ? alpha : 1);
      expect([u, v, c, Math.abs((pixels[at + c] ?? 0) - channel) <= tolerance]).toEqual([u, v, c, true]);
    }
  }
}

describe('image files', () => {
  test.each([1, 2, 3, 4, 5, 6, 7, 8])('a JPEG file with EXIF orientation %d stands as in other programs', async (orientation) => {
    await expectSame(await quarters().removeAlpha().withMetadata({ orientation }).jpeg({ quality: 95 }).toBuffer(), 12);
  });

  test.each([
    ['a PNG file with 16 bits', (image: Sharp) => image.toColorspace('rgb16').png(), 1],
    ['a PNG file with a palette', (image: Sharp) => image.png({ palette: true }), 3],
    ['a PNG file in passes', (image: Sharp) => image.png({ progressive: true }), 1],
    ['a GIF file', (image: Sharp) => image.gif(), 3],
    ['an AVIF file', (image: Sharp) => image.avif({ quality: 90, effort: 0 }), 12],
    ['a WebP file', (image: Sharp) => image.webp({ quality: 95 }), 12],
  ] as const)('%s has its colors and its alpha', async (name, encode, tolerance) => {
    await expectSame(await encode(quarters(name.includes('GIF') ? 0 : 0.5)).toBuffer(), tolerance);
  });
});
