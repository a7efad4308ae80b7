import type { SogMeta } from './sog-meta.ts';
import { packSplats } from './splat-packer.ts';
import { COEFFICIENTS, SplatError, type Splats } from './splats.ts';

/** A decoded image: RGBA, rows from the top, straight alpha. */
export interface SogImage {
  readonly data: Uint8Array;
  readonly widthPx: number;
  readonly heightPx: number;
}

/** Entries of the palette of harmonics per row. */
const ENTRIES_PER_ROW = 64;
/** Alpha of a rotation whose largest component is w. Those of x, y and z follow. */
const FIRST_MODE = 252;
/** For each mode, where the three stored components are in a rotation (x, y, z, w). They are stored in the order w, x, y, z. */
const STORED = [
  [0, 1, 2],
  [3, 1, 2],
  [3, 0, 2],
  [3, 0, 1],
] as const;
/** Where the component that is not stored is. */
const LARGEST = [3, 0, 1, 2] as const;

/**
 * Reads splats from the images of a SOG file.
 *
 * @param images One per name in `meta.files`.
 * @throws SplatError
 *
 * @example
 * const splats = readSog(meta, images);
 */
export function readSog(meta: SogMeta, images: readonly SogImage[]): Splats {
  const { count, mins, maxs, scales, base, harmonics } = meta;
  const [low, high, scale, rotation, color, centroids, labels] = images;
  if (!low || !high || !scale || !rotation || !color) throw new SplatError('some of its images are missing');
  for (const [i, image] of images.entries()) {
    const most = image.widthPx * image.heightPx;
    if (image !== centroids && most < count) throw new SplatError(`its ${meta.files[i]} has ${most} pixels for ${count} splats`);
  }
  const degree = harmonics?.degree ?? 0;
  const coefficients = COEFFICIENTS[degree];
  if (harmonics && !fits(centroids, coefficients, harmonics.count)) throw new SplatError(`its ${meta.files[5]} has the wrong size`);
  return packSplats(count, degree, meta.antialias, (index, splat) => {
    const at = 4 * index;
    const mode = (rotation.data[at + 3] ?? 0) - FIRST_MODE;
    let rest = 1;
    for (let i = 0; i < 3; i++) {
      const step = ((high.data[at + i] ?? 0) << 8) | (low.data[at + i] ?? 0);
      const from = mins[i] ?? 0;
      const log = from + ((maxs[i] ?? 0) - from) * (step / 65535);
      splat.position[i] = Math.sign(log) * Math.expm1(Math.abs(log));
      splat.scale[i] = Math.exp(scales[scale.data[at + i] ?? 0] ?? 0);
      splat.base[i] = base[color.data[at + i] ?? 0] ?? 0;
      const component = ((rotation.data[at + i] ?? 0) / 255 - 0.5) * Math.SQRT2;
      rest -= component * component;
      splat.rotation[STORED[mode]?.[i] ?? i] = component;
    }
    // An alpha that is no mode makes the splat invalid.
    splat.rotation[LARGEST[mode] ?? 3] = LARGEST[mode] === undefined ? Number.NaN : Math.sqrt(Math.max(0, rest));
    splat.opacity = (color.data[at + 3] ?? 0) / 255;
    if (!harmonics || !centroids || !labels) return;
    const entry = (labels.data[at] ?? 0) | ((labels.data[at + 1] ?? 0) << 8);
    const first = Math.floor(entry / ENTRIES_PER_ROW) * centroids.widthPx + (entry % ENTRIES_PER_ROW) * coefficients;
    for (let i = 0; i < coefficients; i++) {
      for (let channel = 0; channel < 3; channel++) {
        splat.harmonics[3 * i + channel] = harmonics.codebook[centroids.data[4 * (first + i) + channel] ?? 0] ?? 0;
      }
    }
  });
}

function fits(centroids: SogImage | undefined, coefficients: number, count: number): boolean {
  if (!centroids) return false;
  return centroids.widthPx === ENTRIES_PER_ROW * coefficients && centroids.heightPx >= Math.ceil(count / ENTRIES_PER_ROW);
}
