import sharp from 'sharp';
import { SOG_META } from '../../../nodes/kit/splats/sog-meta.ts';
import { writeZip } from '../../../nodes/kit/splats/zip-files.ts';

/** A Gaussian splat, for tests and examples. */
export interface SplatPoint {
  readonly position: readonly [number, number, number];
  /** Standard deviations. */
  readonly scale: readonly [number, number, number];
  /** x, y, z, w. */
  readonly rotation: readonly [number, number, number, number];
  readonly color: readonly [number, number, number];
  readonly opacity: number;
  /** Coefficients above degree 0: red, green, blue of the first, and so on. */
  readonly harmonics?: readonly number[];
}

/** The value of the spherical harmonic of degree 0. */
const C0 = 0.28209479177387814;
const CODES = 256;

/** The document and images of splats in the form SOG. The codebooks are even; splats with the same list of harmonics share an entry of the palette. */
export async function sogFilesOf(splats: readonly SplatPoint[]): Promise<Map<string, Uint8Array>> {
  const side = Math.ceil(Math.sqrt(splats.length));
  const log = (value: number) => Math.sign(value) * Math.log1p(Math.abs(value));
  const axes = [0, 1, 2].map((axis) => splats.map(({ position }) => log(position[axis] ?? 0)));
  const mins = axes.map((values) => Math.min(...values));
  const maxs = axes.map((values, axis) => Math.max(...values, (mins[axis] ?? 0) + 1e-3));
  const scales = evenCodes(splats.flatMap(({ scale }) => scale.map(Math.log)));
  const base = evenCodes(splats.flatMap(({ color }) => color.map((value) => (value - 0.5) / C0)));
  const rest = evenCodes(splats.flatMap(({ harmonics = [] }) => harmonics));
  const palette = [...new Set(splats.map(({ harmonics = [] }) => harmonics))];
  const coefficients = (palette[0]?.length ?? 0) / 3;
  const step = (axis: number, i: number): number => {
    const from = mins[axis] ?? 0;
    return Math.round((65535 * ((axes[axis]?.[i] ?? 0) - from)) / ((maxs[axis] ?? 0) - from));
  };
  const image = (widthPx: number, heightPx: number, pixels: readonly number[][]) => {
    const data = new Uint8Array(4 * widthPx * heightPx).fill(255);
    pixels.forEach((pixel, i) => {
      data.set(pixel, 4 * i);
    });
    return sharp(data, { raw: { width: widthPx, height: heightPx, channels: 4 } })
      .webp({ lossless: true, exact: true })
      .toBuffer();
  };
  const perSplat = (pixelOf: (splat: SplatPoint, i: number) => number[]) => image(side, side, splats.map(pixelOf));
  const files = new Map<string, Uint8Array>([
    ['means_l.webp', await perSplat((_, i) => [0, 1, 2].map((axis) => step(axis, i) & 255))],
    ['means_u.webp', await perSplat((_, i) => [0, 1, 2].map((axis) => step(axis, i) >> 8))],
    ['scales.webp', await perSplat(({ scale }) => scale.map((value) => scales.codeOf(Math.log(value))))],
    ['quats.webp', await perSplat(({ rotation }) => smallestThree(rotation))],
    [
      'sh0.webp',
      await perSplat(({ color, opacity }) => [...color.map((value) => base.codeOf((value - 0.5) / C0)), Math.round(255 * opacity)]),
    ],
  ]);
  if (coefficients > 0) {
    const rows = Math.ceil(palette.length / 64);
    const entries = palette.flatMap((harmonics) =>
      Array.from({ length: coefficients }, (_, i) => [0, 1, 2].map((channel) => rest.codeOf(harmonics[3 * i + channel] ?? 0))),
    );
    files.set('shN_centroids.webp', await image(64 * coefficients, rows, entries));
    files.set('shN_labels.webp', await perSplat((splat) => labelOf(palette.indexOf(splat.harmonics ?? []))));
  }
  const meta = {
    version: 2,
    count: splats.length,
    antialias: false,
    means: { mins, maxs, files: ['means_l.webp', 'means_u.webp'] },
    scales: { codebook: scales.codebook, files: ['scales.webp'] },
    quats: { files: ['quats.webp'] },
    sh0: { codebook: base.codebook, files: ['sh0.webp'] },
    ...(coefficients > 0 && {
      shN: {
        count: palette.length,
        bands: [3, 8, 15].indexOf(coefficients) + 1,
        codebook: rest.codebook,
        files: ['shN_centroids.webp', 'shN_labels.webp'],
      },
    }),
  };
  return new Map([[SOG_META, new TextEncoder().encode(JSON.stringify(meta))], ...files]);
}

/** One SOG file of splats. */
export async function sogOf(splats: readonly SplatPoint[]): Promise<Uint8Array> {
  return writeZip(await sogFilesOf(splats));
}

function labelOf(entry: number): number[] {
  return [entry & 255, entry >> 8, 0];
}

function evenCodes(values: readonly number[]): { readonly codebook: number[]; readonly codeOf: (value: number) => number } {
  const low = values.reduce((a, b) => Math.min(a, b), 0);
  const extent = values.reduce((a, b) => Math.max(a, b), 0) - low || 1;
  return {
    codebook: Array.from({ length: CODES }, (_, i) => low + (extent * i) / (CODES - 1)),
    codeOf: (value) => Math.round(((value - low) / extent) * (CODES - 1)),
  };
}

/** The stored components in the order w, x, y, z without the largest, and 252 plus the index of the largest. */
function smallestThree([x, y, z, w]: SplatPoint['rotation']): number[] {
  const length = Math.hypot(x, y, z, w);
  const q = [w, x, y, z].map((value) => value / length);
  const largest = q.reduce((best, value, i) => (Math.abs(value) > Math.abs(q[best] ?? 0) ? i : best), 0);
  const sign = Math.sign(q[largest] ?? 1);
  const kept = q.filter((_, i) => i !== largest).map((value) => Math.round(255 * ((sign * value) / Math.SQRT2 + 0.5)));
  return [...kept, 252 + largest];
}
