import { readFile } from 'node:fs/promises';
import { describe, expect, test } from '@jest/globals';
import { decodeImage, encodeImage, fromGl, pixelAt, type RgbaImage } from '../support/image.ts';
import { countDifferent, expectPixels, expectSamePixels } from '../support/pixels.ts';

const RED = [255, 0, 0, 255];
const GREEN = [0, 255, 0, 255];

/** 2×2: the pixels from the top left, row by row. */
function picture(...pixels: readonly (readonly number[])[]): RgbaImage {
  return { width: 2, height: 2, data: Uint8Array.from(pixels.flat()) };
}

async function complaint(promise: Promise<void>): Promise<string> {
  return promise.then(
    () => 'passed',
    (error: Error) => error.message,
  );
}

describe('pictures', () => {
  test('PNG bytes come back as they were', () => {
    const original = picture(RED, GREEN, [1, 2, 3, 4], RED);
    expect(decodeImage(encodeImage(original))).toEqual(original);
  });

  test('GL’s bottom row comes last', () => {
    const read = fromGl(2, 2, [...RED, ...RED, ...GREEN, ...RED]);
    expect(pixelAt(read, 0, 0)).toEqual(GREEN);
    expect(pixelAt(read, 0, 1)).toEqual(RED);
  });
});

describe('comparing pictures', () => {
  const expected = picture(RED, RED, RED, RED);
  const almost = picture(RED, [253, 0, 0, 255], RED, RED);

  test('counts pixels beyond the tolerance and tells the largest difference', () => {
    expect(countDifferent(almost, expected)).toEqual({ pixels: 1, largest: 2 });
    expect(countDifferent(almost, expected, 2)).toEqual({ pixels: 0, largest: 2 });
  });

  test('passes within tolerance or within the number of pixels', async () => {
    await expectSamePixels('unit/same', almost, expected, { tolerance: 2 });
    await expectSamePixels('unit/same', almost, expected, { pixels: 1 });
  });

  test('fails with three pictures to look at', async () => {
    const message = await complaint(expectSamePixels('unit/differs', picture(RED, GREEN, RED, RED), expected));
    expect(message).toContain('1 pixels differ by more than 0 (at most 255); 0 may.');
    const paths = [...message.matchAll(/^(?:expected|actual|diff): +(\S+\.png)$/gm)].map((match) => match[1] as string);
    expect(paths).toHaveLength(3);
    const [, , diff] = await Promise.all(paths.map(async (path) => decodeImage(await readFile(path))));
    expect(pixelAt(diff as RgbaImage, 1, 0)).toEqual([255, 0, 0, 255]);
  });

  test('fails on another size', async () => {
    const wide = { width: 4, height: 1, data: expected.data };
    expect(await complaint(expectSamePixels('unit/size', wide, expected))).toContain('4×1 instead of 2×2 pixels');
  });

  test('a missing golden fails and says how to make it', async () => {
    const message = await complaint(expectPixels('never-made', expected));
    expect(message).toContain('tests/goldens/unit/never-made.png');
    expect(message).toContain('UPDATE_GOLDENS=1 npm run test:one unit tests/unit/pixels.test.ts');
  });
});
