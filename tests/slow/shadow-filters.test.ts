import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/slow/shadow-filters.page.ts');
const lamps = useModule('tests/slow/shadow-lamps.page.ts');

interface Edge {
  readonly inside: number;
  readonly outside: number;
  readonly middle: number;
  readonly width: number;
  readonly error: number;
}

describe('the filters of a shadow map', () => {
  test('leave the edge where it is, and make it as wide as they say', async () => {
    const edges = await page.call<Record<string, Edge>>('edges');
    const texelM = 4 / 256;
    for (const [filter, { inside, outside, middle, error }] of Object.entries(edges)) {
      expect([filter, inside, outside, error]).toEqual([filter, expect.closeTo(1, 2), 0, 0]);
      expect([filter, Math.abs(middle) < texelM]).toEqual([filter, true]);
    }
    const width = (filter: string): number => (edges[filter]?.width ?? Number.NaN) / texelM;
    console.log(
      `Edge from 0.1 to 0.9, texels: ${Object.keys(edges)
        .map((filter) => `${filter} ${width(filter).toFixed(2)}`)
        .join(', ')}`,
    );
    expect(width('basic')).toBeLessThan(0.5);
    expect(width('pcf')).toBeCloseTo(0.8, 0);
    expect(width('soft')).toBeGreaterThan(1.7 * width('pcf'));
    expect(width('vsm')).toBeGreaterThan(1.2 * width('soft'));
  });

  test.each<readonly ['sun' | 'lamp', number, number]>([
    ['sun', 0.3, 0],
    ['lamp', 0.25, 2.2],
  ])('hardened at contacts, the penumbra of a %s grows as similar triangles say', async (kind, source, lampHeightM) => {
    const heights = [0.15, 0.3, 0.6, 0.9];
    const found = await page.call<number[]>('penumbras', kind, source, heights, lampHeightM);
    heights.forEach((height, i) => {
      // A disc seen past an edge: from a tenth to nine tenths of its area is 0.687 of its width.
      const penumbraM = kind === 'sun' ? 2 * Math.tan(source / 2) * height : (source * height) / (lampHeightM - height);
      const ratio = (found[i] ?? Number.NaN) / (0.687 * penumbraM);
      console.log(
        `${kind}, plate ${height} m above the floor: ${((found[i] ?? 0) * 1000).toFixed(0)} mm, ${ratio.toFixed(2)} of similar triangles`,
      );
      expect(ratio).toBeGreaterThan(0.8);
      expect(ratio).toBeLessThan(1.2);
    });
  });

  test.each(['basic', 'pcf', 'soft', 'vsm', 'pcss'])('%s throws no shadow of a lit surface on itself', async (filter) => {
    expect(await page.call('acne', filter)).toEqual({ floor: 0, ramp: 0, box: 0, error: 0 });
  });
});

test.each(['soft', 'vsm', 'pcss'])(
  'with the %s filter, a shadow is whole also where something stands close to the lamp',
  async (filter) => {
    const distances = [0.02, 0.05, 0.1, 0.3, 1];
    expect(await lamps.call('closeToLamp', filter, distances)).toEqual(distances.map(() => [255, 255]));
    const heights = [0.02, 0.05, 0.1, 0.5];
    expect(await lamps.call('lowPlates', filter, heights)).toEqual(heights.map(() => 255));
  },
);

describe('shadows on what room depth shows', () => {
  test.each<readonly ['none' | 'floor', boolean]>([
    ['none', false],
    ['none', true],
    ['floor', true],
  ])('fall where geometry says (besides the depth: %s; a block in the room: %s)', async (receivers, block) => {
    const { right, wrong, blockShadow, error } = await page.call<{
      right: number;
      wrong: number;
      blockShadow: number;
      error: number;
    }>('onRoom', receivers, block);
    console.log(`${right} pixels right, ${wrong} wrong, ${blockShadow} of them in shadow on the block`);
    expect(right).toBeGreaterThan(10_000);
    expect(wrong / right).toBeLessThan(0.002);
    expect(blockShadow > 200).toBe(block);
    expect(error).toBe(0);
  });

  test.each(['map', 'volume'])(
    'are cut off where something real stands before the floor; what is not known cuts nothing (%s)',
    async (method) => {
      const { misplaced, left, differs, error } = await page.call<Record<string, number>>('clipped', method);
      expect(misplaced).toBeGreaterThan(500);
      expect(left).toBeLessThan((misplaced ?? 0) * 0.02);
      expect([differs, error]).toEqual([0, 0]);
    },
  );

  test.each([
    [true, 'map'],
    [false, 'map'],
    [true, 'volume'],
  ])('are cut off where an occlusion hides what is behind, also between samples (blended: %s, %s)', async (blended, method) => {
    const { kept, hidden, lost, left, error } = await page.call<Record<string, number>>('clipBorder', blended, method);
    console.log(`${kept} pixels kept, ${hidden} hidden, ${lost} lost, ${left} left`);
    expect(Math.min(kept ?? 0, hidden ?? 0)).toBeGreaterThan(10_000);
    expect([lost, error]).toEqual([0, 0]);
    // Beside the unknown sample the shadow on the room itself is told by the nearest one.
    expect(left).toBeLessThan((hidden ?? 0) * 0.01);
  });

  test('are those of a phantom in its place', async () => {
    const { overlap, shadowed } = await page.call<Record<string, number>>('byDepthAlone');
    expect(shadowed).toBeGreaterThan(1000);
    expect(overlap).toBeGreaterThan(0.95);
  });
});

describe('transparent objects', () => {
  test.each([
    ['sun', 'basic'],
    ['sun', 'soft'],
    ['sun', 'vsm'],
    ['sun', 'pcss'],
    ['spot', 'soft'],
    ['spot', 'pcss'],
    ['bulb', 'soft'],
  ])('dim the light of a %s by their alpha (%s)', async (kind, filter) => {
    const { thin, thick, two, behindSolid, above, beside, cut, error } = await page.call<Record<string, number>>('veils', kind, filter);
    const near = (part: number) => expect.closeTo(255 * part, -0.4);
    expect({ thin, thick, two, behindSolid, above, beside, cut, error }).toEqual({
      thin: near(0.25),
      thick: near(0.75),
      two: near(0.75),
      behindSolid: 255,
      above: 0,
      beside: 0,
      cut: 255,
      error: 0,
    });
  });

  test.each(['sun', 'spot', 'bulb'])(
    'dim the light of a %s also close above the floor, with something else beside the lamp',
    async (kind) => {
      const heights = [0.01, 0.02, 0.05, 0.1, 0.3, 0.5];
      const found = await lamps.call<number[][]>('lowPanes', kind, heights);
      const wanted = expect.closeTo(255 * 0.75, -0.4);
      expect(found).toEqual(heights.map(() => [wanted, wanted]));
    },
  );

  test.each(['sun', 'spot', 'bulb'])('that let light of a %s through stop the rest, as glass', async (kind) => {
    const near = (part: number) => expect.closeTo(255 * part, -0.4);
    expect(await lamps.call('glass', kind)).toEqual({
      clear: 0,
      smoked: near(0.75),
      unblended: near(0.75),
      blended: near(0.25),
      cut: 0,
      solid: 255,
      error: 0,
    });
  });

  test.each(['sun', 'spot', 'bulb'])('dim the light of a %s on virtual things too, also when they turn solid', async (kind) => {
    const { through, thinner, solid, error } = await page.call<Record<string, number>>('veiledThings', kind);
    expect(through).toBeCloseTo(0.5, 1);
    expect(thinner).toBeCloseTo(0.8, 1);
    expect([solid, error]).toEqual([0, 0]);
  });
});

test.each<readonly ['phantoms' | 'things', string, number, number, RegExp | null]>([
  ['phantoms', 'pcss', 4, 0.5, null],
  ['phantoms', 'pcss', 6, 1, null],
  ['phantoms', 'soft', 6, 0.5, null],
  ['phantoms', 'pcss', 5, 0.5, /: transparent objects cast no shadow in the light of 1 of them\.$/],
  ['phantoms', 'vsm', 6, 0.5, /: 2 of them use “Soft” shadow edges, and transparent .* of 2 of them\.$/],
  ['things', 'soft', 3, 0.5, null],
  ['things', 'soft', 4, 1, null],
  ['things', 'soft', 4, 0.5, /: transparent objects cast no shadow in the light of 4 of them\.$/],
])(
  'what the shadows on %s lack, of %s lights as many as %d and casters of alpha %d, is told once',
  async (shown, filter, count, opacity, told) => {
    const found = await lamps.call('manyLights', shown, filter, count, opacity);
    expect(found).toEqual({ told: told ? [expect.stringMatching(told)] : [], error: 0 });
  },
);

test('a contact shadow is dark where things touch and gone a little above, and lights nothing', async () => {
  interface At {
    readonly below: number;
    readonly beside: number;
  }
  const found = await page.call<{ lights: number; standing: At; floating: At; high: At; byVolume: number; lit: number[]; error: number }>(
    'contacts',
  );
  const { lights, standing, floating, high, byVolume, lit, error } = found;
  console.log(
    `Contact shadow below and beside a box that stands, floats 30 cm up, and 1.2 m: ${JSON.stringify([standing, floating, high])}`,
  );
  expect(standing.below).toBeGreaterThan(220);
  expect(standing.beside).toBeGreaterThan(20);
  expect(standing.beside).toBeLessThan(150);
  expect(floating.below).toBeLessThan(80);
  expect(high.below).toBeLessThan(20);
  expect([lights, byVolume, lit.slice(0, 3), error]).toEqual([1, 0, [0, 0, 0], 0]);
});
