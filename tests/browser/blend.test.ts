import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { readIsf } from '../../export/glsl/isf/read-isf.ts';
import { linkIsf } from '../../export/glsl/link/link-isf.ts';
import blend from '../../shader-library/operators/blend.fs';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import { fromGl, pixelAt, type RgbaImage } from '../support/image.ts';
import { expectSamePixels } from '../support/pixels.ts';
import { drawPicture, made, PAGE, paint, toPage } from './glsl-kit.ts';

type Rgb = readonly [number, number, number];

/** W3C Compositing and Blending Level 1, section 10, written from the text: one channel of `B(Cb, Cs)`, colors straight. */
const SEPARABLE: Readonly<Record<string, (cb: number, cs: number) => number>> = {
  normal: (_, cs) => cs,
  multiply: (cb, cs) => cb * cs,
  screen: (cb, cs) => 1 - (1 - cb) * (1 - cs),
  overlay: (cb, cs) => hardLight(cs, cb),
  darken: (cb, cs) => Math.min(cb, cs),
  lighten: (cb, cs) => Math.max(cb, cs),
  'color-dodge': (cb, cs) => (cb === 0 ? 0 : cs === 1 ? 1 : Math.min(1, cb / (1 - cs))),
  'color-burn': (cb, cs) => (cb === 1 ? 1 : cs === 0 ? 0 : 1 - Math.min(1, (1 - cb) / cs)),
  'hard-light': (cb, cs) => hardLight(cb, cs),
  'soft-light': softLight,
  difference: (cb, cs) => Math.abs(cb - cs),
  exclusion: (cb, cs) => cb + cs - 2 * cb * cs,
};

const NON_SEPARABLE: Readonly<Record<string, (cb: Rgb, cs: Rgb) => Rgb>> = {
  hue: (cb, cs) => setLum(setSat(cs, sat(cb)), lum(cb)),
  saturation: (cb, cs) => setLum(setSat(cb, sat(cs)), lum(cb)),
  color: (cb, cs) => setLum(cs, lum(cb)),
  luminosity: (cb, cs) => setLum(cb, lum(cs)),
};

/** In the order of the menu; the canvas calls two of them by older names. */
const MODES = [...Object.keys(SEPARABLE), ...Object.keys(NON_SEPARABLE), 'plus-lighter'];
const CANVAS_NAMES: Readonly<Record<string, string>> = { normal: 'source-over', 'plus-lighter': 'lighter' };

function hardLight(cb: number, cs: number): number {
  return cs <= 0.5 ? cb * 2 * cs : 1 - (1 - cb) * (1 - (2 * cs - 1));
}

function softLight(cb: number, cs: number): number {
  const d = cb <= 0.25 ? ((16 * cb - 12) * cb + 4) * cb : Math.sqrt(cb);
  return cs <= 0.5 ? cb - (1 - 2 * cs) * cb * (1 - cb) : cb + (2 * cs - 1) * (d - cb);
}

function lum([r, g, b]: Rgb): number {
  return 0.3 * r + 0.59 * g + 0.11 * b;
}

function sat(c: Rgb): number {
  return Math.max(...c) - Math.min(...c);
}

function clipColor(c: Rgb): Rgb {
  const l = lum(c);
  const n = Math.min(...c);
  const x = Math.max(...c);
  const low = n < 0 ? map(c, (v) => l + ((v - l) * l) / (l - n)) : c;
  return x > 1 ? map(low, (v) => l + ((v - l) * (1 - l)) / (x - l)) : low;
}

function setLum(c: Rgb, l: number): Rgb {
  return clipColor(map(c, (v) => v + (l - lum(c))));
}

/** As the specification has it, by the order of the channels. */
function setSat(c: Rgb, s: number): Rgb {
  const order = [0, 1, 2].sort((a, b) => (c[a] ?? 0) - (c[b] ?? 0));
  const [min = 0, mid = 0, max = 0] = order.map((i) => c[i] ?? 0);
  const result = [0, 0, 0];
  if (max > min) {
    result[order[1] ?? 0] = ((mid - min) * s) / (max - min);
    result[order[2] ?? 0] = s;
  }
  return [result[0] ?? 0, result[1] ?? 0, result[2] ?? 0];
}

function map([r, g, b]: Rgb, change: (value: number) => number): Rgb {
  return [change(r), change(g), change(b)];
}

/** Section 5 and 10: `Cs' = (1 - ab) Cs + ab B(Cb, Cs)`, then source over; for plus-lighter section 9.1.13. */
function composite(mode: string, top: RgbaImage, bottom: RgbaImage, opacity: number): RgbaImage {
  return paint(top.width, top.height, (x, y) => {
    const source = straight(top, x, y);
    const backdrop = straight(bottom, x, y);
    const as = source.alpha * opacity;
    const ab = backdrop.alpha;
    const plus = mode === 'plus-lighter';
    const mixed = plus ? source.rgb : mix(mode, backdrop.rgb, source.rgb);
    const channel = (i: number): number => {
      const cs = source.rgb[i] ?? 0;
      const cb = backdrop.rgb[i] ?? 0;
      if (plus) return Math.min(1, as * cs + ab * cb);
      const shown = (1 - ab) * cs + ab * (mixed[i] ?? 0);
      return as * shown + ab * cb * (1 - as);
    };
    const alpha = plus ? Math.min(1, as + ab) : as + ab * (1 - as);
    const to8Bits = (value: number): number => Math.round(255 * Math.min(Math.max(value, 0), 1));
    return [to8Bits(channel(0)), to8Bits(channel(1)), to8Bits(channel(2)), to8Bits(alpha)];
  });
}

function mix(mode: string, cb: Rgb, cs: Rgb): Rgb {
  const whole = NON_SEPARABLE[mode];
  if (whole) return whole(cb, cs);
  const part = SEPARABLE[mode];
  if (!part) throw new Error(`There is no formula for ${mode}.`);
  return [part(cb[0], cs[0]), part(cb[1], cs[1]), part(cb[2], cs[2])];
}

function straight(picture: RgbaImage, x: number, y: number): { rgb: Rgb; alpha: number } {
  const [r, g, b, a] = pixelAt(picture, x, y);
  return { rgb: a === 0 ? [0, 0, 0] : [r / a, g / a, b / a], alpha: a / 255 };
}

const SIZE = 64;

/** Every corner of the color cube over every other, and colors from all over it, at the alphas given. */
function swatches(seed: number, alphas: readonly number[]): RgbaImage {
  let state = seed;
  const next = (): number => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state >>> 24;
  };
  return paint(SIZE, SIZE, (x, y) => {
    const corner = seed === 1 ? x : y;
    const isCorner = x < 8 && y < 8;
    const rgb = [0, 1, 2].map((bit) => (isCorner ? ((corner >> bit) & 1) * 255 : next()));
    const alpha = isCorner ? 255 : (alphas[(x + 3 * y) % alphas.length] ?? 255);
    const [r = 0, g = 0, b = 0] = rgb.map((value) => Math.round((value * alpha) / 255));
    return [r, g, b, alpha];
  });
}

const OPAQUE = { top: swatches(1, [255]), bottom: swatches(2, [255]) };
/** Colors of low alpha are known to few bits only, and what is made of them differs by as much. */
const CLEAR = { top: swatches(1, [255, 0, 200, 128, 160]), bottom: swatches(2, [128, 255, 230, 0]) };

const chromium = useBrowser();
let page: PageModule;
let canvas: PageModule;
beforeAll(async () => {
  page = await openModule(chromium.browser, PAGE);
  canvas = await openModule(chromium.browser, 'tests/browser/canvas-blend.page.ts');
});
afterAll(async () => {
  for (const { errors, close } of [page, canvas]) {
    expect(errors).toEqual([]);
    await close();
  }
});

const shader = made(readIsf(blend, 'operators/blend.fs'));
const passes = made(linkIsf(shader, { node: 'test' }));

function drawn(mode: number, { top, bottom }: typeof OPAQUE, opacity: number): Promise<RgbaImage> {
  return drawPicture(page, {
    width: SIZE,
    height: SIZE,
    passes,
    pictures: { top: toPage(top), bottom: toPage(bottom) },
    params: { mode, opacity },
  });
}

async function inCanvas(name: string, { top, bottom }: typeof OPAQUE, opacity: number): Promise<RgbaImage> {
  const rgba = await canvas.call<string>('compositeInCanvas', toPage(top), toPage(bottom), CANVAS_NAMES[name] ?? name, opacity);
  return fromGl(SIZE, SIZE, Buffer.from(rgba, 'base64'));
}

test('the menu has every mode of the specification, in this order', () => {
  const menu = shader.inputs.find(({ name }) => name === 'mode')?.choices ?? [];
  expect(menu.map(({ value }) => value)).toEqual(MODES.map((_, i) => i));
  expect(menu.map(({ label }) => label.toLowerCase().replace(' ', '-'))).toEqual(MODES);
});

describe.each(MODES.map((name, mode) => ({ name, mode })))('$name', ({ name, mode }) => {
  test.each([
    ['opaque layers', OPAQUE, 1],
    ['layers that show through', CLEAR, 1],
    ['a top at 0.4', CLEAR, 0.4],
  ] as const)('on %s is the formula of the specification', async (what, layers, opacity) => {
    await expectSamePixels(`${name}-${what}`, await drawn(mode, layers, opacity), composite(name, layers.top, layers.bottom, opacity), {
      tolerance: 1,
    });
  });

  test('is what the browser’s own canvas draws', async () => {
    await expectSamePixels(`${name}-canvas`, await drawn(mode, OPAQUE, 1), await inCanvas(name, OPAQUE, 1), { tolerance: 2 });
    await expectSamePixels(`${name}-canvas-clear`, await drawn(mode, CLEAR, 1), await inCanvas(name, CLEAR, 1), { tolerance: 2 });
  });
});
