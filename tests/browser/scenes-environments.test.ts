import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/browser/scenes-environments.page.ts');

/** IEC 61966-2-1, to eight bits. */
function encode(linear: number): number {
  const x = Math.min(1, linear);
  return Math.round(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
}

const near = (value: number, tolerance = 1): unknown => expect.closeTo(value, -Math.log10(2 * (tolerance + 0.5)));

describe('light from a panorama', () => {
  test('of one radiance makes a white matt ball as bright as itself, all over', async () => {
    const { error, ...reds } = await page.call<Record<string, [number, number]> & { error: number }>('furnace');
    const within = (value: number): unknown => [near(value), near(value)];
    expect(reds).toEqual({ hdr: within(encode(0.5)), exr: within(encode(0.5)), png: within(100), twice: within(encode(0.75)) });
    expect(error).toBe(0);
  });

  test('with one bright side lights what faces it, and turns with its rotation', async () => {
    const { error, ...reds } = await page.call<Record<string, number>>('brightSide');
    // A hemisphere of 0.8 gives what faces it 0.8, and what lies across half of that. Pixels of 11 degrees blur its edge, so a
    // hundredth reaches what is turned away.
    const { left, turnedFront, ...others } = reds;
    expect([left, turnedFront].every((red) => red !== undefined && red <= encode(0.01))).toBe(true);
    expect(others).toEqual({
      right: near(encode(0.8), 2),
      up: near(encode(0.4), 2),
      front: near(encode(0.4), 2),
      turnedBack: near(encode(0.8), 2),
      turnedRight: near(encode(0.4), 2),
    });
    expect(error).toBe(0);
  });

  test.each([
    [0, ['red', 'green', 'blue', 'white']],
    [Math.PI / 2, ['green', 'blue', 'white', 'red']],
  ])('is seen and mirrored where it stands, turned by %d', async (rotation, [ahead, right, behind, left]) => {
    const { backdrop, mirror, before, error } = await page.call<{
      backdrop: Record<string, number[]>;
      mirror: Record<string, number[]>;
      before: number[];
      error: number;
    }>('directions', rotation);
    const names = (seen: Record<string, number[]>) =>
      Object.fromEntries(Object.entries(seen).map(([name, color]) => [name, nameOf(color)]));
    const expected = { ahead, right, behind, left, up: 'dark', down: 'gray' };
    expect(names(backdrop)).toEqual(expected);
    expect(names(mirror)).toEqual(expected);
    // A matt ball is no picture of what is behind it.
    expect([nameOf(before), before[3], error]).toEqual([undefined, 255, 0]);
  });

  test('is the same from an HDR and an EXR file', async () => {
    const { differences, bright, error } = await page.call<{ differences: { pixels: number }[]; bright: number; error: number }>(
      'bothFormats',
    );
    expect(differences.map(({ pixels }) => pixels)).toEqual([0, 0, 0]);
    expect([bright, error]).toEqual([255, 0]);
  });

  test('is not spoilt by a pixel that is no number', async () => {
    expect(await page.call('infinities')).toEqual(near(encode(0.5), 2));
  });

  test('leaves nothing behind on the GPU', async () => {
    const { before, after } = await page.call<{ before: unknown; after: unknown }>('leaks');
    expect(after).toEqual(before);
  });
});

test('a file that is no panorama is refused with what to do', async () => {
  expect(await page.call('refusals')).toEqual({
    cutHdr: 'the file is incomplete. Copy or export it again',
    cutExr: expect.stringMatching(/^the file is damaged .*Export it again$/),
    hugeHdr: 'it has 100000 × 50000 pixels, and at most 8192 a side can be shown. 4096 × 2048 is sharp enough for a sky',
    turned: 'its rows are not stored from the top left. Open it in another program and save it again',
    tiny: 'it has only 1 × 1 pixels. Export it again with at least 64 × 32',
    noise: 'it is no picture. Use a Radiance HDR (.hdr), OpenEXR (.exr), JPEG, PNG, WebP or AVIF file',
    empty: 'it is no picture. Use a Radiance HDR (.hdr), OpenEXR (.exr), JPEG, PNG, WebP or AVIF file',
  });
});

const COLORS: Readonly<Record<string, readonly number[]>> = {
  red: [255, 0, 0],
  green: [0, 255, 0],
  blue: [0, 0, 255],
  white: [255, 255, 255],
  dark: [encode(0.1), encode(0.1), encode(0.1)],
  gray: [encode(0.6), encode(0.6), encode(0.6)],
};

/** Which of the panorama's colors it is, within 16 of 255: three adds to mirrors what their microfacets scatter twice. */
function nameOf(color: readonly number[]): string | undefined {
  return Object.keys(COLORS).find((name) => COLORS[name]?.every((value, i) => Math.abs(value - (color[i] ?? 0)) <= 16));
}
