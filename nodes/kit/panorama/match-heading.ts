import type { PanoramaPixels } from './pixels.ts';
import type { PanoramaShot } from './shot.ts';
import { luminanceOf } from './sphere-grid.ts';
import { linearTable } from './stitch.ts';

/** The heading of a panorama that fits camera images best, and how well it fits. */
export interface HeadingMatch {
  /** Rotation of the panorama about y, counterclockwise seen from above. */
  readonly headingRad: number;
  /** Correlation of the images with the panorama at this heading, at most 1. */
  readonly score: number;
  /** The best correlation of any heading more than 20° away. */
  readonly nextScore: number;
}

/** Finds the heading of a panorama from camera images whose poses are upright, but turned by an unknown angle. */
export interface HeadingSearch {
  /** Adds a camera image. Later ones make the result more certain. */
  add(shot: PanoramaShot): HeadingMatch;
  reset(): void;
}

/** The number of columns of the reduced panorama, half a degree each; `ROWS` likewise. */
const COLUMNS = 720;
const ROWS = COLUMNS / 2;
/** The number of points along each side of an image that are compared. */
const GRID = 40;
const APART_RAD = (20 * Math.PI) / 180;
/** The number of images that count. With each further image, the older ones lose weight. */
const MOST_SHOTS = 12;

/**
 * Whether a match is certain: its correlation is high, and clearly above that of every other heading.
 *
 * @example
 * isCertain({ headingRad: 0, score: 0.8, nextScore: 0.5 }); // true
 */
export function isCertain({ score, nextScore }: HeadingMatch): boolean {
  return score > 0.6 && score - nextScore > 0.12;
}

/**
 * Creates a search that compares camera images with a panorama.
 *
 * @param panorama Holes that were filled count as well.
 *
 * @example
 * const match = createHeadingSearch(panorama).add(shot);
 * if (isCertain(match)) setPanoramaPose(pose, match.headingRad, at);
 */
export function createHeadingSearch(panorama: PanoramaPixels): HeadingSearch {
  const map = reduce(panorama);
  const totals = new Float64Array(COLUMNS);
  let shots = 0;
  return {
    add: (shot) => {
      if (shots === MOST_SHOTS) {
        // Older images fade, as they may have been wrong.
        for (let i = 0; i < COLUMNS; i++) totals[i] = ((totals[i] ?? 0) * (MOST_SHOTS - 1)) / MOST_SHOTS;
        shots--;
      }
      correlate(totals, map, shot);
      shots++;
      return bestOf(totals, shots);
    },
    reset: () => {
      totals.fill(0);
      shots = 0;
    },
  };
}

/**
 * Reduces an image to the logarithm of its luminance in `COLUMNS` × `ROWS` cells; each is the mean of its cell. Logarithms make a change of
 * exposure a constant offset.
 */
function reduce({ data, widthPx, heightPx, channels, fromBottom = false }: PanoramaPixels): Float32Array {
  const map = new Float32Array(COLUMNS * ROWS);
  const inBytes = data.BYTES_PER_ELEMENT === 1;
  const light = linearTable();
  const read = (i: number): number => (inBytes ? (light[data[i] ?? 0] ?? 0) : (data[i] ?? 0));
  for (let i = 0; i < map.length; i++) {
    const [row, column] = [Math.floor(i / COLUMNS), i % COLUMNS];
    const [top, left] = [Math.floor((row / ROWS) * heightPx), Math.floor((column / COLUMNS) * widthPx)];
    const bottom = Math.max(top + 1, Math.floor(((row + 1) / ROWS) * heightPx));
    const right = Math.max(left + 1, Math.floor(((column + 1) / COLUMNS) * widthPx));
    let sum = 0;
    for (let y = top; y < bottom; y++) {
      for (let x = left; x < right; x++) {
        const at = ((fromBottom ? heightPx - 1 - y : y) * widthPx + x) * channels;
        sum += channels === 1 ? read(at) : luminanceOf(read(at), read(at + 1), read(at + 2));
      }
    }
    map[i] = logarithm(sum / ((bottom - top) * (right - left)));
  }
  return map;
}

function logarithm(luminance: number): number {
  return Math.log(Math.min(Math.max(luminance, 0), 1) + 0.02);
}

/** For each heading, adds the normalized correlation of an image with the panorama to `totals`. */
function correlate(totals: Float64Array, map: Float32Array, shot: PanoramaShot): void {
  const { columns, rows, values } = pointsOf(shot);
  const mean = meanOf(values);
  let energy = 0;
  for (const value of values) energy += (value - mean) ** 2;
  for (let turn = 0; turn < COLUMNS; turn++) {
    let sum = 0;
    let squares = 0;
    let product = 0;
    for (let i = 0; i < values.length; i++) {
      // A panorama turned counterclockwise shows what is at longitude λ in its own space at λ plus the heading to the right.
      const value = map[(rows[i] ?? 0) * COLUMNS + (((columns[i] ?? 0) + turn) % COLUMNS)] ?? 0;
      sum += value;
      squares += value * value;
      product += value * ((values[i] ?? 0) - mean);
    }
    const spread = squares - (sum * sum) / values.length;
    totals[turn] = (totals[turn] ?? 0) + (spread * energy > 1e-9 ? product / Math.sqrt(spread * energy) : 0);
  }
}

/** Samples an image on a grid. For each point: its column and row in the panorama if the heading is 0, and its value. */
function pointsOf({ data, widthPx, heightPx, clipFromView: p, worldFromView: m }: PanoramaShot) {
  const columns: number[] = [];
  const rows: number[] = [];
  const values: number[] = [];
  const light = linearTable();
  const blockX = Math.max(1, Math.floor(widthPx / GRID));
  const blockY = Math.max(1, Math.floor(heightPx / GRID));
  for (let v = 0; v + blockY <= heightPx; v += blockY) {
    for (let u = 0; u + blockX <= widthPx; u += blockX) {
      const x = (((u + blockX / 2) / widthPx) * 2 - 1 + (p[8] ?? 0)) / (p[0] ?? 1);
      const y = (((v + blockY / 2) / heightPx) * 2 - 1 + (p[9] ?? 0)) / (p[5] ?? 1);
      const right = (m[0] ?? 0) * x + (m[4] ?? 0) * y - (m[8] ?? 0);
      const up = (m[1] ?? 0) * x + (m[5] ?? 0) * y - (m[9] ?? 0);
      const back = (m[2] ?? 0) * x + (m[6] ?? 0) * y - (m[10] ?? 0);
      const longitude = Math.atan2(right, -back);
      const latitude = Math.atan2(up, Math.hypot(right, back));
      // Near the poles, all headings look alike.
      if (Math.abs(latitude) > 1.2) continue;
      columns.push(Math.floor(((longitude / (2 * Math.PI) + 0.5) * COLUMNS) % COLUMNS));
      rows.push(Math.min(Math.floor((0.5 - latitude / Math.PI) * ROWS), ROWS - 1));
      let sum = 0;
      for (let j = 0; j < blockY; j++) {
        for (let i = 0; i < blockX; i++) {
          const at = ((v + j) * widthPx + u + i) * 4;
          sum += luminanceOf(light[data[at] ?? 0] ?? 0, light[data[at + 1] ?? 0] ?? 0, light[data[at + 2] ?? 0] ?? 0);
        }
      }
      values.push(logarithm(sum / (blockX * blockY)));
    }
  }
  return { columns, rows, values };
}

function meanOf(values: readonly number[]): number {
  return values.reduce((sum, value) => sum + value, 0) / Math.max(1, values.length);
}

function bestOf(totals: Float64Array, shots: number): HeadingMatch {
  let best = 0;
  for (let i = 1; i < COLUMNS; i++) if ((totals[i] ?? 0) > (totals[best] ?? 0)) best = i;
  let next = Number.NEGATIVE_INFINITY;
  const apart = Math.round((APART_RAD / (2 * Math.PI)) * COLUMNS);
  for (let i = apart; i <= COLUMNS - apart; i++) next = Math.max(next, totals[(best + i) % COLUMNS] ?? 0);
  // A parabola through the three best.
  const [before, at, after] = [-1, 0, 1].map((by) => totals[(best + by + COLUMNS) % COLUMNS] ?? 0) as [number, number, number];
  const bend = before - 2 * at + after;
  const turn = best + (bend < 0 ? (before - after) / (2 * bend) : 0);
  const angle = (turn / COLUMNS) * 2 * Math.PI;
  return { headingRad: angle > Math.PI ? angle - 2 * Math.PI : angle, score: at / shots, nextScore: next / shots };
}
