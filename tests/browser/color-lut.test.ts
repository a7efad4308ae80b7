import { readFile } from 'node:fs/promises';
import { test } from '@jest/globals';
import { lutImage } from '../../export/glsl/lut/lut-image.ts';
import { readCube } from '../../export/glsl/lut/read-cube.ts';
import { useModule } from '../support/browser.ts';
import { decodeImage, pixelAt, type RgbaImage } from '../support/image.ts';
import { expectSamePixels } from '../support/pixels.ts';
import { describeWithData } from '../support/shared-data.ts';
import { made, PAGE, paint } from './glsl-kit.ts';
import { applyShader, expectedImage } from './shader-library-kit.ts';

/** Half a step of rounding in the table, in the result and in the expected image, and single precision. */
const TOLERANCE = 2;

const page = useModule(PAGE);

async function tableOf(name: string) {
  const text = await readFile(`tests/browser/expected/${name}.cube`, 'utf8');
  const { widthPx, heightPx, size, columns, rgba } = lutImage(made(readCube(text, `${name}.cube`)));
  return { table: { width: widthPx, height: heightPx, data: rgba }, params: { size, columns } };
}

async function grade(inputImage: RgbaImage, name: string, amount = 1): Promise<RgbaImage> {
  const { table, params } = await tableOf(name);
  return applyShader(page, 'operators/color-lut.fs', { inputImage, table }, { ...params, amount });
}

test.each(['look', 'curve'])('%s: the generated picture is graded as colour-science does it', async (name) => {
  const file = `generated-color-lut-${name}`;
  const graded = await grade(await expectedImage('generated'), name);
  await expectSamePixels(file, graded, await expectedImage(file), { tolerance: TOLERANCE });
});

test('an amount of 0 changes nothing', async () => {
  const picture = await expectedImage('generated');
  await expectSamePixels('color-lut-identity', await grade(picture, 'look', 0), picture, { tolerance: 1 });
});

describeWithData('over a photograph', 'images/astronaut.png', (path) => {
  test.each(['look', 'curve'])('%s is what colour-science computes', async (name) => {
    const whole = decodeImage(await readFile(path));
    const graded = await grade(
      paint(256, 256, (x, y) => pixelAt(whole, x + 128, y)),
      name,
    );
    // Every eighth pixel of what was computed is kept.
    const kept = paint(32, 32, (x, y) => pixelAt(graded, 5 + x * 8, 7 + y * 8));
    const file = `astronaut-color-lut-${name}`;
    await expectSamePixels(file, kept, await expectedImage(file), { tolerance: TOLERANCE });
  });
});
