import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, test } from '@jest/globals';
import { decode } from 'fast-png';
import { drawImages } from './main.ts';
import { makeTonalArtMaps, TONES, type TonalArtMaps } from './make-maps.ts';
import { eachPixel, toneOf } from './strokes.ts';

let maps: TonalArtMaps;
beforeAll(() => {
  maps = makeTonalArtMaps();
});

describe('tonal art maps', () => {
  test('reach the tone that each is for, at every size, by less than one stroke', () => {
    for (const [tone, wanted] of TONES.entries()) {
      for (const [size, sidePx] of maps.sidesPx.entries()) {
        const reached = toneOf(maps.ink[tone]?.[size] ?? new Float32Array(1));
        expect(reached).toBeGreaterThanOrEqual(wanted);
        // The largest stroke covers 90 % of a side by about two pixels; sizes start with what smaller ones have.
        expect(reached).toBeLessThan(wanted + 0.02 + 2.5 / sidePx);
      }
    }
  });

  test('nest: darker tones have all strokes of lighter ones, larger sizes all strokes of smaller ones', () => {
    for (const tone of TONES.keys()) {
      for (const size of maps.sidesPx.keys()) {
        const here = new Set(maps.strokes[tone]?.[size]);
        expect(here.size).toBeGreaterThan(0);
        const lighter = maps.strokes[tone - 1]?.[size] ?? [];
        const smaller = maps.strokes[tone]?.[size + 1] ?? [];
        expect([...lighter, ...smaller].filter((stroke) => !here.has(stroke))).toEqual([]);
      }
    }
  });

  test('draw a stroke as wide at every size, and across others in dark tones alone', () => {
    const stroke = { x: 0.5, y: 0.5, slant: 0, bend: 0, length: 0.5, across: false };
    const widths = maps.sidesPx.map((sidePx) => {
      const column = new Float32Array(sidePx);
      eachPixel(stroke, sidePx, (index, coverage) => {
        if (index % sidePx === sidePx / 2) column[Math.floor(index / sidePx)] = coverage;
      });
      return column.reduce((sum, value) => sum + value, 0);
    });
    for (const width of widths) expect(width).toBeCloseTo(widths[0] ?? 0, 5);
    const across = TONES.map((_, tone) => maps.strokes[tone]?.[0]?.some((one) => one.across));
    expect(across).toEqual([false, false, false, true, true, true]);
  });
});

/** What techniques sample, as the library carries it. */
describe('the pictures of the library', () => {
  const stored = (name: string) => new Uint8Array(readFileSync(new URL(`../../shader-library/pictures/${name}`, import.meta.url)));

  test('are what the script draws', () => {
    for (const { name, bytes } of drawImages(maps)) {
      const [drawn, kept] = [decode(bytes), decode(stored(name))];
      expect([kept.width, kept.height, kept.channels]).toEqual([511, 256, 3]);
      expect(Buffer.compare(Buffer.from(drawn.data.buffer), Buffer.from(kept.data.buffer))).toBe(0);
    }
  });

  test('nest in every pixel: no tone is brighter anywhere than the tone before it', () => {
    const [light, dark] = ['hatching-light.png', 'hatching-dark.png'].map((name) => decode(stored(name)).data);
    let brighter = 0;
    const last = { value: 0 };
    for (let at = 0; at < (light?.length ?? 0); at += 3) {
      last.value = 255;
      for (const value of [light?.[at], light?.[at + 1], light?.[at + 2], dark?.[at], dark?.[at + 1], dark?.[at + 2]]) {
        if ((value ?? 0) > last.value) brighter++;
        last.value = value ?? 0;
      }
    }
    expect(brighter).toBe(0);
  });
});
