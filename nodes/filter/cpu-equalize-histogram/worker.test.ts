import { readFile } from 'node:fs/promises';
import { describe, expect, test } from '@jest/globals';
import { decodeImage, pixelAt, type RgbaImage } from '../../../tests/support/image.ts';
import { countDifferent } from '../../../tests/support/pixels.ts';
import { describeWithData } from '../../../tests/support/shared-data.ts';
import { process } from './worker.ts';

/** OpenCV rounds on the way to YCrCb and back; in 8 bits. */
const TOLERANCE = 2;
const WAYS = [
  ['brightness', 0],
  ['channels', 1],
] as const;

async function read(path: string): Promise<RgbaImage> {
  return decodeImage(await readFile(path));
}

function expected(name: string): Promise<RgbaImage> {
  return read(`tests/browser/expected/${name}.png`);
}

function equalized(picture: RgbaImage, spread: number, amount = 1): RgbaImage {
  const data = Uint8Array.from(picture.data);
  process({ data, widthPx: picture.width, heightPx: picture.height }, { amount, spread });
  return { ...picture, data };
}

/** A part of an image, every `step`th pixel. */
function part(picture: RgbaImage, width: number, height: number, left: number, top: number, step = 1): RgbaImage {
  const data = new Uint8Array(width * height * 4);
  for (let i = 0; i < width * height; i++) data.set(pixelAt(picture, left + (i % width) * step, top + Math.floor(i / width) * step), i * 4);
  return { width, height, data };
}

describe.each(WAYS)('%s', (name, spread) => {
  test('of a dim picture is what OpenCV makes of it', async () => {
    const picture = await expected('dim');
    const made = equalized(picture, spread);
    expect(countDifferent(made, await expected(`dim-equalize-histogram-${name}`), TOLERANCE)).toMatchObject({ pixels: 0 });
    expect(countDifferent(made, picture, 40).pixels).toBeGreaterThan(1000);
  });

  test('an amount of 0 changes nothing', async () => {
    const picture = await expected('generated');
    expect(countDifferent(equalized(picture, spread, 0), picture, 1)).toMatchObject({ pixels: 0 });
  });

  test('what is transparent neither changes nor counts', async () => {
    const picture = await expected('dim');
    const padded: RgbaImage = { ...picture, height: picture.height * 2, data: new Uint8Array(picture.data.length * 2) };
    (padded.data as Uint8Array).set(picture.data);
    const made = equalized(padded, spread).data;
    expect(made.subarray(0, picture.data.length)).toEqual(equalized(picture, spread).data);
    expect(made.subarray(picture.data.length).some((value) => value !== 0)).toBe(false);
  });

  test('a picture half transparent all over is spread as if it were opaque', async () => {
    const picture = await expected('dim');
    const halved: RgbaImage = { ...picture, data: picture.data.map((value) => Math.round((value * 128) / 255)) };
    const opaque = equalized(picture, spread);
    const seen: RgbaImage = { ...opaque, data: opaque.data.map((value) => Math.round((value * 128) / 255)) };
    const made = equalized(halved, spread).data;
    // Half the shades are left of the few that there were, so single pixels land elsewhere; on the whole they do not.
    const difference = made.reduce((sum, value, i) => sum + Math.abs(value - (seen.data[i] ?? 0)), 0) / made.length;
    expect(difference).toBeLessThan(4);
    expect(Math.max(...made)).toBe(128);
  });

  test('a picture of one color stays as it is', () => {
    const gray: RgbaImage = { width: 4, height: 4, data: new Uint8Array(64).fill(99).map((value, i) => (i % 4 === 3 ? 255 : value)) };
    expect(equalized(gray, spread)).toEqual(gray);
  });
});

describeWithData('over a photograph', 'images/astronaut.png', (path) => {
  test.each(WAYS)('%s is what OpenCV makes of it', async (name, spread) => {
    const made = equalized(part(await read(path), 256, 256, 128, 0), spread);
    const kept = part(made, 32, 32, 5, 7, 8);
    expect(countDifferent(kept, await expected(`astronaut-equalize-histogram-${name}`), TOLERANCE)).toMatchObject({ pixels: 0 });
  });
});
