import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import type { Estimated, Sample } from './techniques.page.ts';

const page = useModule('tests/browser/techniques.page.ts');

const NO_ERROR = 0;

/** IEC 61966-2-1. */
function linear(c: number): number {
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
}
function encoded(c: number): number {
  const v = Math.min(Math.max(c, 0), 1);
  return 255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055);
}

const WHITE_LIGHT: Estimated = { lamp: [1, 1, 1], around: [1, 1, 1] };

const luminance = ([r = 0, g = 0, b = 0]: readonly number[]): number => 0.2126 * r + 0.7152 * g + 0.0722 * b;

/** A color in light of another color, at the same luminance. */
function inLight(color: readonly number[], light: readonly number[]): number[] {
  const lit = color.map((value, i) => value * (light[i] ?? 0));
  return lit.map((value) => (value * luminance(color)) / luminance(lit));
}

/** Gooch et al. 1998, equations 1 and 2, in linear light, and Phong's highlight over it. */
function goochByHand({ facing, mirrored }: Sample, highlight: number, sharpness: number, light = WHITE_LIGHT): number[] {
  const own = [0x80, 0x80, 0xc0].map((value) => linear(value / 255));
  const tone = (color: readonly number[], share: number) => color.map((value, i) => linear(value) + share * (own[i] ?? 0));
  const kCool = inLight(tone([0.1, 0.2, 0.75], 0.25), light.around);
  const kWarm = inLight(tone([0.85, 0.7, 0.15], 0.5), light.lamp);
  const shiny = inLight([1, 1, 1], light.lamp);
  const shine = facing > 0 ? highlight * mirrored ** sharpness : 0;
  const mixed = kCool.map((cool, i) => {
    const mean = ((1 + facing) / 2) * (kWarm[i] ?? 0) + (1 - (1 + facing) / 2) * cool;
    return encoded(mean * (1 - shine) + (shiny[i] ?? 0) * shine);
  });
  return [...mixed, 255];
}

function expectColors(samples: readonly Sample[], byHand: (sample: Sample) => number[]): void {
  for (const sample of samples) {
    const wanted = byHand(sample);
    const worst = Math.max(...sample.color.map((value, i) => Math.abs(value - (wanted[i] ?? Number.NaN))));
    // The sphere is made of triangles, so its normals are a little off where they turn quickly.
    if (!(worst <= 3)) throw new Error(`At ${sample.facing} it shows ${sample.color.join()} instead of ${wanted.map(Math.round).join()}.`);
  }
}

describe('technique/gooch', () => {
  test.each([
    ['the sun', null],
    ['a lamp', [1.5, 1, 2]],
  ])('on a sphere under %s is the formula of the paper, with and without highlight', async (_, lamp) => {
    for (const [highlight, sharpness] of [
      [0, 40],
      [0.7, 40],
    ] as const) {
      const { samples, error } = await page.call<{ samples: Sample[]; error: number }>('goochSphere', { highlight, sharpness }, lamp);
      expect(error).toBe(NO_ERROR);
      expect(samples.length).toBeGreaterThan(300);
      expectColors(samples, (sample) => goochByHand(sample, highlight, sharpness));
    }
  });

  test.each([0, 0.5, 1])('takes the colors of an estimated light by %d, as bright as in white light', async (lightColor) => {
    const light: Estimated = { lamp: [3, 2.7, 2], around: [0.4, 0.6, 1.1] };
    const values = { highlight: 0.3, sharpness: 40, lightColor };
    const { samples, error } = await page.call<{ samples: Sample[]; error: number }>('goochSphere', values, null, light);
    expect(error).toBe(NO_ERROR);
    const parts = (color: readonly number[]) => color.map((value) => linear(value / 255));
    expectColors(samples, (sample) => {
      const white = parts(goochByHand(sample, 0.3, 40));
      const colored = parts(goochByHand(sample, 0.3, 40, light));
      return [...white.map((value, i) => encoded(value + ((colored[i] ?? 0) - value) * lightColor)), 255];
    });
  });

  test('gets warmer and less blue the more a surface faces the light', async () => {
    const { samples } = await page.call<{ samples: Sample[] }>('goochSphere', { highlight: 0 }, null);
    const sorted = [...samples].sort((a, b) => a.facing - b.facing);
    let warmest = 0;
    let bluest = 255;
    for (const { color } of sorted) {
      const [red = 0, , blue = 0] = color;
      expect(red).toBeGreaterThanOrEqual(warmest - 2);
      expect(blue).toBeLessThanOrEqual(bluest + 2);
      warmest = Math.max(warmest, red);
      bluest = Math.min(bluest, blue);
    }
    expect((sorted.at(-1)?.color[0] ?? 0) - (sorted[0]?.color[0] ?? 0)).toBeGreaterThan(40);
  });
});

interface InEnvironment {
  readonly matt: { readonly pixels: number; readonly largest: number };
  readonly ambient: { readonly pixels: number; readonly largest: number };
  readonly metal: { readonly pixels: number; readonly largest: number };
  /** The largest byte of a ball of bricks, and of one that is white and matte. */
  readonly covered: number;
  readonly brick: number;
  readonly matt255: number;
  readonly error: number;
}

describe('the environment lights techniques as it does three.js’ own materials', () => {
  test.each([
    ['panorama', 0],
    ['panorama', -7],
    ['estimate', -1],
    ['neutral', -1],
  ])('a %s at %d stops, by normal and by reflection', async (kind, stops) => {
    const { matt, ambient, metal, covered, brick, matt255, error } = await page.call<InEnvironment>('environment', kind, stops);
    expect(error).toBe(NO_ERROR);
    expect(matt.largest).toBeLessThanOrEqual(1);
    expect(ambient.largest).toBeLessThanOrEqual(1);
    // A metal mirrors all; at its border three.js blurs where normals turn quickly.
    expect(metal.pixels / covered).toBeLessThan(0.05);
    expect(brick).toBeLessThanOrEqual(matt255);
    expect(brick).toBeGreaterThan(matt255 / 4);
    if (stops < -5) expect(matt255).toBeLessThan(32);
  });
});

interface ToonSphere {
  readonly colors: readonly (readonly [color: string, count: number])[];
  readonly outside: { readonly outline: number; readonly other: number };
  /** Pixels of outline along a line through the middle, on the left and on the right. */
  readonly widths: readonly number[];
  readonly error: number;
}

describe('technique/toon', () => {
  test.each([1, 2, 3, 5])('%d levels are that many colors on a sphere', async (levels) => {
    const { colors, outside, error } = await page.call<ToonSphere>('toonSphere', levels, 0);
    expect(error).toBe(NO_ERROR);
    const steps = Array.from({ length: levels }, (_, i) => Math.round(encoded(levels === 1 ? 1 : 0.25 + (0.75 * i) / (levels - 1))));
    // Between two steps one pixel holds some of both.
    const disc = colors.reduce((sum, [, count]) => sum + count, 0);
    const large = colors.filter(([, count]) => count > 0.01 * disc);
    const reds = large.map(([color]) => Number(color.split(',')[0])).sort((a, b) => a - b);
    expect(reds).toEqual(steps);
    expect(large.reduce((sum, [, count]) => sum + count, 0) / disc).toBeGreaterThan(0.85);
    expect(outside).toEqual({ outline: 0, other: 0 });
  });

  test.each([1, 3, 8])('an outline of %d pixels is as wide all around the sphere, and not on it', async (widthPx) => {
    const { colors, outside, widths, error } = await page.call<ToonSphere>('toonSphere', 3, widthPx);
    expect(error).toBe(NO_ERROR);
    expect(outside.other).toBe(0);
    for (const width of widths) expect(Math.abs(width - widthPx)).toBeLessThanOrEqual(1);
    const disc = colors.reduce((sum, [, count]) => sum + count, 0);
    const ring = Math.PI * ((Math.sqrt(disc / Math.PI) + widthPx) ** 2 - disc / Math.PI);
    expect(Math.abs(outside.outline / ring - 1)).toBeLessThan(widthPx < 2 ? 0.3 : 0.1);
    const onIt = colors.find(([color]) => color === '255,0,0,255')?.[1] ?? 0;
    expect(onIt / disc).toBeLessThan(0.02);
  });
});

describe('an outline surrounds an open surface', () => {
  const styles = ['gooch', 'toon'] as const;
  const shapes = ['sheet', 'gutter'] as const;
  const cases = styles.flatMap((style) =>
    shapes.flatMap((shape) => [0.4, 2, Math.PI + 0.4].map((turnRad) => [style, shape, turnRad] as const)),
  );

  test.each(cases)('by %s: a %s, turned by %d rad', async (style, shape, turnRad) => {
    const found = await page.call<Record<'border' | 'outlined' | 'onIt' | 'error', number>>('openOutline', style, shape, turnRad);
    expect(found.error).toBe(NO_ERROR);
    expect(found.border).toBeGreaterThan(60);
    expect(found.outlined / found.border).toBeGreaterThan(0.97);
    // A sheet has no edge within.
    if (shape === 'sheet') expect(found.onIt).toBe(0);
  });
});

test.each(['gooch', 'toon'])(
  'the outline of a room by %s leaves its inside visible from outside, through walls that show only their inner side',
  async (style) => {
    const { room, covered, error } = await page.call<Record<'room' | 'covered' | 'error', number>>('roomOutline', style);
    expect(error).toBe(NO_ERROR);
    expect(room).toBeGreaterThan(1500);
    // Lines at the border and at silhouettes.
    expect(covered / room).toBeLessThan(0.2);
  },
);

describe('a technique is drawn', () => {
  test.each(['skinned', 'morphing', 'instanced'])('on %s objects where their own materials are', async (kind) => {
    interface Moving {
      readonly covered: number;
      readonly moved: number;
      readonly wrong: number;
      readonly error: number;
    }
    const { covered, moved, wrong, error } = await page.call<Moving>('moving', kind);
    expect(error).toBe(NO_ERROR);
    expect(covered).toBeGreaterThan(500);
    expect(moved).toBeGreaterThan(100);
    expect(wrong).toBe(0);
  });

  test('with normals that bones turn', async () => {
    const { bent, straight, error } = await page.call<{ bent: number[]; straight: number[]; error: number }>('bentNormals');
    expect(error).toBe(NO_ERROR);
    expect(bent).toEqual(straight);
    expect(bent[3]).toBe(255);
  });

  test('with shadows on it, where it receives them', async () => {
    const tone = (facing: number) => [encoded(0.5 + facing / 2), encoded(0.5 + facing / 2), encoded(0.5 - facing / 2), 255].map(Math.round);
    const lit = tone(Math.SQRT1_2);
    const { shadow, lit: beside, error } = await page.call<{ shadow: number[]; lit: number[]; error: number }>('shadowed', true);
    expect(error).toBe(NO_ERROR);
    expect(shadow).toEqual(tone(0));
    expect(beside).toEqual(lit);
    expect(await page.call('shadowed', false)).toEqual({ shadow: lit, lit, error: NO_ERROR });
  });

  test('cut by the room while it is drawn, hard and soft, as other objects are', async () => {
    interface Halves {
      readonly styled: readonly number[][];
      readonly own: readonly number[];
      readonly error: number;
    }
    const hard = await page.call<Halves>('occluded', 0);
    expect(hard.error).toBe(NO_ERROR);
    expect(hard.own).toEqual([0, 255]);
    expect(hard.styled.map((color) => color[3])).toEqual([0, 255]);
    const soft = await page.call<Halves>('occluded', 0.2);
    expect(soft.styled.map((color) => color[3])).toEqual(soft.own);
    const [faded = [], whole = []] = soft.styled;
    expect(faded[3]).toBeGreaterThan(100);
    expect(faded[3]).toBeLessThan(155);
    // Premultiplied: color fades with alpha.
    expect(Math.abs((faded[0] ?? 0) - ((whole[0] ?? 0) * (faded[3] ?? 0)) / 255)).toBeLessThanOrEqual(1);
  });

  test('to its end, though one of its loops has none', async () => {
    expect(await page.call('endless')).toEqual({ center: [255, 0, 0, 255], error: NO_ERROR });
  });

  test('for the materials that are named, and with the opacity of the object', async () => {
    expect(await page.call('parts')).toEqual({
      front: [255, 0, 0, 255],
      side: [0, 255, 0, 255],
      veil: [153, 0, 0, 153],
      error: NO_ERROR,
    });
  });
});
