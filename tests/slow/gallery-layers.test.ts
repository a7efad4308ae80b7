import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { BLEND_FIELD, BLEND_MODES, TRAIL } from '../../tools/examples/gallery-layers.ts';
import { PEGS } from '../../tools/examples/gallery-lights.ts';
import { cellMiddleM, MIDDLE_M } from '../../tools/examples/gallery-place.ts';
import type { Piece } from '../browser/gallery.page.ts';
import { compileGallery, GALLERY_MOUNTS, loadGallery } from '../browser/gallery-kit.ts';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';

const chromium = useBrowser();
let page: PageModule;

/** Of a cell of its own, of the film and of the blended field, meters. */
const CELL_M = [0.13, 0.13];
const FILM_M = [0.26, 0.13];
const BLEND_M = [0.52, 0.13];
const METERS_PER_PX = 1.26 / 600;
/** A ball, but no rail and no background. */
const BRIGHT = 100;

/** Bytes at a place from the middle of a piece, meters. */
function bytesAt({ widthPx, heightPx, rgb }: Piece, rightM: number, upM: number): number[] {
  const x = Math.round(widthPx / 2 + rightM / METERS_PER_PX);
  const y = Math.round(heightPx / 2 + upM / METERS_PER_PX);
  return rgb.slice((y * widthPx + x) * 3, (y * widthPx + x) * 3 + 3);
}

/** Linear light there. */
function linearAt(piece: Piece, rightM: number, upM: number): number[] {
  return bytesAt(piece, rightM, upM).map((byte) => (byte / 255 <= 0.04045 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4));
}

function colorsOf({ rgb }: Piece): (readonly [number, number, number])[] {
  return Array.from({ length: rgb.length / 3 }, (_, i) => [rgb[3 * i] ?? 0, rgb[3 * i + 1] ?? 0, rgb[3 * i + 2] ?? 0] as const);
}

/** How far to the right of its middle the brightest pixel of a piece is, meters. */
function brightestAt(piece: Piece): number {
  const sums = colorsOf(piece).map(([r, g, b]) => r + g + b);
  return ((sums.indexOf(Math.max(...sums)) % piece.widthPx) + 0.5 - piece.widthPx / 2) * METERS_PER_PX;
}

describe('the gallery shows', () => {
  /** Pieces of these cells, by frame and cell. */
  const seen = new Map<number, Readonly<Record<string, Piece>>>();
  const KEYS = ['g5', 'g6', 'h1', 'h2', 'h3', 'h4', 'h5', 'h6'];

  const piece = (frame: number, key: string): Piece => {
    const found = seen.get(frame)?.[key];
    if (!found) throw new Error(`Cell ${key} was not looked at in frame ${frame}.`);
    return found;
  };

  beforeAll(async () => {
    page = await openModule(chromium.browser, 'tests/browser/gallery.page.ts', { width: 408, height: 600, mounts: GALLERY_MOUNTS });
    await page.call('begin', compileGallery(loadGallery()), 'gallery/');
    for (const [frame, drawn] of [
      [165, 1],
      [188, 1],
      [212, 10],
      [285, 1],
    ] as const) {
      await page.call('playTo', frame, { drawn });
      const middles = KEYS.map((key) => cellMiddleM(key.charCodeAt(0) - 97, Number(key[1]) - 1));
      const pieces = await page.call<Piece[]>('piecesAt', middles, CELL_M);
      const [film, blend] = [cellMiddleM(8, 0, 2), cellMiddleM(8, 2, 4)];
      const [wide] = await page.call<Piece[]>('piecesAt', [film], FILM_M);
      const [field] = await page.call<Piece[]>('piecesAt', [blend], BLEND_M);
      const all = [...KEYS.map((key, i) => [key, pieces[i]] as const), ['film', wide] as const, ['blend', field] as const];
      seen.set(frame, Object.fromEntries(all) as Record<string, Piece>);
    }
    expect(await page.call('problems')).toEqual([]);
  });

  afterAll(async () => {
    await page.close();
    expect(page.errors).toEqual([]);
  });

  test('a bulb that swells, and pegs that throw their shadows away from it', () => {
    // Its least light is in frame 165, its most, three times as much, in frame 212.
    const [least, most] = [165, 212].map((frame) => linearAt(piece(frame, 'h1'), 0.02, 0.02));
    expect((most?.[0] ?? 0) / (least?.[0] ?? 0)).toBeGreaterThan(2.3);
    expect((most?.[0] ?? 0) / (least?.[0] ?? 0)).toBeLessThan(3.1);
    expect(most?.[0]).toBeGreaterThan((most?.[2] ?? 0) * 1.8);
    for (const [right, up] of PEGS) {
      const shadow = linearAt(piece(212, 'h1'), right * 1.6, up * 1.6);
      expect(shadow[0]).toBeLessThan((most?.[0] ?? 0) / 3);
    }
  });

  test('a spot with a dark around it, and the shadow of a ball in it', () => {
    const [lit, shadow, around] = [
      [0.02, 0.015],
      [0.002, -0.028],
      [-0.052, -0.052],
    ].map(([right = 0, up = 0]) => linearAt(piece(188, 'h2'), right, up));
    expect(lit?.[2]).toBeGreaterThan((lit?.[0] ?? 0) * 1.3);
    expect(shadow?.[2]).toBeLessThan((lit?.[2] ?? 0) / 3);
    expect(around?.[2]).toBeLessThan((lit?.[2] ?? 0) / 3);
  });

  test('an evening whose warm side moves around a ball of chalk, and in a mirror', () => {
    const warmth = (frame: number, right: number) => {
      const [r = 0, , b = 1] = linearAt(piece(frame, 'h3'), right, 0);
      return r / b;
    };
    // The sun stands at the right of the eye in frame 165, and at the left, half a turn later, in frame 285.
    expect(warmth(165, 0.03)).toBeGreaterThan(warmth(165, -0.03) * 1.15);
    expect(warmth(285, -0.03)).toBeGreaterThan(warmth(285, 0.03) * 1.15);
    const [right, left] = [165, 285].map((frame) => brightestAt(piece(frame, 'h4')));
    expect(right).toBeGreaterThan(0.01);
    expect(left).toBeLessThan(-0.01);
    const [sky, ground] = [0.022, -0.022].map((up) => linearAt(piece(188, 'h4'), 0, up));
    expect(sky?.[2]).toBeGreaterThan((ground?.[2] ?? 0) * 3);
  });

  test('a ring in Gooch’s warm and cool tones, and one in the flat ones of a cartoon, with an outline', () => {
    const gooch = colorsOf(piece(188, 'g5'));
    expect(gooch.filter(([r, , b]) => r > b + 40).length).toBeGreaterThan(20);
    expect(gooch.filter(([r, , b]) => b > r + 8).length).toBeGreaterThan(10);
    const toon = colorsOf(piece(188, 'g6'));
    const red = toon.filter(([r, , b]) => r > 60 && r > 1.5 * b);
    const tones = new Map<string, number>();
    for (const color of red) tones.set(String(color), (tones.get(String(color)) ?? 0) + 1);
    const most = [...tones.values()].sort((a, b) => b - a).slice(0, 3);
    // The ring is small: of its pixels, many lie on the border of two tones.
    expect(most.reduce((sum, count) => sum + count, 0)).toBeGreaterThan(red.length * 0.6);
    expect(toon.filter((color) => Math.max(...color) < 30).length).toBeGreaterThan(20);
  });

  test('three balls of which the red one alone keeps its color, and is hidden by the others', () => {
    const inFront = colorsOf(piece(188, 'h5'));
    const behind = colorsOf(piece(285, 'h5'));
    const redOf = (colors: typeof inFront) => colors.filter(([r, g, b]) => r > 60 && r > 1.8 * Math.max(g, b)).length;
    for (const colors of [inFront, behind]) {
      expect(colors.filter(([r, g, b]) => Math.max(g, b) > r + 12)).toEqual([]);
      expect(colors.filter(([r, g, b]) => Math.min(r, g, b) > 60 && Math.max(r, g, b) - Math.min(r, g, b) <= 2).length).toBeGreaterThan(
        100,
      );
    }
    expect(redOf(inFront)).toBeGreaterThan(100);
    expect(redOf(behind)).toBeGreaterThan(20);
    expect(redOf(behind)).toBeLessThan(redOf(inFront) * 0.8);
  });

  test('a ball with a trail that loses an eighth with each frame', () => {
    const { radiusM, ballM, turnRadPerS, keep } = TRAIL;
    const turn = turnRadPerS / 30;
    const edge = ballM / 2 / radiusM;
    const at = (angle: number) => {
      const where = (212 * turn + angle) % (2 * Math.PI);
      return bytesAt(piece(212, 'h6'), radiusM * Math.cos(where), radiusM * Math.sin(where));
    };
    const [ball, board] = [at(0), at(2 * edge)];
    expect(board.map((value) => value < BRIGHT)).toEqual([true, true, true]);
    for (const frames of [2, 6]) {
      const expected = ball.map((value, i) => (board[i] ?? 0) + (value - (board[i] ?? 0)) * keep ** frames);
      const differences = at(-edge - frames * turn).map((value, i) => Math.abs(value - (expected[i] ?? 0)));
      // A pixel is most of a frame's way.
      expect(Math.max(...differences)).toBeLessThan(30);
    }
  });

  test('a film, at its moment, behind a window', () => {
    // 7.07 s into a film of two seconds with twelve pictures a second: the thirteenth.
    const turn = 12 / 24;
    const [, middleY] = cellMiddleM(8, 0, 2);
    const [middleX] = cellMiddleM(8, 0, 2);
    for (const [right, up] of [
      [0, 0],
      [-0.1, 0.04],
      [-0.05, -0.03],
      [0.05, 0.03],
      [0.1, -0.04],
    ] as const) {
      // The film covers the view: 90 rows are as high as it.
      const rowM = 1.26 / 90;
      const [x, y] = [80 + (middleX + right) / rowM, 45 - (middleY + up - MIDDLE_M[1]) / rowM];
      const hue = 2 * Math.PI * ((x + 90 - y) / 60 - turn);
      const [luma, u, v] = [1.164 * (125 + 25 * Math.cos(2 * hue) - 16), 60 * Math.cos(hue), -60 * Math.sin(hue)];
      const expected = [luma + 1.596 * v, luma - 0.392 * u - 0.813 * v, luma + 2.017 * u];
      const differences = bytesAt(piece(212, 'film'), right, up).map((value, i) => Math.abs(value - (expected[i] ?? 0)));
      expect([right, up, Math.max(...differences) < 25]).toEqual([right, up, true]);
    }
  });

  /** W3C Compositing and Blending Level 1, section 10: one channel of opaque colors. */
  const FORMULAS: Readonly<Record<string, (cb: number, cs: number) => number>> = {
    Multiply: (cb, cs) => cb * cs,
    Screen: (cb, cs) => cb + cs - cb * cs,
    Lighten: (cb, cs) => Math.max(cb, cs),
    Difference: (cb, cs) => Math.abs(cb - cs),
    'Plus lighter': (cb, cs) => Math.min(1, cb + cs),
  };
  const expectBlended = (field: Piece, mode: string) => {
    const { stripM, barM } = BLEND_FIELD;
    const blend = FORMULAS[mode] ?? (() => Number.NaN);
    for (let strip = 0; strip < 6; strip++) {
      for (let bar = 0; bar < 3; bar++) {
        const [right, up] = [(strip - 2.5) * stripM, (1 - bar) * barM];
        const below = bytesAt(field, right, up + (bar === 0 ? -barM / 2 : barM / 2));
        const above = bytesAt(field, right + (strip === 0 ? stripM / 2 : -stripM / 2), up);
        const expected = below.map((cb, i) => 255 * blend(cb / 255, (above[i] ?? 0) / 255));
        const differences = bytesAt(field, right, up).map((value, i) => Math.abs(value - (expected[i] ?? 0)));
        expect([mode, strip, bar, Math.max(...differences) <= 2]).toEqual([mode, strip, bar, true]);
      }
    }
  };

  test('bars blended with strips by one mode after the other, or by that which is chosen', async () => {
    // A second each, from the first: in 5.5 s it is the sixth.
    expect(BLEND_MODES[5]).toBe('Lighten');
    expectBlended(piece(165, 'blend'), 'Lighten');
    let frame = 285;
    for (const mode of ['Multiply', 'Screen', 'Difference', 'Plus lighter'] as const) {
      const value = 1 + BLEND_MODES.indexOf(mode);
      await page.call('playTo', ++frame, { params: [['blend-all/choice-mode', 'value', value]] });
      const [field] = await page.call<Piece[]>('piecesAt', [cellMiddleM(8, 2, 4)], BLEND_M);
      if (field) expectBlended(field, mode);
    }
  });

  test('and nothing that is left on the GPU at its end', async () => {
    expect(await page.call('problems')).toEqual([]);
    expect(await page.call('end')).toMatchObject({ textures: 0, framebuffers: 0 });
  });
});
