import { readdirSync } from 'node:fs';
import { beforeAll, describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import type { Seen } from './technique-library.page.ts';

/** Facts of the techniques that ship, from pictures; formulas of Gooch and toon are held in `tests/browser/techniques.test.ts`. */
const page = useModule('tests/slow/technique-library.page.ts');
beforeAll(() => page.call('prepare'));

const NAMES = readdirSync('shader-library/techniques').map((file) => file.replace('.glsl', ''));

describe.each(NAMES)('technique/%s', (name) => {
  test.each(['sun', 'point', 'spot'])('shows shadows of a %s that fall on it, where it receives them', async (light) => {
    const { received, refused } = await page.call<{ received: number; refused: number }>('shadowOn', name, light);
    expect(received / refused).toBeLessThan(0.8);
    // Grain and strokes are nowhere the same; near a lamp it is brighter.
    if (light === 'sun') expect(Math.abs(refused - 1)).toBeLessThan(0.15);
    else expect(refused).toBeGreaterThan(0.85);
  });

  test.each(['point', 'spot'])('is bright under the light of a %s, and darker where that does not reach', async (light) => {
    const { middle, aside } = await page.call<{ middle: number; aside: number }>('underLamp', name, light);
    // Gooch's tones go by direction, and reach from cool to warm alone.
    expect(aside / middle).toBeLessThan(0.9);
  });

  test('is hidden by the wall that it is behind', async () => {
    const [behind = 1, before = 0] = await page.call<number[]>('hidden', name);
    expect(behind).toBe(0);
    expect(before).toBeGreaterThan(200);
  });

  test.each(['skinned', 'morphing', 'instanced'])('is wherever a %s object is', async (kind) => {
    const { missing, moved } = await page.call<{ missing: number; moved: number }>('moving', name, kind);
    expect(missing).toBe(0);
    expect(moved).toBeGreaterThan(100);
  });
});

const BLACK_ON_WHITE = { linePx: 0, ownTone: 0, inkColor: [0, 0, 0, 1], paperColor: [1, 1, 1, 1] };
const FACINGS = [1, 0.9, 0.75, 0.6, 0.45, 0.3, 0.15, 0.02];

describe('drawn tones', () => {
  test.each([
    ['hatching', { ...BLACK_ON_WHITE, brightness: 0 }],
    ['charcoal', { linePx: 0, ownTone: 0, charcoalColor: [0, 0, 0, 1], paperColor: [1, 1, 1, 1] }],
  ])('of %s get darker the less light falls on a surface', async (name, values) => {
    const tones = await page.call<number[]>('tones', name, values, FACINGS);
    // Bright enough, it is the paper.
    for (const [i, tone] of tones.slice(1).entries()) expect(tone).toBeLessThan(tone > 0.98 ? 1.01 : (tones[i] ?? 0) - 0.005);
    expect(tones[0]).toBeGreaterThan(0.75);
    expect(tones.at(-1)).toBeLessThan(0.4);
  });

  test.each(['Curvature', 'Level'])(
    'of hatching by %s are those of other surfaces where the normal is a diagonal of the box',
    async (mapping) => {
      const values = { ...BLACK_ON_WHITE, brightness: 0, mapping: mapping === 'Level' ? 0 : 2 };
      const diagonals = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z) => [x, y, z])));
      const [usual = 0, ...tones] = await page.call<number[]>('tonesOfNormals', 'hatching', values, [[0.5, 1.2, 1.4], ...diagonals]);
      for (const tone of tones) expect(Math.abs(tone - usual)).toBeLessThan(0.1);
    },
  );
});

test('bricks of the sides and the top of a ball meet in a joint', async () => {
  expect(await page.call<number>('mortarBelowTop')).toBeGreaterThan(0.95);
});

describe('glass', () => {
  test.each([
    [1.5, 5],
    [1.33, 6],
    [1.1, 8],
  ])('of index %d shows the pixel behind a ball that a ray meets', async (ior, behindM) => {
    const rows = await page.call<Seen[]>('throughBall', ior, behindM);
    expect(rows.length).toBeGreaterThan(60);
    for (const { at, seen, traced } of rows) {
      const worst = Math.max(...seen.map((value, i) => Math.abs(Math.round(value) - Math.round(traced[i] ?? Number.NaN))));
      if (!(worst <= 1)) throw new Error(`At ${at.join()} it shows ${seen.join()} instead of ${traced.join()}.`);
    }
  });

  test.each([1.33, 1.5, 2.4])('of index %d passes what Fresnel’s equations leave', async (ior) => {
    const plates = await page.call<{ facing: number; passed: number; byHand: number }[]>('passedByTurnedPlates', ior);
    for (const { facing, passed, byHand } of plates) {
      expect(Math.abs(passed - byHand)).toBeLessThan(0.005);
      // Schlick's approximation is good for glass, and known to be some hundredths off aslant.
      const f0 = ((ior - 1) / (ior + 1)) ** 2;
      expect(Math.abs(1 - passed - (f0 + (1 - f0) * (1 - facing) ** 5))).toBeLessThan(0.05);
    }
  });
});

test.each([[[0.3, 0.2]], [[0.5, 0.14]]])(
  'bricks of %p m follow each other at that, in half bond, and move with the object',
  async (brickM) => {
    interface Joints {
      readonly upright: number[];
      readonly level: number[];
      readonly shift: number;
      readonly differing: number;
    }
    const { upright, level, shift, differing } = await page.call<Joints>('joints', brickM);
    const [lengthM = 0, heightM = 0] = brickM;
    expect(upright.length).toBeGreaterThan(1);
    expect(level.length).toBeGreaterThan(4);
    // A pixel is some 11 mm.
    for (const apart of upright) expect(Math.abs(apart - lengthM)).toBeLessThan(0.015);
    for (const apart of level) expect(Math.abs(apart - heightM)).toBeLessThan(0.015);
    expect(Math.abs((Math.abs(shift) % lengthM) - lengthM / 2)).toBeLessThan(0.02);
    expect(differing).toBeLessThan(30);
  },
);

test('loose lines are several, and are redrawn in time steps', async () => {
  const { runs, same } = await page.call<{ runs: number[]; same: boolean[] }>('looseSphere', [1.01, 1.2, 1.01, 1.3, 9]);
  expect(same).toEqual([true, true, true, false, false]);
  const several = runs.filter((count) => count >= 2).length;
  expect(several / runs.length).toBeGreaterThan(0.4);
});
