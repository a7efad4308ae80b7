import { type BrightRegion, brightRegionsOf, gridDirection, MAX_SPREAD_RAD, spreadRad } from './bright-regions.ts';
import { type ClippedLight, gainOfShare } from './clipped-light.ts';
import { type FillTarget, fillLamps } from './fill-lamps.ts';
import type { FoundLamp, FoundLamps, NoLamps } from './found-lamps.ts';
import { type Contour, outerContours } from './outer-contours.ts';
import type { PanoramaPixels } from './pixels.ts';
import { luminanceOf, type SphereGrid, sphereGridOf } from './sphere-grid.ts';

/** Options of the method by solid angle. */
export interface SolidAngleOptions {
  /** Maximum number of lamps. */
  readonly lamps: number;
  /**
   * The fraction of all light that pixels clipped to white are assumed to give, in [0, 1): they are brightened until they do. 0 changes
   * nothing. Only for display-referred panoramas.
   */
  readonly clippedShare: number;
}

/** The most regions that are joined with each other; weaker ones are not lamps, so that their light stays in the rest. */
const MAX_REGIONS = 64;
/** Lamps that are left out count as alike from this part of the light of the weakest lamp on. */
const ALIKE = 0.5;

/**
 * Finds lamps on the sphere. Each pixel counts by its solid angle, so lamps near the zenith are not enlarged, and lamps that the seam of
 * the panorama cuts are whole. Direction, color and irradiance of a lamp are those of its vector irradiance, the sum of radiance × solid
 * angle × direction, which is exact for surfaces that see all of it. Neighboring regions are joined (Ward 1963) until there are no more
 * than the wanted number of lamps.
 *
 * It yields after about a millisecond of work, so that the caller can draw a frame, or abandon the search.
 *
 * @example
 * const search = findBySolidAngle(pixels, { lamps: 3, clippedShare: 0.5 });
 */
export function* findBySolidAngle(pixels: PanoramaPixels, options: SolidAngleOptions): Generator<undefined, FoundLamps> {
  const grid = yield* sphereGridOf(pixels);
  const { widthPx, heightPx, damaged } = grid;
  const clipped = grid.clipped ? clippedLightOf(grid, grid.clipped) : null;
  const gain = clipped ? gainOfShare(clipped, options.clippedShare) : 1;
  if (grid.clipped) brightenClipped(grid, grid.clipped, gain);
  const regions = yield* brightRegionsOf(grid);
  const all = join(regions.slice(0, MAX_REGIONS), options.lamps);
  const groups = all.slice(0, options.lamps);
  const more = all.slice(options.lamps).filter(({ flux }) => flux > ALIKE * (groups.at(-1)?.flux ?? 0)).length;
  const runs = groups.flatMap((group) => runsOf(grid, group));
  const rest = grid.radiance.slice();
  yield;
  fillLamps(gridTarget(grid, rest), runs, grid);
  const lamps: FoundLamp[] = [];
  for (const group of groups) {
    yield;
    lamps.push(lampOf(grid, rest, group, gain));
  }
  yield;
  const none = lamps.length > 0 ? null : whyNone(grid);
  const white = clipped && clipped.flux > 0 ? { ...clipped, gain } : null;
  return {
    widthPx,
    heightPx,
    lamps,
    ...(more > 0 ? { more } : {}),
    none,
    runs,
    rest: lightFromAbove(grid, rest),
    clipped: white,
    damaged,
    steps: [],
  };
}

/** Sums the light of clipped areas and of all others. */
function clippedLightOf(grid: SphereGrid, clipped: Float32Array): ClippedLight {
  let [whole, flux] = [0, 0];
  for (let i = 0; i < clipped.length; i++) {
    const energy = (grid.luminance[i] ?? 0) * (grid.pixelSr[Math.floor(i / grid.widthPx)] ?? 0);
    whole += energy;
    flux += energy * (clipped[i] ?? 0);
  }
  return { flux, otherFlux: whole - flux };
}

/**
 * Brightens clipped pixels, because white in an image may stand for any brightness above. Measured indoors and outdoors, clipped lamps
 * give about half of all light.
 */
function brightenClipped(grid: SphereGrid, clipped: Float32Array, gain: number): void {
  for (let i = 0; gain > 1 && i < clipped.length; i++) {
    const factor = brightening(clipped[i] ?? 0, gain);
    if (factor === 1) continue;
    grid.luminance[i] = (grid.luminance[i] ?? 0) * factor;
    for (let c = i * 3; c < i * 3 + 3; c++) grid.radiance[c] = (grid.radiance[c] ?? 0) * factor;
  }
}

/** The factor on a pixel of which a part is clipped. */
function brightening(clippedPart: number, gain: number): number {
  return 1 + clippedPart * (gain - 1);
}

function whyNone({ luminance }: SphereGrid): NoLamps {
  return luminance.some((one) => one > 0) ? 'none-stands-out' : 'black';
}

interface Group {
  readonly pixels: readonly number[];
  readonly iteration: number;
  readonly vector: readonly [x: number, y: number, z: number];
  readonly flux: number;
}

/**
 * Joins regions to groups until there are at most `count`: always the pair that adds the least spread, while the result is not too wide.
 * Returns all groups, the strongest first.
 */
function join(regions: readonly BrightRegion[], count: number): Group[] {
  const groups: Group[] = [...regions];
  while (groups.length > count) {
    let best: readonly [number, number] | null = null;
    let least = Number.POSITIVE_INFINITY;
    for (let a = 0; a < groups.length; a++) {
      for (let b = a + 1; b < groups.length; b++) {
        const cost = addedSpread(groups[a] as Group, groups[b] as Group);
        if (cost < least) [best, least] = [[a, b], cost];
      }
    }
    if (!best) break;
    const [a, b] = best;
    groups[a] = joined(groups[a] as Group, groups[b] as Group);
    groups.splice(b, 1);
  }
  return groups.sort((a, b) => b.flux - a.flux);
}

/** The cost of joining two groups: flux × mean square angle that it adds; infinite if the result is too wide. */
function addedSpread(a: Group, b: Group): number {
  const whole = sumOf(a, b);
  const spread = spreadRad(whole);
  if (spread > MAX_SPREAD_RAD) return Number.POSITIVE_INFINITY;
  return spread ** 2 * whole.flux - spreadRad(a) ** 2 * a.flux - spreadRad(b) ** 2 * b.flux;
}

function joined(a: Group, b: Group): Group {
  return { ...sumOf(a, b), pixels: [...a.pixels, ...b.pixels], iteration: Math.min(a.iteration, b.iteration) };
}

function sumOf({ vector: a, flux }: Group, { vector: b, flux: more }: Group): Pick<Group, 'vector' | 'flux'> {
  return { vector: [a[0] + b[0], a[1] + b[1], a[2] + b[2]], flux: flux + more };
}

/** Measures a lamp. Only light above the brightness of the rest counts, so that no light is counted twice. */
function lampOf(grid: SphereGrid, rest: Float32Array, group: Group, gain: number): FoundLamp {
  const { widthPx, heightPx } = grid;
  const length = Math.hypot(...group.vector);
  const towards: [number, number, number] = [group.vector[0] / length, group.vector[1] / length, group.vector[2] / length];
  const irradiance: [number, number, number] = [0, 0, 0];
  const clippedIrradiance: [number, number, number] = [0, 0, 0];
  let [clippedSr, solidAngleSr] = [0, 0];
  for (const i of group.pixels) {
    const sr = grid.pixelSr[Math.floor(i / widthPx)] ?? 0;
    const direction = gridDirection(grid, i);
    const cosine = direction[0] * towards[0] + direction[1] * towards[1] + direction[2] * towards[2];
    const clippedPart = grid.clipped?.[i] ?? 0;
    const shownPart = clippedPart / brightening(clippedPart, gain);
    for (let c = 0; c < 3; c++) {
      const radiance = grid.radiance[i * 3 + c] ?? 0;
      irradiance[c] = (irradiance[c] ?? 0) + (radiance - (rest[i * 3 + c] ?? 0)) * sr * cosine;
      clippedIrradiance[c] = (clippedIrradiance[c] ?? 0) + radiance * shownPart * sr * cosine;
    }
    solidAngleSr += sr;
    clippedSr += sr * clippedPart;
  }
  // Of a uniform disk, the mean square angle is half the square of its radius.
  const sizeRad = 2 * Math.max(Math.SQRT2 * spreadRad(group), Math.sqrt((grid.pixelSr[heightPx >> 1] ?? 0) / Math.PI));
  const theta = Math.atan2(towards[0], -towards[2]);
  const phi = Math.asin(Math.min(1, Math.max(-1, towards[1])));
  return {
    towards,
    irradiance,
    ...(grid.clipped ? { clippedIrradiance } : {}),
    sizeRad,
    areaPx: group.pixels.length,
    centerPx: [((theta + Math.PI) / (2 * Math.PI)) * widthPx - 0.5, ((Math.PI / 2 - phi) / Math.PI) * heightPx - 0.5],
    contour: longestContour(grid, group.pixels),
    iteration: group.iteration,
    clippedPart: clippedSr / solidAngleSr,
  };
}

/** The vector irradiance of the upper half of a panorama, which is exact for a floor, as one lamp. */
function lightFromAbove(grid: SphereGrid, radiance: Float32Array): FoundLamps['rest'] {
  const { heightPx, pixelSr } = grid;
  const vector: [number, number, number] = [0, 0, 0];
  const up: [number, number, number] = [0, 0, 0];
  for (let y = 0; y < Math.floor(heightPx / 2); y++) {
    const sr = pixelSr[y] ?? 0;
    const phi = Math.PI / 2 - ((y + 0.5) / heightPx) * Math.PI;
    const row = rowSums(grid, radiance, y);
    for (let c = 0; c < 3; c++) up[c] = (up[c] ?? 0) + (row.color[c] ?? 0) * sr * Math.sin(phi);
    vector[0] += row.right * sr * Math.cos(phi);
    vector[1] += row.luminance * sr * Math.sin(phi);
    vector[2] += row.back * sr * Math.cos(phi);
  }
  const length = Math.hypot(...vector);
  if (length === 0) return null;
  const height = vector[1] / length;
  return {
    towards: [vector[0] / length, height, vector[2] / length],
    irradiance: [up[0] / height, up[1] / height, up[2] / height],
  };
}

/** Sums over a row: radiance, luminance, and luminance × the horizontal direction. */
function rowSums({ widthPx }: SphereGrid, radiance: Float32Array, y: number) {
  const sums = { color: [0, 0, 0], luminance: 0, right: 0, back: 0 };
  let [red, green, blue] = [0, 0, 0];
  for (let x = 0, i = y * widthPx * 3; x < widthPx; x++, i += 3) {
    const [r, g, b] = [radiance[i] ?? 0, radiance[i + 1] ?? 0, radiance[i + 2] ?? 0];
    const energy = luminanceOf(r, g, b);
    const theta = ((x + 0.5) / widthPx) * 2 * Math.PI - Math.PI;
    red += r;
    green += g;
    blue += b;
    sums.luminance += energy;
    sums.right += energy * Math.sin(theta);
    sums.back -= energy * Math.cos(theta);
  }
  sums.color = [red, green, blue];
  return sums;
}

function gridTarget({ widthPx, heightPx }: SphereGrid, radiance: Float32Array): FillTarget {
  return {
    widthPx,
    heightPx,
    get: (x, y, channel) => radiance[(y * widthPx + x) * 3 + channel] ?? 0,
    set: (x, y, channel, value) => {
      radiance[(y * widthPx + x) * 3 + channel] = value;
    },
  };
}

/** Only the rectangle around the pixels is searched. */
function longestContour({ widthPx }: SphereGrid, pixels: readonly number[]): Contour {
  let [left, right, top, bottom] = [widthPx, 0, Number.POSITIVE_INFINITY, 0];
  for (const i of pixels) {
    const y = Math.floor(i / widthPx);
    const x = i - y * widthPx;
    left = Math.min(left, x);
    right = Math.max(right, x);
    top = Math.min(top, y);
    bottom = Math.max(bottom, y);
  }
  const [across, down] = [right - left + 1, bottom - top + 1];
  const mask = new Uint8Array(across * down);
  for (const i of pixels) mask[(Math.floor(i / widthPx) - top) * across + (i % widthPx) - left] = 1;
  const longest = outerContours(mask, across, down).reduce((one, other) => (other.length > one.length ? other : one), [] as Contour);
  return longest.map((value, k) => value + (k % 2 === 0 ? left : top));
}

function runsOf({ widthPx }: SphereGrid, { pixels }: Group): number[] {
  const runs: number[] = [];
  const sorted = Uint32Array.from(pixels).sort();
  for (let k = 0; k < sorted.length; ) {
    const start = sorted[k] ?? 0;
    const y = Math.floor(start / widthPx);
    let end = start;
    while (k < sorted.length && sorted[k] === end && end < (y + 1) * widthPx) {
      end++;
      k++;
    }
    runs.push(y, start - y * widthPx, end - y * widthPx);
  }
  return runs;
}
