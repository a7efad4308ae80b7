import { beforeAll, describe, expect, test } from '@jest/globals';
import { readIsf } from '../../export/glsl/isf/read-isf.ts';
import { linkIsf } from '../../export/glsl/link/link-isf.ts';
import { useModule } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import { expectSamePixels } from '../support/pixels.ts';
import { describeWithData } from '../support/shared-data.ts';
import { drawPicture, made, PAGE, paint, toPage } from './glsl-kit.ts';
import { applyShader, expectedImage, type Params, photograph, SHADERS, samplesOf } from './shader-library-kit.ts';

/** Half a step of rounding on either side and one for single precision and for the linear filtering of textures. */
const TOLERANCE = 2;

/** What `expected/filters.py` computes with the same values, by filter and case. */
const CASES: Readonly<Record<string, Readonly<Record<string, Params>>>> = {
  grey: { full: {}, part: { amount: 0.4 } },
  'luminance-variation': { contrast: {}, dark: { brightness: -0.2, contrast: 0.8, gamma: 1.7 } },
  'chrominance-variation': { turned: {}, shifted: { saturation: 0.6, rotation: -1, blueYellow: 0.1, redCyan: -0.2 } },
  vignette: { ellipse: {}, circle: { amount: 0.9, start: 0.2, softness: 0.3, roundness: 1, tint: [1, 0.9, 0.6, 1] } },
  posterize: { 4: {}, 7: { levels: 7 } },
  curves: {
    contrast: { all: [0, 0, 0.25, 0.1, 0.75, 0.9, 1, 1] },
    graded: {
      all: [0.1, 0, 1, 0.9],
      red: [0, 0, 0.3, 0.6, 1, 1],
      green: [0, 0.1, 0.5, 0.4, 1, 1],
      blue: [0, 0.3, 0.5, 0.5, 1, 0.8],
      luma: [0, 0, 0.5, 0.65, 1, 1],
      amount: 0.8,
    },
  },
  'chroma-key': { green: {}, red: { keyColor: [0.8, 0.2, 0.1, 1], tolerance: 0.1, softness: 0.2, spill: 1 } },
  'skin-mask': { soft: {}, cut: { softness: 20, widen: 3, show: 1 } },
  'hdr-exposure': { long: {}, kept: { stops: 2.5, highlights: 1 }, short: { stops: -2 } },
  'film-grain': { gray: {}, color: { amount: 0.15, size: 3, color: 0.7, midtones: 1 } },
  halftone: { ink: {}, color: { size: 13.5, angle: 0.3, pictureColors: 1 } },
  pixelate: { 8: { size: 8 }, 13: { size: 13 } },
  swirl: { left: { angle: 1.5, radius: 60 }, right: { angle: -2, radius: 200 } },
  tile: { plain: { columns: 4, rows: 2 }, mirrored: { columns: 2, rows: 8, mirror: 1 } },
  'radial-blur': { middle: {}, corner: { amount: 0.3, center: [0.2, 0.9] } },
  'spin-blur': { middle: {}, corner: { angle: 0.5, center: [0.2, 0.9] } },
  'white-balance': { warm: {}, between: { warm: 2500, cold: 12000, balance: 0.7 } },
  'anisotropic-kuwahara': { 6: {}, round: { radius: 4, sharpness: 2, stretch: 0 } },
  kuwahara: { 5: {}, soft: { radius: 3, sharpness: 2 } },
  bilateral: { 6: {}, wide: { radius: 10, colorRange: 0.6 } },
  'difference-of-gaussians': { ink: {}, over: { radius: 2.4, strength: 40, level: 0.5, hardness: 10, overPicture: 1 } },
  bloom: { wide: {}, near: { level: 0.1, radius: 3, strength: 2 } },
};

const EACH = Object.entries(CASES).flatMap(([filter, cases]) =>
  Object.entries(cases).map(([name, params]) => [filter, name, params] as const),
);

/** Pixels of the generated image that may differ by more: at corners of flat squares a stroke has no one direction. */
const STRAYS: Readonly<Record<string, number>> = { 'anisotropic-kuwahara-6': 32 };

/** Seconds over a photograph where the processor draws: `tests/slow/filters-photographs.test.ts` does it. */
const SLOW = new Set(['anisotropic-kuwahara']);

const page = useModule(PAGE);

function apply(filter: string, inputImage: RgbaImage, params?: Params): Promise<RgbaImage> {
  return applyShader(page, `filters/${filter}.fs`, { inputImage }, params);
}

describe('over the generated picture', () => {
  test.each(EACH)('%s (%s) is what other software computes', async (filter, name, params) => {
    const drawn = await apply(filter, await expectedImage('generated'), params);
    const file = `generated-${filter}-${name}`;
    const pixels = STRAYS[`${filter}-${name}`] ?? 0;
    await expectSamePixels(file, drawn, await expectedImage(file), { tolerance: TOLERANCE, pixels });
  });
});

describeWithData('over a photograph', 'images/astronaut.png', (path) => {
  let picture: RgbaImage;
  beforeAll(async () => {
    picture = await photograph(path);
  });

  test.each(EACH.filter(([filter]) => !SLOW.has(filter)))('%s (%s) is what other software computes', async (filter, name, params) => {
    const drawn = await apply(filter, picture, params);
    const file = `astronaut-${filter}-${name}`;
    await expectSamePixels(file, samplesOf(drawn), await expectedImage(file), { tolerance: TOLERANCE });
  });
});

/** Controls that change something by default, at the value that changes nothing. */
const IDENTITIES: Readonly<Record<string, Params>> = {
  grey: { amount: 0 },
  'luminance-variation': { contrast: 1 },
  'chrominance-variation': { rotation: 0 },
  vignette: { amount: 0 },
  posterize: { amount: 0 },
  curves: {},
  'hdr-exposure': { stops: 0 },
  'film-grain': { amount: 0 },
  pixelate: { size: 1 },
  swirl: { angle: 0 },
  tile: { columns: 1, rows: 1 },
  'radial-blur': { amount: 0 },
  'spin-blur': { angle: 0 },
  'clean-mask': { holesPx: 0, specksPx: 0 },
  kuwahara: { radius: 0 },
  bilateral: { radius: 0 },
  bloom: { strength: 0 },
};

test.each(Object.entries(IDENTITIES))('%s changes nothing at its identity', async (filter, params) => {
  const picture = await expectedImage('generated');
  await expectSamePixels(`identity-${filter}`, await apply(filter, picture, params), picture, { tolerance: 1 });
});

/** Needs more than one pixel: 64 × 64 pixels, each with a distance. */
async function applyWithDepth(
  filter: string,
  inputImage: RgbaImage,
  meters: (x: number, y: number) => number,
  params: Params,
  of: 'inputImage' | 'room' = 'inputImage',
): Promise<RgbaImage> {
  const file = `filters/${filter}.fs`;
  const shader = made(readIsf(SHADERS[file] ?? '', file));
  const { width, height } = inputImage;
  // Bottom row first.
  const values = Array.from({ length: width * height }, (_, i) => meters(i % width, height - 1 - Math.floor(i / width)));
  return drawPicture(page, {
    width,
    height,
    passes: made(linkIsf(shader, { node: 'test', ...(of === 'room' ? { withoutDepth: ['inputImage'] } : { absent: ['room'] }) })),
    pictures: { inputImage: toPage(inputImage) },
    depths: { [of]: { width, height, values } },
    params: { ...Object.fromEntries(shader.inputs.map((input) => [input.name, input.default])), ...params },
  });
}

describe('fog', () => {
  const ramp = (x: number) => x / 4;
  const blue = paint(64, 4, () => [0, 40, 200, 255]);
  const HIDDEN = -Math.log(0.05);
  const GROWTH = [
    (x: number) => 1 - Math.exp(-HIDDEN * x),
    (x: number) => 1 - Math.exp(-HIDDEN * x * x),
    (x: number) => Math.min(x, 1),
  ] as const;

  test.each([
    ['exponential', 0],
    ['exponential squared', 1],
    ['even', 2],
  ] as const)('grows %s with meters, of the layer and of the room alike', async (_, falloff) => {
    const [near, far] = [2, 10];
    const fogged = (m: number) => GROWTH[falloff](Math.max(m - near, 0) / (far - near)) * 0.8;
    const expected = paint(64, 4, (x) => {
      const fog = x === 0 ? 0.5 * 0.8 : fogged(ramp(x));
      return [255 * fog, 40 + (255 - 40) * fog, 200 + (127.5 - 200) * fog, 255];
    });
    const params = { near, far, falloff, empty: 0.5, color: [1, 1, 0.5, 0.8] };
    for (const of of ['inputImage', 'room'] as const) {
      const drawn = await applyWithDepth('fog', blue, ramp, params, of);
      await expectSamePixels(`fog-${falloff}-${of}`, drawn, expected, { tolerance: TOLERANCE });
    }
  });

  test('hides 95 % at the distance that is asked for', async () => {
    const drawn = await applyWithDepth('fog', blue, () => 10, { near: 2, far: 10, color: [1, 1, 1, 1] });
    expect(pixelAt(drawn, 0, 0)[0]).toBe(Math.round(0.95 * 255));
  });
});

describe('depth of field', () => {
  const LENS = { focus: 1.5, fStop: 1.8, focalLength: 0.1, sensor: 0.01, most: 16 };
  /** A lens of 100 mm at f/1.8 that looks at 1.5 m shows a point at 3 m this wide on 64 pixels of a sensor 10 mm high. */
  const RADIUS_PX = (((0.1 / 1.8) * 0.1 * (3 - 1.5)) / (3 * (1.5 - 0.1)) / 0.01 / 2) * 64;
  const edge = paint(64, 64, (x) => (x < 32 ? [255, 255, 255, 255] : [0, 0, 0, 255]));

  test('changes nothing at the focus', async () => {
    const checks = paint(64, 64, (x, y) => ((x + y) % 2 === 0 ? [255, 120, 0, 255] : [0, 0, 90, 255]));
    await expectSamePixels('dof-focus', await applyWithDepth('depth-of-field', checks, () => 1.5, LENS), checks, { tolerance: 0 });
  });

  test('turns an edge behind it into the profile of a disc as wide as the thin lens says', async () => {
    expect(RADIUS_PX).toBeCloseTo(6.35, 2);
    const drawn = await applyWithDepth('depth-of-field', edge, () => 3, LENS);
    for (let x = 20; x < 44; x++) {
      // How much of a disc about the pixel's center lies left of the edge.
      const t = Math.max(-1, Math.min(1, (32 - (x + 0.5)) / RADIUS_PX));
      const left = 0.5 + (t * Math.sqrt(1 - t * t) + Math.asin(t)) / Math.PI;
      expect(Math.abs((pixelAt(drawn, x, 32)[0] ?? 0) - 255 * left)).toBeLessThan(10);
    }
  });

  test('keeps what is sharp in front free of what is blurred behind, and not the other way round', async () => {
    const behind = await applyWithDepth('depth-of-field', edge, (x) => (x < 32 ? 1.5 : 3), LENS);
    expect(pixelAt(behind, 30, 32)[0]).toBe(255);
    const before = await applyWithDepth('depth-of-field', edge, (x) => (x < 32 ? 0.8 : 1.5), LENS);
    expect(pixelAt(before, 35, 32)[0]).toBeGreaterThan(30);
  });
});

describe('clean mask', () => {
  /** A square of 24 pixels with a hole, a gap to its neighbor, and specks beside it. */
  const mask = (x: number, y: number) => {
    const square = x >= 16 && x < 40 && y >= 16 && y < 40;
    const hole = x >= 24 && x < 28 && y >= 24 && y < 28;
    const largeHole = x >= 31 && x < 38 && y >= 31 && y < 38;
    const speck = (x === 5 && y === 5) || (x >= 50 && x < 53 && y >= 8 && y < 11);
    return (square && !hole && !largeHole) || speck ? 255 : 0;
  };
  const picture = paint(64, 64, (x, y) => [mask(x, y), mask(x, y), mask(x, y), 255]);
  const whiteIn = ({ data }: RgbaImage) => Array.from({ length: 64 * 64 }, (_, i) => data[4 * i] === 255);

  test('fills holes and removes specks up to their size, and keeps larger ones and the outline', async () => {
    const cleaned = whiteIn(await apply('clean-mask', picture, { holesPx: 2, specksPx: 2 }));
    const expected = Array.from({ length: 64 * 64 }, (_, i) => {
      const [x, y] = [i % 64, Math.floor(i / 64)];
      const largeHole = x >= 31 && x < 38 && y >= 31 && y < 38;
      // Of the large hole's frame, 2 pixels wide, an opening by 2 leaves nothing.
      const frame = x >= 31 && y >= 31;
      return x >= 16 && x < 40 && y >= 16 && y < 40 && !largeHole && !frame;
    });
    expect(cleaned).toEqual(expected);
  });

  test('grows and shrinks by whole pixels', async () => {
    const square = paint(64, 64, (x, y) => (x >= 20 && x < 40 && y >= 20 && y < 40 ? [255, 255, 255, 255] : [0, 0, 0, 255]));
    for (const growPx of [5, -5]) {
      const grown = whiteIn(await apply('clean-mask', square, { holesPx: 0, specksPx: 0, growPx }));
      expect(grown.filter(Boolean).length).toBe((20 + 2 * growPx) ** 2);
      expect(grown[30 * 64 + 20 - growPx]).toBe(true);
      expect(grown[30 * 64 + 19 - growPx]).toBe(false);
    }
  });
});

test('white balance swings from one light to the other and back', async () => {
  const gray = paint(2, 2, () => [128, 128, 128, 255]);
  const swing = { warm: 3000, cold: 10_000, swing: 0.1 };
  const at = async (params: Params, frames: number) => {
    const file = 'filters/white-balance.fs';
    const shader = made(readIsf(SHADERS[file] ?? '', file));
    const defaults = Object.fromEntries(shader.inputs.map((input) => [input.name, input.default]));
    const job = { width: 2, height: 2, passes: made(linkIsf(shader, { node: 'test' })), pictures: { inputImage: toPage(gray) }, frames };
    return [...pixelAt(await drawPicture(page, { ...job, params: { ...defaults, ...params } }), 0, 0)];
  };
  const [warm, cold] = [await at({ ...swing, swing: 0, balance: 0 }, 1), await at({ ...swing, swing: 0, balance: 1 }, 1)];
  expect(warm[0]).toBeGreaterThan((warm[2] ?? 0) + 60);
  expect(cold[2]).toBeGreaterThan((cold[0] ?? 0) + 20);
  // The seventh frame of 1/60 s is one whole swing of a tenth of a second, the fourth half of one.
  expect(await at(swing, 7)).toEqual(warm);
  expect(await at(swing, 4)).toEqual(cold);
  expect(await at({ ...swing, balance: 1 }, 4)).toEqual(warm);
});
