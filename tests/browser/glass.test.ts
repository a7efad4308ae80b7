import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';

const chromium = useBrowser();
let page: PageModule;

beforeAll(async () => {
  page = await openModule(chromium.browser, 'tests/browser/glass.page.ts');
});
afterAll(async () => {
  await page.close();
  expect(page.errors).toEqual([]);
});

interface Balls {
  readonly rims: readonly (readonly number[])[];
  readonly beside: readonly (readonly number[])[];
  readonly error: number;
}

function redShare([r = 0, , b = 0]: readonly number[] = []): number {
  return r / (r + b);
}

function display(light: number): number {
  return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055);
}

describe('glass of models', () => {
  test('of index 1 without thickness changes no pixel of what is under the layer', async () => {
    const { largest, error } = await page.call<{ largest: number; error: number }>('clearPane');
    expect(error).toBe(0);
    expect(largest).toBeLessThanOrEqual(1);
  });

  test('blurs an edge the more, the rougher it is', async () => {
    const widths = await page.call<number[]>('edgeWidths', [0, 0.1, 0.2, 0.3, 0.4, 0.5]);
    expect(widths[0]).toBeLessThanOrEqual(1);
    for (let i = 1; i < widths.length; i++) expect(widths[i]).toBeGreaterThan(widths[i - 1] ?? Number.NaN);
  });

  test.each([
    [0.5, 0.5, [0.2, 0.6, 0.9], 1],
    [0.5, 0.25, [0.2, 0.6, 0.9], 1],
    [0.1, 0.4, [0.05, 0.5, 1], 1],
    // Thickness is in the space of the object.
    [0.1, 0.4, [0.05, 0.5, 1], 3],
    [0, 0.4, [0, 0.5, 1], 1],
  ] as const)('%d m thick, attenuated within %d m to %p at scale %d, follows Beer’s law', async (thickness, distance, color, scale) => {
    const seen = await page.call<number[]>('attenuated', thickness, distance, color, scale);
    const byHand = color.map((part) => display(part ** ((thickness * scale) / distance)));
    for (const [i, value] of byHand.entries()) expect(Math.abs((seen[i] ?? 0) - value)).toBeLessThanOrEqual(2);
  });

  test('separates red from blue on the side where blue refracts more, and not without dispersion', async () => {
    const none = await page.call<{ red: number; green: number; blue: number }>('dispersed', 0);
    expect(Math.abs(none.red - none.blue)).toBeLessThan(0.01);
    const much = await page.call<{ red: number; green: number; blue: number }>('dispersed', 10);
    expect(much.green).toBeCloseTo(none.green, 2);
    // The line is left of the middle. Blue bends more towards the axis, so its rays meet the line from farther out.
    expect(much.red).toBeGreaterThan(none.red + 2);
    expect(much.blue).toBeLessThan(none.blue - 2);
  });

  test.each([true, false])('shows other glass and veils behind it, whatever their order in the list (%p)', async (nearFirst) => {
    // The tint is 128, in linear light 0.216: twice 61. A veil of half blue over white is mixed in linear light behind glass: 188.
    expect(await page.call('stacked', nearFirst)).toEqual({
      white: [255, 255, 255, 255],
      far: [128, 255, 128, 255],
      both: [128, 128, 61, 255],
      near: [255, 128, 128, 255],
      veilThroughNear: [188, 93, 128, 255],
      veil: [128, 128, 255, 255],
    });
  });

  test('shows an object refracted instead of what is straight behind, and is open where it shows nothing', async () => {
    const red = [255, 0, 0, 255];
    const blue = [0, 0, 255, 255];
    const whole = await page.call<Balls>('ballBeforeSheet', false);
    expect([whole.beside, whole.error]).toEqual([[red, blue], 0]);
    // A ball shows the other side at its rim.
    expect(redShare(whole.rims[0])).toBeLessThan(0.3);
    expect(redShare(whole.rims[1])).toBeGreaterThan(0.7);
    const half = await page.call<Balls>('ballBeforeSheet', true);
    expect([half.beside, half.error]).toEqual([[red, [0, 0, 0, 0]], 0]);
    // The sheet is straight behind the left rim, which shows nothing; the right rim shows it.
    expect(half.rims[0]?.[3]).toBeLessThan(90);
    expect(half.rims[1]?.[3]).toBeGreaterThan(165);
  });

  test('shows the room where no object is, and is hidden by it, with a soft border as well', async () => {
    expect(await page.call('overRoom')).toEqual({
      room: [200, 0, 0, 255],
      object: [255, 255, 255, 255],
      hidden: [0, 128, 0, 255],
      besideHidden: [0, 0, 200, 255],
      soft: [100, 64, 0, 255],
    });
  });

  test('leaves nothing on the GPU', async () => {
    const { textures, framebuffers, renderbuffers } = await page.call<Record<string, number>>('leftOver');
    expect([textures, framebuffers, renderbuffers]).toEqual([0, 0, 0]);
  });
});

interface Mirrored {
  readonly samples: readonly { readonly cosine: number; readonly seen: readonly number[]; readonly mirror: readonly number[] }[];
  readonly error: number;
}

/** Reflectance in air for unpolarized light, by Fresnel's equations with the angle inside from Snell's law. */
function fresnel(cosine: number, ior: number): number {
  const inside = Math.sqrt(1 - (1 - cosine ** 2) / ior ** 2);
  const across = ((cosine - ior * inside) / (cosine + ior * inside)) ** 2;
  const along = ((inside - ior * cosine) / (inside + ior * cosine)) ** 2;
  return (across + along) / 2;
}

/** glTF, Appendix B: the approximation by Schlick. */
function schlick(cosine: number, ior: number): number {
  const least = ((ior - 1) / (ior + 1)) ** 2;
  return least + (1 - least) * (1 - cosine) ** 5;
}

describe.each(['cube', 'panorama', 'coefficients'] as const)('glass in a room that is known by its %s mirrors that room', (room) => {
  test.each([
    ['technique', 1.6, fresnel],
    ['model', 2.3, schlick],
  ] as const)('%s of index %d, as a mirror does, by the reflectance of glass', async (kind, ior, reflectance) => {
    const { samples, error } = await page.call<Mirrored>('mirrored', room, kind, ior);
    expect(error).toBe(0);
    expect(samples.length).toBeGreaterThan(400);
    const isFar = ({ cosine, seen, mirror }: Mirrored['samples'][number]): boolean =>
      seen.some((value, c) => {
        const wanted = reflectance(cosine, ior) * (mirror[c] ?? 0);
        return !(Math.abs(value - wanted) <= 0.008 + 0.08 * wanted);
      });
    expect(samples.filter(isFar).length / samples.length).toBeLessThan(0.02);
    // It is no even gray.
    for (const c of [0, 1, 2]) {
      const values = samples.map(({ mirror }) => mirror[c] ?? 0);
      expect(Math.max(...values)).toBeGreaterThan(1.3 * Math.min(...values));
    }
  });
});
