import { gzipSync } from 'node:zlib';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { writeSplatFile } from '../../nodes/kit/splats/splat-file.ts';
import { readSplatPly } from '../../nodes/kit/splats/splat-ply.ts';
import { type SplatPoint, sogOf } from '../../tools/examples/splats/write-sog.ts';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import { plyFile, plyOf, splatAt, splatCloud } from '../support/splat-files.ts';
import { colorFrom, rasterize } from '../support/splat-reference.ts';
import type { SplatShot, SplatShotOptions } from './splats.page.ts';

const chromium = useBrowser();
let page: PageModule;
beforeAll(async () => {
  page = await openModule(chromium.browser, 'tests/browser/splats.page.ts');
});
afterAll(() => page.close());

const WIDTH = 160;
const HEIGHT = 120;
/** Focal length of the view in pixels: 50° over 120 pixels. */
const FOCAL_PX = HEIGHT / 2 / Math.tan((25 * Math.PI) / 180);

async function shoot(splats: readonly SplatPoint[] | Uint8Array, options: Partial<SplatShotOptions> = {}): Promise<SplatShot> {
  const bytes = splats instanceof Uint8Array ? splats : plyOf(splats);
  const shot = await page.call<SplatShot & { readonly error?: string }>('draw', { bytes, name: 'a.ply', ...options });
  if (shot.error !== undefined) throw new Error(shot.error);
  return shot;
}

const at = ({ pixels }: SplatShot, x: number, y: number): number[] => [...pixels.subarray(4 * (y * WIDTH + x), 4 * (y * WIDTH + x) + 4)];
const depthAt = ({ depthM }: SplatShot, x: number, y: number): number => depthM[y * WIDTH + x] ?? Number.NaN;
/** The pixel at the middle; its center is half a pixel to the right and above. */
const MIDDLE = [WIDTH / 2, HEIGHT / 2] as const;

function difference(a: ArrayLike<number>, b: ArrayLike<number>): { readonly mean: number; readonly largest: number } {
  let sum = 0;
  let largest = 0;
  for (let i = 0; i < a.length; i++) {
    const apart = Math.abs((a[i] ?? 0) - (b[i] ?? 0));
    sum += apart;
    largest = Math.max(largest, apart);
  }
  return { mean: sum / a.length, largest };
}

describe('what the node draws', () => {
  test.each([0, 3, 8, 15])('is what the published formula gives in double precision, with %i harmonics', async (coefficients) => {
    const splats = splatCloud(250, coefficients);
    const eye = [0.3, 0.2, 0.4] as const;
    const size = { widthPx: 96, heightPx: 72 };
    const shot = await shoot(splats, { eye, target: [0, 0, -2], ...size });
    const { clipFromView, viewFromWorld } = shot;
    const truth = rasterize(splats, { ...size, clipFromView, viewFromWorld, eyeWorld: eye });
    const { mean, largest } = difference(shot.pixels, truth);
    expect(truth.reduce((sum, value) => sum + value, 0) / truth.length).toBeGreaterThan(60);
    expect(mean).toBeLessThan(0.8);
    expect(largest).toBeLessThan(6);
  });

  test('has the axes of the ellipse that the projection gives', async () => {
    const shot = await shoot([splatAt(0, 0, -2, { scale: [0.3, 0.05, 0.2], opacity: 0.8 })]);
    const [x, y] = MIDDLE;
    const alpha = (sigma: number, distancePx: number, otherPx: number, other: number): number =>
      255 * 0.8 * Math.exp(-(distancePx ** 2) / (2 * sigma) - otherPx ** 2 / (2 * other));
    // The variance on the screen, and 0.3 pixels² of the low-pass filter.
    const across = ((0.3 * FOCAL_PX) / 2) ** 2 + 0.3;
    const up = ((0.05 * FOCAL_PX) / 2) ** 2 + 0.3;
    for (const far of [0, 20, 40]) expect(at(shot, x + far, y)[3]).toBeCloseTo(alpha(across, far + 0.5, 0.5, up), -0.3);
    for (const far of [2, 5]) expect(at(shot, x, y + far)[3]).toBeCloseTo(alpha(up, far + 0.5, 0.5, across), -0.3);
    expect(at(shot, x, y + 14)[3]).toBe(0);
  });

  test('turns with the node, and grows with its scale', async () => {
    const splat = [splatAt(0, 0, -2, { scale: [0.3, 0.02, 0.02] })];
    const [x, y] = MIDDLE;
    const level = await shoot(splat);
    expect(at(level, x + 30, y)[3]).toBeGreaterThan(40);
    expect(at(level, x, y + 30)[3]).toBe(0);
    const turned = await shoot(splat, { params: { rotationRad: [0, 0, Math.PI / 2] } });
    expect(at(turned, x + 30, y)[3]).toBe(0);
    expect(at(turned, x, y + 30)[3]).toBeGreaterThan(40);
    // Twice as large and twice as far looks the same.
    const scaled = await shoot(splat, { params: { scale: 2 } });
    expect(difference(scaled.pixels, level.pixels).largest).toBeLessThanOrEqual(1);
    // A file with y down is turned about x.
    const down = await shoot([splatAt(0, -0.5, 2)], { params: { up: '-y' } });
    expect(at(down, x, y + Math.round((0.5 * FOCAL_PX) / 2))[3]).toBeGreaterThan(230);
  });

  test('changes color with the direction that it is seen from, as its harmonics say', async () => {
    const splat = splatAt(0, 0, -2, { color: [0.5, 0.5, 0.5], scale: [0.3, 0.3, 0.3], harmonics: [0, 0, 0, 0, 0, 0, 0.6, 0, -0.6] });
    for (const eye of [
      [-2, 0, -2],
      [2, 0, -2],
    ] as const) {
      const shot = await shoot([splat], { eye, target: [0, 0, -2] });
      const [red = 0, green = 0, blue = 0, alpha = 0] = at(shot, ...MIDDLE);
      const expected = colorFrom(splat, eye);
      [red, green, blue].forEach((value, c) => {
        expect(Math.abs(value / alpha - (expected[c] ?? 0))).toBeLessThan(0.01);
      });
      // From the left it is blue, from the right red, by hand: ∓0.4886 · 0.6.
      expect(red / alpha).toBeCloseTo(0.5 + Math.sign(eye[0]) * 0.293, 1);
    }
  });

  test('is the same in each draw, in any order of the file, and in a part of the framebuffer', async () => {
    const splats = splatCloud(120, 3);
    const first = await shoot(splats);
    expect(Buffer.compare((await shoot(splats)).pixels, first.pixels)).toBe(0);
    expect(Buffer.compare((await shoot([...splats].reverse())).pixels, first.pixels)).toBe(0);
    const viewport = { x: WIDTH, y: 0, widthPx: WIDTH, heightPx: HEIGHT };
    const right = await page.call<SplatShot>('draw', { bytes: plyOf(splats), name: 'a.ply', widthPx: 2 * WIDTH, viewport });
    const half = Uint8Array.from({ length: first.pixels.length }, (_, i) => {
      const row = Math.floor(i / (4 * WIDTH));
      return right.pixels[row * 8 * WIDTH + 4 * WIDTH + (i % (4 * WIDTH))] ?? 0;
    });
    expect(difference(half, first.pixels).largest).toBe(0);
    expect(right.pixels.subarray(0, 4 * WIDTH).every((value) => value === 0)).toBe(true);
  });

  test('antialiased splats that are smaller than a pixel are fainter', async () => {
    const tiny = [splatAt(0, 0, -2, { scale: [1e-3, 1e-3, 1e-3] })];
    const plain = await shoot(tiny);
    const antialiased = await shoot(tiny, { params: { antialiased: true } });
    const variance = ((1e-3 * FOCAL_PX) / 2) ** 2;
    const [x, y] = MIDDLE;
    expect(at(plain, x, y)[3]).toBeGreaterThan(80);
    expect((at(antialiased, x, y)[3] ?? 0) / (at(plain, x, y)[3] ?? 1)).toBeCloseTo(variance / (variance + 0.3), 1);
  });
});

test('a splat that is brighter than white keeps its light behind a dark one', async () => {
  const bright = splatAt(0, 0, -3, { color: [1.8, 1.8, 1.8], scale: [1, 1, 0.01] });
  const dark = splatAt(0, 0, -2, { color: [0, 0, 0], opacity: 0.5, scale: [1, 1, 0.01] });
  // Half of 1.8 · 0.98; bytes in between would leave half of white.
  expect((await shoot([bright, dark])).pixels[4 * ((HEIGHT / 2) * WIDTH + WIDTH / 2)]).toBeCloseTo(255 * 0.5 * 1.8 * 0.98, -1);
});

test('a splat that reaches past the eye has depth wherever it covers half', async () => {
  // A disc nearly along the view: half a standard deviation from its middle, its plane is at the eye.
  const shot = await shoot([splatAt(0, 0, -1, { scale: [1.5, 0.5, 0.01], rotation: [0, Math.sin(0.75), 0, Math.cos(0.75)] })]);
  const covered = [...shot.depthM].filter((_, i) => (shot.pixels[4 * i + 3] ?? 0) > 140);
  expect(covered.length).toBeGreaterThan(500);
  expect(Math.min(...covered)).toBeGreaterThan(0.19);
});

describe('the room', () => {
  const near = splatAt(0, 0, -1, { color: [1, 0, 0], opacity: 0.5, scale: [0.5, 0.5, 0.01] });
  const far = splatAt(0, 0, -3, { color: [0, 1, 0], scale: [1, 1, 0.01] });

  test('hides each splat by its own depth: behind a near one, a far one is hidden by the wall between', async () => {
    // A wall 2 m away in the left half, unknown depth in the right one.
    const shot = await shoot([near, far], { roomM: [2, 0] });
    const [red = 0, green = 0] = at(shot, 60, HEIGHT / 2);
    expect(red).toBeGreaterThan(90);
    expect(green).toBe(0);
    expect(at(shot, 100, HEIGHT / 2)[1]).toBeGreaterThan(90);
    // Behind a wall at 0.5 m nothing is left.
    const hidden = await shoot([near, far], { roomM: [0.5] });
    expect(hidden.pixels.every((value) => value === 0)).toBe(true);
    expect(hidden.depthM.every((meters) => meters === 0)).toBe(true);
  });

  test('cuts a slanted splat where it goes into the wall, and fades it at a soft border', async () => {
    // A flat disc that leans 45°: farther on the right.
    const lean = splatAt(0, 0, -2, { scale: [0.4, 0.4, 1e-3], rotation: [0, Math.sin(-Math.PI / 8), 0, Math.cos(-Math.PI / 8)] });
    const [x, y] = MIDDLE;
    const open = await shoot([lean]);
    const cut = await shoot([lean], { roomM: [2] });
    const sides = [x - 12, x + 12].sort((a, b) => depthAt(open, a, y) - depthAt(open, b, y));
    expect(at(cut, sides[0] ?? 0, y)).toEqual(at(open, sides[0] ?? 0, y));
    expect(at(open, sides[1] ?? 0, y)[3]).toBeGreaterThan(100);
    expect(at(cut, sides[1] ?? 0, y)[3]).toBe(0);
    const soft = await shoot([splatAt(0, 0, -2.1)], { roomM: [2], softnessM: 0.2 });
    const hard = await shoot([splatAt(0, 0, -2.1)]);
    expect((at(soft, x, y)[3] ?? 0) / (at(hard, x, y)[3] ?? 1)).toBeCloseTo(0.5, 1);
  });
});

describe('the depth of the layer', () => {
  const [x, y] = MIDDLE;

  test('is that of the splats that cover half of the pixel, and unknown where they cover less', async () => {
    const shot = await shoot([splatAt(0, 0, -2, { scale: [0.2, 0.2, 0.05] })]);
    expect(depthAt(shot, x, y)).toBeCloseTo(2, 2);
    for (let column = 0; column < WIDTH; column++) {
      const alpha = at(shot, column, y)[3] ?? 0;
      if (alpha > 130) expect(depthAt(shot, column, y)).toBeCloseTo(2, 1);
      if (alpha < 125) expect(depthAt(shot, column, y)).toBe(0);
    }
  });

  test('is never between a near and a far surface', async () => {
    const far = splatAt(0, 0, -4, { scale: [2, 2, 0.01], color: [0, 0, 1] });
    const behind = (opacity: number): Promise<SplatShot> => shoot([splatAt(0, 0, -1, { scale: [0.3, 0.3, 0.01], opacity }), far]);
    expect(depthAt(await behind(0.3), x, y)).toBeCloseTo(4, 1);
    expect(depthAt(await behind(0.7), x, y)).toBeCloseTo(1, 1);
    // Two faint ones in a row cover half together.
    const pair = [-1, -1.02].map((z) => splatAt(0, 0, z, { scale: [0.3, 0.3, 0.01], opacity: 0.4 }));
    expect(depthAt(await shoot([...pair, far]), x, y)).toBeCloseTo(1.01, 1);
  });

  test('follows the plane of a slanted flat splat', async () => {
    const lean = splatAt(0, 0, -2, { scale: [0.5, 0.5, 1e-3], rotation: [0, Math.sin(Math.PI / 8), 0, Math.cos(Math.PI / 8)] });
    const shot = await shoot([lean]);
    for (const away of [-15, 0, 15]) {
      // The plane through (0, 0, -2) with the normal (1, 0, 1) meets the ray (s, 0, -1) at the depth 2 / (1 - s).
      const slope = (away + 0.5) / FOCAL_PX;
      expect(Math.abs(depthAt(shot, x + away, y) - 2 / (1 - slope))).toBeLessThan(0.06);
    }
  });
});

describe('files', () => {
  test('SOG gives the image of the PLY file, and the form of pages exactly', async () => {
    const splats = splatCloud(200, 3);
    const ply = await shoot(splats);
    const packed = Uint8Array.from(gzipSync(writeSplatFile(readSplatPly(plyOf(splats)))));
    const inPage = await shoot(packed, { name: 'a.splats' });
    expect(difference(inPage.pixels, ply.pixels).largest).toBe(0);
    const sog = await shoot(await sogOf(splats), { name: 'a.sog' });
    expect(sog.count).toBe(200);
    expect(difference(sog.pixels, ply.pixels).mean).toBeLessThan(1.2);
  });

  test('splats that are not finite are left out, with a warning', async () => {
    const good = plyOf([splatAt(0, 0, -2), splatAt(0, 0, -2)]);
    const view = new DataView(good.buffer);
    view.setFloat32(good.length - 4 * 17, Number.NaN, true);
    const shot = await shoot(good);
    expect(shot.count).toBe(1);
    expect(shot.findings).toEqual(['"a.ply" has 1 splats whose values are not finite; they are left out, and 1 are shown.']);
  });

  test('a damaged archive, image or page file is refused', async () => {
    const sog = await sogOf(splatCloud(20, 0));
    const errorOf = async (bytes: Uint8Array, name: string): Promise<string> =>
      (await page.call<{ readonly error: string }>('draw', { bytes, name })).error;
    expect(await errorOf(sog.subarray(0, sog.length - 200), 'a.sog')).toBe('its archive is incomplete');
    // The body of the first image.
    const broken = Uint8Array.from(sog);
    const text = new TextDecoder('latin1').decode(sog);
    broken.fill(0, text.indexOf('RIFF'), text.indexOf('RIFF') + 12);
    expect(await errorOf(broken, 'a.sog')).toBe('its means_l.webp is no image that the browser can decode');
    expect(await errorOf(Uint8Array.of(1, 2, 3), 'a.splats')).toBe('it is damaged');
    expect(await errorOf(plyFile(0, ['x', 'y', 'z'], []), 'a.ply')).toContain('points without size and rotation');
  });
});
