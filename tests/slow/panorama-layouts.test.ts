import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { linearFromSrgb, srgbFromLinear } from '../../nodes/kit/color-math.ts';
import { layoutOf, type PanoramaLayout } from '../../nodes/kit/panorama/layouts.ts';
import { createRowReader, type PanoramaPixels } from '../../nodes/kit/panorama/pixels.ts';
import { toEquirectangular } from '../../nodes/kit/panorama/to-equirectangular.ts';
import { decodePanorama } from '../support/decode-panorama.ts';
import { describeWithData } from '../support/shared-data.ts';

type Vector = readonly [number, number, number];

/** Linear radiance, three numbers per pixel. */
interface Sky {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly data: Float32Array;
}

const WIDTH_PX = 256;

/** Averaged to 256 × 128, so that there is no detail that a second image cannot have. */
function reduce(pixels: PanoramaPixels): Sky {
  const heightPx = WIDTH_PX / 2;
  const data = new Float32Array(WIDTH_PX * heightPx * 3);
  const counts = new Float32Array(WIDTH_PX * heightPx);
  const rows = createRowReader(pixels);
  const row = new Float32Array(pixels.widthPx * 3);
  for (let y = 0; y < pixels.heightPx; y++) {
    rows.read(y, row);
    for (let x = 0; x < pixels.widthPx; x++) {
      const to = Math.floor((y * heightPx) / pixels.heightPx) * WIDTH_PX + Math.floor((x * WIDTH_PX) / pixels.widthPx);
      for (let c = 0; c < 3; c++) data[to * 3 + c] = (data[to * 3 + c] ?? 0) + (row[x * 3 + c] ?? 0);
      counts[to] = (counts[to] ?? 0) + 1;
    }
  }
  for (let i = 0; i < data.length; i++) data[i] = (data[i] ?? 0) / (counts[Math.floor(i / 3)] ?? 1);
  return { widthPx: WIDTH_PX, heightPx, data };
}

/** Color of a direction, between four pixels. */
function look({ widthPx, heightPx, data }: Sky, [x, y, z]: Vector, out: Float32Array, at: number): void {
  const u = (Math.atan2(x, -z) / (2 * Math.PI) + 0.5) * widthPx - 0.5;
  const v = (Math.acos(Math.max(-1, Math.min(1, y / Math.hypot(x, y, z)))) / Math.PI) * heightPx - 0.5;
  const [column, row] = [Math.floor(u), Math.floor(v)];
  for (const [i, j] of [
    [0, 0],
    [1, 0],
    [0, 1],
    [1, 1],
  ] as const) {
    const weight = (i ? u - column : 1 - (u - column)) * (j ? v - row : 1 - (v - row));
    const from = (Math.min(Math.max(row + j, 0), heightPx - 1) * widthPx + ((column + i + widthPx) % widthPx)) * 3;
    for (let c = 0; c < 3; c++) out[at + c] = (out[at + c] ?? 0) + weight * (data[from + c] ?? 0);
  }
}

/** Where each point of an image looks, from 0 to 1 from the upper left; null where it shows nothing. */
type Seen = (u: number, v: number) => Vector | null;

function paint(sky: Sky, widthPx: number, heightPx: number, seen: Seen) {
  const data = new Float32Array(widthPx * heightPx * 3);
  for (let i = 0; i < widthPx * heightPx; i++) {
    const direction = seen(((i % widthPx) + 0.5) / widthPx, (Math.floor(i / widthPx) + 0.5) / heightPx);
    if (direction) look(sky, direction, data, i * 3);
  }
  return { widthPx, heightPx, channels: 3 as const, data };
}

/** The law of reflection, for a camera far away in +z. */
const ball: Seen = (u, v) => {
  const [x, y] = [2 * u - 1, 1 - 2 * v];
  const z = Math.sqrt(Math.max(0, 1 - x * x - y * y));
  return x * x + y * y < 1 ? [2 * z * x, 2 * z * y, 2 * z * z - 1] : null;
};

/** A face by the name of what it shows; u and v are in [-1, 1], to the right and up. */
function face(name: string, u: number, v: number): Vector {
  switch (name) {
    case 'front':
      return [u, v, -1];
    case 'back':
      return [-u, v, 1];
    case 'right':
      return [1, v, u];
    case 'left':
      return [-1, v, -u];
    case 'top':
      return [u, 1, v];
    case 'bottom':
      return [u, -1, -v];
    default:
      // The back upside down, below the bottom.
      return [u, -v, 1];
  }
}

const cells =
  (rows: readonly (readonly string[])[]): Seen =>
  (u, v) => {
    const [column, row] = [u * (rows[0]?.length ?? 1), v * rows.length];
    const name = rows[Math.floor(row)]?.[Math.floor(column)] ?? '';
    return name === '' ? null : face(name, (column % 1) * 2 - 1, 1 - (row % 1) * 2);
  };

const ORDER = ['right', 'left', 'top', 'bottom', 'front', 'back'];
const IMAGES: readonly (readonly [PanoramaLayout, number, number, Seen])[] = [
  ['ball', 512, 512, ball],
  [
    'cross',
    512,
    384,
    cells([
      ['', 'top', '', ''],
      ['left', 'front', 'right', 'back'],
      ['', 'bottom', '', ''],
    ]),
  ],
  [
    'cross-upright',
    384,
    512,
    cells([
      ['', 'top', ''],
      ['left', 'front', 'right'],
      ['', 'bottom', ''],
      ['', 'turned back', ''],
    ]),
  ],
  ['strip', 768, 128, cells([ORDER])],
  ['strip-upright', 128, 768, cells(ORDER.map((name) => [name]))],
];

const equirectangular: Seen = (u, v) => {
  const [longitude, latitude] = [(u - 0.5) * 2 * Math.PI, (0.5 - v) * Math.PI];
  return [Math.sin(longitude) * Math.cos(latitude), Math.sin(latitude), -Math.cos(longitude) * Math.cos(latitude)];
};

/** In decibels of display-referred sRGB, without what is less than 12° from straight ahead, which the rim of a ball shows. */
function decibels(sky: Sky, { data, widthPx, heightPx }: PanoramaPixels): number {
  const truth = paint(sky, widthPx, heightPx, equirectangular);
  const byte = (radiance = 0) => 255 * srgbFromLinear(Math.min(1, Math.max(0, radiance)));
  let errors = 0;
  let count = 0;
  for (let i = 0; i < data.length; i++) {
    const [x, y] = [Math.floor(i / 3) % widthPx, Math.floor(i / 3 / widthPx)];
    const z = equirectangular((x + 0.5) / widthPx, (y + 0.5) / heightPx)?.[2] ?? 0;
    if (-z > Math.cos(Math.PI / 15)) continue;
    errors += (byte(data[i]) - byte(truth.data[i])) ** 2;
    count++;
  }
  return 10 * Math.log10((255 * 255 * count) / errors);
}

/** More than the photos of a panorama reach. */
const LEAST_DECIBELS = 32;

describeWithData('real panoramas as a ball and as faces of a cube', 'panoramas', (folder) => {
  const skies = ['interior_ldr.jpg', 'royal_esplanade_1k.hdr', 'blender_studio.exr'];

  test.each(skies)('%s comes back from each', async (file) => {
    const sky = reduce(await decodePanorama(join(folder, file)));
    // Some scenes are far brighter than white.
    const bright = [...sky.data].sort((a, b) => a - b)[Math.floor(sky.data.length * 0.98)] ?? 1;
    for (let i = 0; i < sky.data.length; i++) sky.data[i] = (sky.data[i] ?? 0) / Math.max(bright, linearFromSrgb(0.5));
    for (const [layout, widthPx, heightPx, seen] of IMAGES) {
      expect(layoutOf(widthPx, heightPx)).toBe(layout);
      const found = decibels(sky, toEquirectangular(paint(sky, widthPx, heightPx, seen), layout));
      if (process.env.SCRIM_PICTURES !== undefined) process.stderr.write(`${file} ${layout}: ${found.toFixed(1)} dB\n`);
      expect([layout, found > LEAST_DECIBELS]).toEqual([layout, true]);
    }
  });
});
