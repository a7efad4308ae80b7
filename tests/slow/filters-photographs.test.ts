import { readFile } from 'node:fs/promises';
import { expect, test } from '@jest/globals';
import { PAGE } from '../browser/glsl-kit.ts';
import { applyShader, expectedImage, type Params, photograph, samplesOf } from '../browser/shader-library-kit.ts';
import { useModule } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import { expectSamePixels } from '../support/pixels.ts';
import { describeWithData } from '../support/shared-data.ts';

const page = useModule(PAGE);

function apply(filter: string, inputImage: RgbaImage, params?: Params): Promise<RgbaImage> {
  return applyShader(page, `filters/${filter}.fs`, { inputImage }, params);
}

describeWithData('anisotropic Kuwahara over a photograph', 'images/astronaut.png', (path) => {
  test('is what OpenCV and numpy compute', async () => {
    const drawn = await apply('anisotropic-kuwahara', await photograph(path));
    const file = 'astronaut-anisotropic-kuwahara-6';
    await expectSamePixels(file, samplesOf(drawn), await expectedImage(file), { tolerance: 2 });
  });
});

/**
 * Patches marked by hand in the photographs, [left, top, width, height] in pixels: foreheads, cheeks, necks, backs of hands; and
 * backgrounds, cloth of many colors, hair, wood. The hard rule of Chai and Ngan finds nearly all skin and takes light red and
 * brown things for it as well, which its own paper says; orange cloth it leaves alone.
 */
const PATCHES = [
  {
    path: 'images/astronaut.png',
    skin: [
      [200, 95, 50, 20],
      [195, 125, 20, 15],
      [245, 120, 17, 20],
      [218, 105, 18, 25],
      [205, 172, 35, 13],
    ],
    other: [
      [320, 20, 30, 80],
      [80, 260, 50, 60],
      [400, 420, 80, 60],
      [10, 60, 40, 50],
      [40, 190, 20, 40],
      [180, 35, 80, 30],
    ],
    recall: 0.99,
    precision: 0.35,
  },
  {
    path: 'images/portrait.jpg',
    skin: [
      [344, 112, 112, 35],
      [328, 208, 32, 56],
      [448, 208, 32, 56],
      [376, 312, 56, 32],
      [176, 728, 48, 40],
      [504, 680, 56, 48],
    ],
    other: [
      [176, 448, 128, 192],
      [344, 344, 32, 32],
      [336, 464, 48, 64],
      [8, 192, 88, 128],
      [128, 160, 96, 192],
      [704, 240, 48, 128],
    ],
    recall: 0.99,
    precision: 0.38,
  },
  {
    path: 'images/hands.jpg',
    skin: [
      [112, 214, 101, 90],
      [495, 67, 112, 90],
    ],
    other: [
      [287, 22, 90, 112],
      [349, 225, 90, 135],
    ],
    recall: 0.88,
    precision: 0.99,
  },
] as const;

for (const { path: photo, skin, other, recall, precision } of PATCHES) {
  describeWithData(`skin in ${photo}`, photo, (path) => {
    test('is found, as often and as rightly as by hand', async () => {
      const picture = await decodeInPage(path);
      const mask = await apply('skin-mask', picture, { softness: 0 });
      const count = (patches: readonly (readonly [number, number, number, number])[], white: boolean) =>
        patches.reduce((sum, [left, top, width, height]) => {
          let found = 0;
          for (let i = 0; i < width * height; i++) {
            if ((pixelAt(mask, left + (i % width), top + Math.floor(i / width))[0] ?? 0) > 127 === white) found += 1;
          }
          return sum + found;
        }, 0);
      const [hits, misses, wrong] = [count(skin, true), count(skin, false), count(other, true)];
      expect(hits / (hits + misses)).toBeGreaterThan(recall);
      expect(hits / (hits + wrong)).toBeGreaterThan(precision);
    });
  });
}

/** JPEG too: browsers can. */
async function decodeInPage(path: string): Promise<RgbaImage> {
  const { width, height, data } = await page.page.evaluate(
    async (base64) => {
      const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes]));
      const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
      if (!context) throw new Error('The browser draws no pictures.');
      context.drawImage(bitmap, 0, 0);
      const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
      let text = '';
      for (const byte of data) text += String.fromCharCode(byte);
      return { width: bitmap.width, height: bitmap.height, data: btoa(text) };
    },
    (await readFile(path)).toString('base64'),
  );
  return { width, height, data: new Uint8Array(Buffer.from(data, 'base64')) };
}
