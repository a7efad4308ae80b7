import { readFile } from 'node:fs/promises';
import { describe, expect, test } from '@jest/globals';
import { isfDefinition, shaderName } from '../../export/glsl/isf/isf-definition.ts';
import { readIsf } from '../../export/glsl/isf/read-isf.ts';
import { linkIsfDepth } from '../../export/glsl/link/link-depth.ts';
import { linkIsf } from '../../export/glsl/link/link-isf.ts';
import over from '../../shader-library/operators/over.fs';
import { useModule } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import { expectSamePixels } from '../support/pixels.ts';
import { drawFloats, drawPicture, made, PAGE, paint, toPage } from './glsl-kit.ts';
import { applyShader, expectedImage as expected, type Params, SHADERS } from './shader-library-kit.ts';

/** Half a step of rounding on either side and one for arithmetic in single precision. */
const TOLERANCE = 2;

const page = useModule(PAGE);

function apply(file: string, pictures: Readonly<Record<string, RgbaImage>>, params?: Params) {
  return applyShader(page, file, pictures, params);
}

/** `formula` works on straight colors from 0 to 1; the layer around it is premultiplied and 8 bits. */
function each(
  picture: RgbaImage,
  formula: (rgb: number[], alpha: number, x: number, y: number) => [rgb: number[], alpha: number],
): RgbaImage {
  return paint(picture.width, picture.height, (x, y) => {
    const [r, g, b, a] = pixelAt(picture, x, y);
    const straight = a === 0 ? [0, 0, 0] : [r / a, g / a, b / a];
    const [rgb, alpha] = formula(straight, a / 255, x, y);
    const [red = 0, green = 0, blue = 0] = rgb.map((value) => Math.round(255 * alpha * Math.min(Math.max(value, 0), 1)));
    return [red, green, blue, Math.round(255 * alpha)];
  });
}

const LUMA_709 = [0.2126, 0.7152, 0.0722];

function dot(a: readonly number[], b: readonly number[]): number {
  return a.reduce((sum, value, i) => sum + value * (b[i] ?? 0), 0);
}

describe.each(Object.keys(SHADERS))('%s', (file) => {
  test('has a header that reads without a word and documents every input', () => {
    const { output, diagnostics } = readIsf(SHADERS[file] ?? '', file);
    expect(diagnostics).toEqual([]);
    const definition = isfDefinition(made({ output, diagnostics }), shaderName(file));
    expect(definition.type).toBe(file.replace('s/', '/').replace('.fs', ''));
    expect(definition.credit).toMatch(/Scrim/);
    for (const port of [...Object.values(definition.inputs), ...Object.values(definition.params)]) {
      expect(port.doc).not.toBe('');
      expect(port.label).not.toBe('');
    }
  });

  test('compiles in a host that only puts ISF’s own macros before it', async () => {
    const shader = made(readIsf(SHADERS[file] ?? '', file));
    const types = {
      image: 'sampler2D',
      float: 'float',
      bool: 'bool',
      long: 'int',
      point2D: 'vec2',
      color: 'vec4',
      audio: 'sampler2D',
      audioFFT: 'sampler2D',
    } as Record<string, string>;
    const images = [
      ...shader.inputs.filter((input) => input.type === 'image').map((input) => input.name),
      ...shader.passes.flatMap((pass) => pass.target ?? []),
    ];
    const prelude = [
      'precision highp float;',
      'precision highp int;',
      'varying vec2 isf_FragNormCoord;',
      'uniform vec2 RENDERSIZE;',
      'uniform int PASSINDEX;',
      'uniform float TIME;',
      ...shader.inputs
        .filter((input) => input.type in types && input.type !== 'image')
        .map((input) => `uniform ${types[input.type]} ${input.name};`),
      ...images.map((name) => `uniform sampler2D ${name};`),
      '#define IMG_NORM_PIXEL(image, uv) texture2D(image, uv)',
      '#define IMG_THIS_PIXEL(image) texture2D(image, isf_FragNormCoord)',
      '#define IMG_SIZE(image) RENDERSIZE',
    ].join('\n');
    expect(await page.call<string>('compileElsewhere', `${prelude}\n${SHADERS[file]}`)).toBe('');
  });
});

test('the filter that the README teaches works', async () => {
  const readme = await readFile('shader-library/README.md', 'utf8');
  const corners = /```glsl\n([\s\S]*?)```/.exec(readme)?.[1]?.replace(/^ {3}/gm, '') ?? '';
  const { output, diagnostics } = readIsf(corners, 'filters/dark-corners.fs');
  expect(diagnostics).toEqual([]);
  const white = paint(32, 32, () => [255, 255, 255, 255]);
  const passes = made(linkIsf(made({ output, diagnostics }), { node: 'test' }));
  const drawn = await drawPicture(page, {
    width: 32,
    height: 32,
    passes,
    pictures: { inputImage: toPage(white) },
    params: { amount: 0.5 },
  });
  expect(pixelAt(drawn, 16, 16)[0]).toBeGreaterThan(253);
  expect(pixelAt(drawn, 0, 0)[0]).toBeCloseTo(135, -1);
});

describe.each(['photograph', 'generated'])('over the %s', (name) => {
  test.each([1.3, 6])('a blur of radius %d is OpenCV’s Gaussian of that sigma', async (radius) => {
    const blurred = await apply('filters/gaussian-blur.fs', { inputImage: await expected(name) }, { radius });
    await expectSamePixels(`${name}-gaussian-${radius}`, blurred, await expected(`${name}-gaussian-${radius}`), { tolerance: TOLERANCE });
  });

  test('edges are OpenCV’s Sobel gradient of the luma', async () => {
    const edges = await apply('filters/sobel-edges.fs', { inputImage: await expected(name) });
    await expectSamePixels(`${name}-sobel`, edges, await expected(`${name}-sobel`), { tolerance: TOLERANCE });
  });

  test.each([2800, 11000])('%d K is the Bradford adaptation that colour-science computes', async (temperature) => {
    const adapted = await apply('filters/color-temperature.fs', { inputImage: await expected(name) }, { temperature });
    await expectSamePixels(`${name}-temperature-${temperature}`, adapted, await expected(`${name}-temperature-${temperature}`), {
      tolerance: TOLERANCE,
    });
  });

  test.each([0, 0.4, 1])('sepia at %d is the matrix of W3C Filter Effects', async (amount) => {
    const picture = await expected(name);
    // The spec's form: the amount stands inside the matrix.
    const rest = 1 - amount;
    const matrix = [
      [0.393 + 0.607 * rest, 0.769 - 0.769 * rest, 0.189 - 0.189 * rest],
      [0.349 - 0.349 * rest, 0.686 + 0.314 * rest, 0.168 - 0.168 * rest],
      [0.272 - 0.272 * rest, 0.534 - 0.534 * rest, 0.131 + 0.869 * rest],
    ];
    const byFormula = each(picture, (rgb, alpha) => [matrix.map((row) => dot(row, rgb)), alpha]);
    const drawn = await apply('filters/sepia.fs', { inputImage: picture }, { amount });
    await expectSamePixels(`${name}-sepia-${amount}`, drawn, byFormula, { tolerance: 1 });
  });

  test('a hard threshold gives the two colors and nothing between', async () => {
    const picture = await expected(name);
    const drawn = await apply(
      'filters/threshold.fs',
      { inputImage: picture },
      { level: 0.4, darkColor: [0, 0, 1, 1], lightColor: [1, 1, 0, 0.5] },
    );
    const byFormula = each(picture, (rgb, alpha) => (dot(rgb, LUMA_709) >= 0.4 ? [[1, 1, 0], 0.5 * alpha] : [[0, 0, 1], alpha]));
    await expectSamePixels(`${name}-threshold`, drawn, byFormula, { tolerance: 1 });
  });

  test.each([1, 0.3])('over at opacity %d is W3C source-over', async (opacity) => {
    const bottom = await expected('photograph');
    const top = await expected(name);
    const byFormula = paint(top.width, top.height, (x, y) => {
      const source = pixelAt(top, x, y).map((value) => value * opacity);
      const backdrop = pixelAt(bottom, x, y);
      // Composited premultiplied: co = cs + cb (1 - as).
      const [r = 0, g = 0, b = 0, a = 0] = source.map((value, i) => Math.round(value + (backdrop[i] ?? 0) * (1 - (source[3] ?? 0) / 255)));
      return [r, g, b, a];
    });
    await expectSamePixels(`${name}-over-${opacity}`, await apply('operators/over.fs', { top, bottom }, { opacity }), byFormula, {
      tolerance: 1,
    });
  });

  test.each([
    ['brightness', 0, 0],
    ['brightness, inverted', 0, 1],
    ['alpha', 1, 0],
    ['alpha, inverted', 1, 1],
  ])('a mask by %s multiplies', async (_, source, invert) => {
    const inputImage = await expected(name);
    const stencil = await expected('generated');
    const byFormula = paint(inputImage.width, inputImage.height, (x, y) => {
      const m = pixelAt(stencil, x, y).map((value) => value / 255);
      const value = source === 1 ? (m[3] ?? 0) : dot(m, LUMA_709);
      const [r, g, b, a] = pixelAt(inputImage, x, y).map((c) => Math.round(c * (invert === 1 ? 1 - value : value)));
      return [r ?? 0, g ?? 0, b ?? 0, a ?? 0];
    });
    const drawn = await apply('operators/mask.fs', { inputImage, mask: stencil }, { source, invert });
    await expectSamePixels(`${name}-mask-${source}-${invert}`, drawn, byFormula, { tolerance: 1 });
  });

  test.each([
    ['brightness', { source: 0, low: 0.2, high: 0.7 }],
    ['alpha, inverted', { source: 1, invert: 1 }],
    ['red', { source: 2 }],
    ['blue, with a hard edge', { source: 4, low: 0.4, high: 0.1 }],
  ])('a mask of %s is that of the layer, between its levels', async (_, params: Params) => {
    const picture = await expected(name);
    const { source = 0, low = 0, high = 1, invert = 0 } = params as Record<string, number>;
    const byFormula = paint(picture.width, picture.height, (x, y) => {
      const [r, g, b, a] = pixelAt(picture, x, y).map((value) => value / 255) as [number, number, number, number];
      const value = [dot([r, g, b], LUMA_709), a, r, g, b][source] ?? 0;
      const level = high > low ? Math.min(Math.max((value - low) / (high - low), 0), 1) : value >= low - 0.001 ? 1 : 0;
      const shown = Math.round(255 * (invert === 1 ? 1 - level : level));
      return [shown, shown, shown, 255];
    });
    const drawn = await apply('filters/mask-from-layer.fs', { inputImage: picture }, params);
    await expectSamePixels(`${name}-mask-from-layer-${source}`, drawn, byFormula, { tolerance: TOLERANCE });
  });

  test.each([0, 1])('a mask of a color is white within its tolerance, inverted %d', async (invert) => {
    const picture = await expected(name);
    const [keyColor, tolerance, softness, brightness] = [[0.5, 0.4, 0.3, 1], 0.05, 0.2, 0.4];
    // Rec. ITU-R BT.709: Cb = (B - Y) / 1.8556, Cr = (R - Y) / 1.5748.
    const place = ([r = 0, g = 0, b = 0]: readonly number[]): number[] => {
      const luma = dot([r, g, b], LUMA_709);
      return [(b - luma) / 1.8556, (r - luma) / 1.5748, luma * brightness];
    };
    const byFormula = paint(picture.width, picture.height, (x, y) => {
      const [r, g, b, a] = pixelAt(picture, x, y);
      const straight = a === 0 ? [0, 0, 0] : [r / a, g / a, b / a];
      const key = place(keyColor);
      const apart = Math.hypot(...place(straight).map((value, i) => value - (key[i] ?? 0)));
      const level = (a / 255) * (1 - Math.min(Math.max((apart - tolerance) / softness, 0), 1));
      const shown = Math.round(255 * (invert === 1 ? 1 - level : level));
      return [shown, shown, shown, 255];
    });
    const drawn = await apply('filters/mask-from-color.fs', { inputImage: picture }, { keyColor, tolerance, softness, brightness, invert });
    await expectSamePixels(`${name}-mask-from-color-${invert}`, drawn, byFormula, { tolerance: TOLERANCE });
  });

  test.each([
    [0, 0],
    [1, 1],
  ])('a choice by mask mixes two layers, mask by %d, inverted %d', async (source, invert) => {
    const inside = await expected(name);
    const outside = await expected('photograph');
    const stencil = await expected('generated');
    const byFormula = paint(inside.width, inside.height, (x, y) => {
      const m = pixelAt(stencil, x, y).map((value) => value / 255);
      const value = source === 1 ? (m[3] ?? 0) : dot(m, LUMA_709);
      const shown = invert === 1 ? 1 - value : value;
      const around = pixelAt(outside, x, y);
      const [r = 0, g = 0, b = 0, a = 0] = pixelAt(inside, x, y).map((c, i) => Math.round(c * shown + (around[i] ?? 0) * (1 - shown)));
      return [r, g, b, a];
    });
    const drawn = await apply('operators/choose-by-mask.fs', { inside, outside, mask: stencil }, { source, invert });
    await expectSamePixels(`${name}-choose-${source}-${invert}`, drawn, byFormula, { tolerance: 1 });
  });
});

describe('facts', () => {
  const red = (alpha: number): [number, number, number, number] => [alpha, 0, 0, alpha];

  test('half-transparent red stays red when it is blurred, without a dark fringe', async () => {
    const disc = paint(48, 48, (x, y) => ((x - 24) ** 2 + (y - 24) ** 2 < 100 ? red(128) : [0, 0, 0, 0]));
    const blurred = await apply('filters/gaussian-blur.fs', { inputImage: disc }, { radius: 4 });
    let soft = 0;
    for (let x = 0; x < 48; x++) {
      const [r, g, b, a] = pixelAt(blurred, x, 24);
      expect([g, b]).toEqual([0, 0]);
      expect(Math.abs(r - a)).toBeLessThanOrEqual(1);
      if (a > 5 && a < 120) soft++;
    }
    expect(soft).toBeGreaterThan(10);
  });

  test('a blur keeps the sum of what it spreads', async () => {
    const dot = paint(64, 64, (x, y) => (x === 32 && y === 32 ? [255, 255, 255, 255] : [0, 0, 0, 255]));
    const flat = paint(64, 64, () => [90, 120, 150, 255]);
    const blurredFlat = await apply('filters/gaussian-blur.fs', { inputImage: flat }, { radius: 17.3 });
    expect(pixelAt(blurredFlat, 0, 0)).toEqual([90, 120, 150, 255]);
    const blurredDot = await apply('filters/gaussian-blur.fs', { inputImage: dot }, { radius: 1 });
    // 1 / (2 pi sigma^2) of 255, with the kernel cut off at three sigmas.
    expect(Math.abs(pixelAt(blurredDot, 32, 32)[0] - 255 * 0.1592)).toBeLessThanOrEqual(1);
  });

  test.each([
    ['filters/gaussian-blur.fs', { radius: 0 }],
    ['filters/sepia.fs', { amount: 0 }],
    ['filters/color-temperature.fs', { temperature: 6500 }],
  ] as const)('%s changes nothing at its identity', async (file, params) => {
    const picture = await expected('generated');
    await expectSamePixels('identity', await apply(file, { inputImage: picture }, params), picture, { tolerance: 0 });
  });

  test('a lower color temperature is warmer and white keeps its luminance', async () => {
    const gray = paint(8, 8, () => [150, 150, 150, 255]);
    const warm = pixelAt(await apply('filters/color-temperature.fs', { inputImage: gray }, { temperature: 3500 }), 4, 4);
    expect(warm[0]).toBeGreaterThan(170);
    expect(warm[2]).toBeLessThan(120);
    const linear = (v: number) => ((v / 255 + 0.055) / 1.055) ** 2.4;
    const luminance = dot(warm.slice(0, 3).map(linear), LUMA_709);
    expect(Math.abs(luminance / linear(150) - 1)).toBeLessThan(0.03);
  });

  test('edges over the picture leave flat parts alone', async () => {
    const halves = paint(16, 16, (x) => (x < 8 ? [40, 80, 120, 255] : [200, 210, 220, 255]));
    const drawn = await apply('filters/sobel-edges.fs', { inputImage: halves }, { overPicture: 1, strength: 8, lineColor: [1, 0, 0, 1] });
    expect(pixelAt(drawn, 2, 8)).toEqual([40, 80, 120, 255]);
    expect(pixelAt(drawn, 7, 8)).toEqual([255, 0, 0, 255]);
    expect(pixelAt(drawn, 8, 8)).toEqual([255, 0, 0, 255]);
    expect(pixelAt(drawn, 13, 8)).toEqual([200, 210, 220, 255]);
  });

  test('over takes the depth of the top where that is more than half opaque, in meters from either encoding', async () => {
    const shader = made(readIsf(over, 'operators/over.fs'));
    const top = paint(4, 1, (x) => {
      const alpha = [255, 200, 100, 0][x] ?? 0;
      return [alpha, alpha, alpha, alpha];
    });
    // A projection with near 0.1 m and far 50 m, and what it leaves in a depth buffer at 2 m.
    const [near, far] = [0.1, 50];
    const p10 = -(far + near) / (far - near);
    const p14 = (-2 * far * near) / (far - near);
    const windowDepth = (m: number) => 0.5 * ((-p10 * m + p14) / m) + 0.5;
    const job = {
      width: 4,
      height: 1,
      pictures: { top: toPage(top), bottom: toPage(top) },
      depths: {
        top: { width: 4, height: 1, values: [2, 2, 2, 2].map(windowDepth), decode: [p10, p14, 0, 1] as const },
        bottom: { width: 4, height: 1, values: [7, 7, 7, 0] },
      },
    };
    const meters = (opacity: number, withoutDepth: string[] = []) =>
      drawFloats(page, { ...job, passes: [linkIsfDepth(shader, { node: 'test', withoutDepth })], params: { opacity } });
    for (const [opacity, wanted] of [
      [1, [2, 2, 7, 0]],
      [0.6, [2, 7, 7, 0]],
    ] as const) {
      const found = await meters(opacity);
      found.forEach((value, i) => {
        expect(value).toBeCloseTo(wanted[i] ?? Number.NaN, 3);
      });
    }
    expect(await meters(1, ['top'])).toEqual([0, 0, 7, 0]);
  });
});
