import type { FoundLamp, FoundLamps, LampStep, NoLamps } from './found-lamps.ts';
import { directionAt } from './found-lamps.ts';
import { type GrayImage, grayImageOf } from './gray-image.ts';
import { medianOf } from './median.ts';
import { type Contour, momentsOf, outerContours } from './outer-contours.ts';
import { isDisplayReferred, type PanoramaPixels, ROWS_PER_STEP } from './pixels.ts';

/** Options of the paper's method. */
export interface PaperOptions {
  /** Maximum number of lamps. */
  readonly lamps: number;
  /** How often the search repeats; each iteration ignores the lamps of the iterations before. */
  readonly iterations: number;
  /** Relative intensities of the lamps. `ranks`: 100 %, 70 % and 40 %, by rank (table 1). `area`: in proportion to the area in pixels. */
  readonly intensities: 'ranks' | 'area';
}

/** Equation 1: an image has lamps only if its brightest pixel is at least this many times brighter than the mean. */
const MIN_RATIO = 1.5;
/** Figure 7: the threshold of lamps is this fraction of the spectrum of gray levels. */
const DARK_PART = 0.93;
/** Lamps are accepted only if at least this fraction of the pixels is below the threshold. */
const MIN_DARK_PIXELS = 0.98;
/** Table 1: intensities by rank. Further lamps have the last one. */
const RANKS = [1, 0.7, 0.4] as const;
const CLIPPED = 250;
/** Lamps that are left out count as alike from this part of the area of the smallest lamp on. */
const ALIKE = 0.5;

/**
 * Finds lamps as ARPAS does (“Real Time Shadow Mapping for Augmented Reality Photorealistic Rendering”, sections 3.2 to 3.5): gray, ratio
 * of maximum and mean, threshold at 93 % of the spectrum, median of 5 × 5 pixels, outer contours, moments. The lamp of most area comes
 * first. Intensities are relative: the strongest lamp has the irradiance π.
 *
 * It yields after about a millisecond of work, so that the caller can draw a frame, or abandon the search.
 *
 * @example
 * const search = findByPaper(pixels, { lamps: 3, iterations: 1, intensities: 'ranks' });
 */
export function* findByPaper(pixels: PanoramaPixels, options: PaperOptions): Generator<undefined, FoundLamps> {
  const image = yield* grayImageOf(pixels);
  const { widthPx, heightPx, gray, damaged } = image;
  const masked = new Uint8Array(gray.length);
  const steps: LampStep[] = [];
  const found: { readonly contour: Contour; readonly iteration: number }[] = [];
  let none: NoLamps | null = null;
  for (let iteration = 0; iteration < options.iterations; iteration++) {
    const search = yield* searchOnce(image, masked);
    if (search.step) steps.push(search.step);
    if (search.none !== null) {
      none = search.none;
      break;
    }
    for (const contour of search.contours) found.push({ contour, iteration });
    mask(masked, search.step);
    yield;
  }
  const clipped = isDisplayReferred(pixels) ? gray : null;
  const all = found.map((one) => lampOf(one, image, clipped)).filter((lamp) => lamp !== null);
  const sorted = all.sort((a, b) => b.areaPx - a.areaPx);
  const lamps = sorted.slice(0, options.lamps);
  const more = sorted.slice(options.lamps).filter(({ areaPx }) => areaPx > ALIKE * (lamps.at(-1)?.areaPx ?? 0)).length;
  const withIntensity = lamps.map((lamp, i): FoundLamp => {
    const part = options.intensities === 'area' ? lamp.areaPx / (lamps[0]?.areaPx ?? 1) : (RANKS[i] ?? RANKS[2]);
    return { ...lamp, irradiance: [Math.PI * part, Math.PI * part, Math.PI * part] };
  });
  const runs = lamps.flatMap(({ contour, iteration }) => runsWithin(contour, steps[iteration]?.smooth, widthPx));
  return {
    widthPx,
    heightPx,
    lamps: withIntensity,
    ...(more > 0 ? { more } : {}),
    none: lamps.length > 0 ? null : (none ?? 'lost-in-median'),
    runs,
    rest: null,
    damaged,
    steps,
  };
}

interface Search {
  readonly step: LampStep | null;
  readonly none: NoLamps | null;
  /** The contours that have an area. */
  readonly contours: readonly Contour[];
}

function* searchOnce({ gray, widthPx, heightPx }: GrayImage, masked: Uint8Array): Generator<undefined, Search> {
  const histogram = new Uint32Array(256);
  for (let i = 0; i < gray.length; i++) if (masked[i] === 0) histogram[gray[i] ?? 0] = (histogram[gray[i] ?? 0] ?? 0) + 1;
  yield;
  let [count, sum, max] = [0, 0, 0];
  for (const [level, pixels] of histogram.entries()) {
    count += pixels;
    sum += pixels * level;
    if (pixels > 0) max = level;
  }
  const mean = count > 0 ? sum / count : 0;
  if (max === 0) return { step: null, none: 'black', contours: [] };
  const threshold = DARK_PART * max;
  const abovePart = histogram.reduce((above, pixels, level) => above + (level > threshold ? pixels : 0), 0) / count;
  const bright = new Uint8Array(gray.length);
  for (let i = 0; i < gray.length; i++) {
    if (i % (widthPx * ROWS_PER_STEP * 4) === 0) yield;
    if (masked[i] === 0 && (gray[i] ?? 0) > threshold) bright[i] = 1;
  }
  const smooth = medianOf(bright, widthPx, heightPx);
  yield;
  const contours = outerContours(smooth, widthPx, heightPx);
  const step: LampStep = { histogram, max, mean, threshold, abovePart, bright, smooth, contours };
  if (max / mean < MIN_RATIO) return { step, none: 'bright-all-over', contours: [] };
  if (abovePart > 1 - MIN_DARK_PIXELS) return { step, none: 'too-much-above', contours: [] };
  const areas = contours.filter((contour) => momentsOf(contour) !== null);
  return { step, none: areas.length === 0 ? 'lost-in-median' : null, contours: areas };
}

/** Masks the lamps that an iteration has found, with the bright rim around them, so that the next iteration finds other lamps. */
function mask(masked: Uint8Array, step: LampStep | null): void {
  if (!step) return;
  for (let i = 0; i < masked.length; i++) if (step.bright[i] !== 0 || step.smooth[i] !== 0) masked[i] = 1;
}

type Found = { readonly contour: Contour; readonly iteration: number };

function lampOf({ contour, iteration }: Found, { widthPx, heightPx }: GrayImage, bytes: Uint8Array | null): FoundLamp | null {
  const moments = momentsOf(contour);
  if (!moments) return null;
  const [x, y] = moments.centerPx;
  const towards = directionAt(x, y, widthPx, heightPx);
  const pixelSr = ((2 * Math.PI) / widthPx) * (Math.PI / heightPx) * Math.hypot(towards[0], towards[2]);
  const clippedAt = bytes?.[Math.round(y) * widthPx + Math.round(x)] ?? 0;
  return {
    ...moments,
    towards,
    irradiance: [0, 0, 0],
    sizeRad: 2 * Math.sqrt((moments.areaPx * pixelSr) / Math.PI),
    contour,
    iteration,
    clippedPart: clippedAt >= CLIPPED ? 1 : 0,
  };
}

/** The pixels of the region that a contour bounds, as runs `[y, first x, last x + 1, …]`. */
function runsWithin(contour: Contour, smooth: Uint8Array | undefined, widthPx: number): number[] {
  const runs: number[] = [];
  const spans = new Map<number, number[]>();
  for (let i = 0; i < contour.length; i += 2) {
    const y = contour[i + 1] ?? 0;
    const xs = spans.get(y) ?? [];
    if (xs.length === 0) spans.set(y, xs);
    xs.push(contour[i] ?? 0);
  }
  for (const [y, xs] of [...spans].sort(([a], [b]) => a - b)) {
    const [first, end] = [Math.min(...xs), Math.max(...xs) + 1];
    for (let x = first; x < end; x++) {
      if (smooth?.[y * widthPx + x] === 0) continue;
      const start = x;
      while (x < end && smooth?.[y * widthPx + x] !== 0) x++;
      runs.push(y, start, x);
    }
  }
  return runs;
}
