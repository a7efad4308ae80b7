import { ROWS_PER_STEP } from './pixels.ts';
import type { SphereGrid } from './sphere-grid.ts';

/** A connected region of bright pixels on the sphere, with its energy. */
export interface BrightRegion {
  /** Indices of the region's pixels in the grid. */
  readonly pixels: readonly number[];
  readonly iteration: number;
  /** The irradiance of a surface that faces the region, as a vector: the sum of luminance × solid angle × direction, in panorama space. */
  readonly vector: readonly [x: number, y: number, z: number];
  /** The light of the region: the sum of luminance × solid angle. */
  readonly flux: number;
}

/** A lamp is at least this many times brighter than the mean over all directions. */
const ABOVE_MEAN = 4;
/**
 * A region ends where the luminance is below this fraction of the brightest pixel, so that the sun is separated from the glow around it.
 */
const OF_PEAK = 0.02;
/** Regions with less than this fraction of the light of the whole panorama are no lamps. */
const MIN_FLUX = 0.004;
const ITERATIONS = 6;
/**
 * The greatest spread of a region (root mean square angle around its center) that one direction can represent. Of a wider region, the
 * brighter parts are taken instead.
 */
export const MAX_SPREAD_RAD = 0.18;
/** Factor by which the threshold is raised to find the brighter parts of a wide region. */
const RAISE = 1.5;
/**
 * If the brighter parts of a wide region have less than this fraction of its light, the region is evenly bright, as a window, and is one
 * lamp.
 */
const MIN_KEPT = 0.5;
/** The greatest spread of an evenly bright region that is one lamp: that of a disk of 42°. */
const MAX_EVEN_SPREAD_RAD = 0.26;

/**
 * Finds bright regions. Each iteration masks what the one before has found and takes the maximum anew, so that a window beside the sun
 * is found. Regions are connected over eight neighbors and across the seam.
 *
 * @returns The strongest first.
 */
export function* brightRegionsOf(grid: SphereGrid): Generator<undefined, BrightRegion[]> {
  const { luminance, widthPx, heightPx, pixelSr } = grid;
  const taken = new Uint8Array(luminance.length);
  const regions: BrightRegion[] = [];
  let total = 0;
  for (let y = 0; y < heightPx; y++) {
    for (let x = 0; x < widthPx; x++) total += (luminance[y * widthPx + x] ?? 0) * (pixelSr[y] ?? 0);
  }
  const least = (ABOVE_MEAN * total) / (4 * Math.PI);
  for (let iteration = 0; iteration < ITERATIONS; iteration++) {
    yield;
    let peak = 0;
    for (let i = 0; i < luminance.length; i++) if (taken[i] === 0 && (luminance[i] ?? 0) > peak) peak = luminance[i] ?? 0;
    const threshold = Math.max(least, peak * OF_PEAK);
    if (peak <= threshold) break;
    for (let y = 0; y < heightPx; y++) {
      if (y % ROWS_PER_STEP === 0) yield;
      for (let i = y * widthPx; i < (y + 1) * widthPx; i++) {
        if (!((luminance[i] ?? 0) > threshold) || taken[i] !== 0) continue;
        for (const region of narrowRegions(grid, taken, i, threshold, iteration)) {
          if (region.flux >= MIN_FLUX * total) regions.push(region);
        }
      }
    }
  }
  return regions.sort((a, b) => b.flux - a.flux);
}

/** Returns the region around a pixel, or its brighter parts if it is too wide. Marks all pixels of the region as taken. */
function narrowRegions(grid: SphereGrid, taken: Uint8Array, start: number, threshold: number, iteration: number): BrightRegion[] {
  const region = measure(grid, collect(grid, taken, start, threshold), iteration);
  if (spreadRad(region) <= MAX_SPREAD_RAD) return [region];
  const raised = threshold * RAISE;
  const parts: BrightRegion[] = [];
  for (const i of region.pixels) if ((grid.luminance[i] ?? 0) > raised) taken[i] = 0;
  for (const i of region.pixels) if (taken[i] === 0) parts.push(...narrowRegions(grid, taken, i, raised, iteration));
  const kept = parts.reduce((sum, { flux }) => sum + flux, 0);
  return kept < region.flux * MIN_KEPT && spreadRad(region) <= MAX_EVEN_SPREAD_RAD ? [region] : parts;
}

/**
 * How far the light of a region spreads around its mean direction: root mean square angle, radians. If the mean of unit vectors has the
 * length r, then 1 - r ≈ angle² / 2.
 *
 * @example
 * spreadRad({ vector: [0, 0, 1], flux: 1 }); // 0: all light comes from one direction
 */
export function spreadRad({ vector, flux }: Pick<BrightRegion, 'vector' | 'flux'>): number {
  return Math.sqrt(2 * Math.max(0, 1 - Math.hypot(...vector) / flux));
}

/** Collects the pixels above the threshold that are connected to the start, and marks them as taken. */
function collect({ luminance, widthPx, heightPx }: SphereGrid, taken: Uint8Array, start: number, threshold: number): number[] {
  const pixels = [start];
  taken[start] = 1;
  for (let next = 0; next < pixels.length; next++) {
    const at = pixels[next] ?? 0;
    const y = Math.floor(at / widthPx);
    const x = at - y * widthPx;
    for (let row = Math.max(y - 1, 0); row <= Math.min(y + 1, heightPx - 1); row++) {
      for (let dx = -1; dx <= 1; dx++) {
        const i = row * widthPx + ((x + dx + widthPx) % widthPx);
        if (taken[i] !== 0 || !((luminance[i] ?? 0) > threshold)) continue;
        taken[i] = 1;
        pixels.push(i);
      }
    }
  }
  return pixels;
}

function measure(grid: SphereGrid, pixels: readonly number[], iteration: number): BrightRegion {
  const vector: [number, number, number] = [0, 0, 0];
  let flux = 0;
  for (const i of pixels) {
    const energy = (grid.luminance[i] ?? 0) * (grid.pixelSr[Math.floor(i / grid.widthPx)] ?? 0);
    const towards = gridDirection(grid, i);
    flux += energy;
    for (let c = 0; c < 3; c++) vector[c] = (vector[c] ?? 0) + energy * (towards[c] ?? 0);
  }
  return { pixels, iteration, vector, flux };
}

/** The direction of the center of a pixel. The rows of a grid cover equal angles, and the upper edge of the first is the zenith. */
export function gridDirection({ widthPx, heightPx }: SphereGrid, i: number): readonly [x: number, y: number, z: number] {
  const row = Math.floor(i / widthPx);
  const theta = ((i - row * widthPx + 0.5) / widthPx) * 2 * Math.PI - Math.PI;
  const phi = Math.PI / 2 - ((row + 0.5) / heightPx) * Math.PI;
  return [Math.sin(theta) * Math.cos(phi), Math.sin(phi), -Math.cos(theta) * Math.cos(phi)];
}
