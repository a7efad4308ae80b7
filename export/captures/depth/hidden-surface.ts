import { type DepthMap, isKnown } from './depth-map.ts';
import type { DepthRays } from './depth-rays.ts';

/** What a photograph does not show: the surface behind its near things, as far as eyes beside the camera may see it. */
export interface HiddenSurface {
  /** Depth of the hidden surface, 0 where there is none. It overlaps what is seen by a pixel at its outer edge. */
  readonly map: DepthMap;
  /** RGBA of each pixel of the map. */
  readonly colors: Uint8Array;
}

/** A pixel hides its neighbor's surface if that is farther by this share. */
const EDGE = 0.02;
/** Depths that differ by less are of one surface. */
const SAME = 0.05;
/** How far eyes move from the camera, meters: as far as that, hidden surfaces reach under near things. */
const EYE_SHIFT_M = 0.3;
/** And at most this part of the width of the map. */
const MOST_REACH = 1 / 32;
/** Colors come from pixels so far behind the edge, whose own pixels mix both sides. */
const BEHIND_EDGE_PX = 3;
const ROUNDS = 40;

/**
 * Finds the surface behind near things: depth and color of the far side of each edge are pushed under the near side, pixel by pixel, then
 * smoothed by diffusion among neighbors of one surface. The near side never gives any color. Two layers like these are the future work
 * that Dupont de Dinechin and Paljic name (2020).
 *
 * @param colors RGBA, 8 bits, in the size of the map.
 * @param focalPx Pixels per unit of tangent, or per radian around a 360° camera.
 */
export function hiddenSurface(
  { widthPx, heightPx, values }: DepthMap,
  rays: DepthRays,
  colors: Uint8Array,
  focalPx: number,
): HiddenSurface {
  const count = widthPx * heightPx;
  const inverse = new Float32Array(count);
  const painted = new Float32Array(3 * count);
  const reach = new Float32Array(count);
  const steps = new Uint16Array(count);
  const most = widthPx * MOST_REACH;
  const isSeen = (at: number): boolean => isKnown(values[at] ?? 0);
  const depthAt = (at: number): number => values[at] ?? 0;
  const next = createNeighbors(widthPx, heightPx, rays.wraps);
  const queue: number[] = [];
  const seams = new Set<number>();

  const push = (at: number, from: number, surface: number, color: readonly number[]): void => {
    inverse[at] = surface;
    painted.set(color, 3 * at);
    steps[at] = (steps[from] ?? 0) + 1;
    queue.push(at);
  };
  for (let back = 0; back < count; back++) {
    if (!isSeen(back)) continue;
    for (let side = 0; side < 4; side++) {
      const front = next(back, side);
      if (front < 0 || !isSeen(front) || inverse[front] !== 0 || depthAt(back) <= depthAt(front) * (1 + EDGE)) continue;
      let source = back;
      for (let i = 0; i < BEHIND_EDGE_PX; i++) {
        const further = next(source, side ^ 1);
        if (further < 0 || !isSeen(further) || Math.abs(depthAt(further) / depthAt(source) - 1) > SAME) break;
        source = further;
      }
      seams.add(back);
      const parallax = focalPx * EYE_SHIFT_M * (1 / depthAt(front) - 1 / depthAt(back));
      reach[front] = Math.min(most, Math.max(2, parallax));
      push(front, front, 1 / depthAt(back), [...colors.subarray(4 * source, 4 * source + 3)]);
    }
  }
  for (let i = 0; i < queue.length; i++) {
    const from = queue[i] ?? 0;
    const surface = inverse[from] ?? 0;
    if ((steps[from] ?? 0) >= (reach[from] ?? 0)) continue;
    for (let side = 0; side < 4; side++) {
      const at = next(from, side);
      if (at < 0 || !isSeen(at) || inverse[at] !== 0 || depthAt(at) * (1 + EDGE) * surface >= 1) continue;
      reach[at] = reach[from] ?? 0;
      push(at, from, surface, [...painted.subarray(3 * from, 3 * from + 3)]);
    }
  }
  const inner = queue.length;
  for (const at of seams) {
    if (inverse[at] !== 0) continue;
    inverse[at] = 1 / depthAt(at);
    painted.set(colors.subarray(4 * at, 4 * at + 3), 3 * at);
  }
  smooth(queue.slice(0, inner), inverse, painted, next);

  const hidden = new Float32Array(count);
  const shown = new Uint8Array(4 * count);
  for (let at = 0; at < count; at++) {
    const row = Math.floor(at / widthPx);
    // The rows at the poles of a 360° photograph would be closed to caps.
    if (inverse[at] === 0 || (rays.wraps && (row === 0 || row === heightPx - 1))) continue;
    hidden[at] = 1 / (inverse[at] ?? 1);
    for (let c = 0; c < 3; c++) shown[4 * at + c] = Math.round(painted[3 * at + c] ?? 0);
    shown[4 * at + 3] = 255;
  }
  return { map: { widthPx, heightPx, values: hidden }, colors: shown };
}

/** Replaces depth and color of pixels by the means of their neighbors on the same surface, many times. */
function smooth(pixels: readonly number[], inverse: Float32Array, painted: Float32Array, next: Neighbors): void {
  const means = new Float32Array(4 * pixels.length);
  for (let round = 0; round < ROUNDS; round++) {
    pixels.forEach((at, i) => {
      const surface = inverse[at] ?? 0;
      let [sum, weight] = [surface, 1];
      let [r, g, b] = painted.subarray(3 * at, 3 * at + 3) as unknown as [number, number, number];
      for (let side = 0; side < 4; side++) {
        const beside = next(at, side);
        if (beside < 0 || !(Math.abs((inverse[beside] ?? 0) / surface - 1) < SAME)) continue;
        weight++;
        sum += inverse[beside] ?? 0;
        r += painted[3 * beside] ?? 0;
        g += painted[3 * beside + 1] ?? 0;
        b += painted[3 * beside + 2] ?? 0;
      }
      means[4 * i] = sum / weight;
      means[4 * i + 1] = r / weight;
      means[4 * i + 2] = g / weight;
      means[4 * i + 3] = b / weight;
    });
    pixels.forEach((at, i) => {
      inverse[at] = means[4 * i] ?? 0;
      painted.set(means.subarray(4 * i + 1, 4 * i + 4), 3 * at);
    });
  }
}

/** The pixel to the left, right, above or below (0 to 3); -1 beyond the map. `side ^ 1` is the opposite one. */
type Neighbors = (at: number, side: number) => number;

function createNeighbors(widthPx: number, heightPx: number, wraps: boolean): Neighbors {
  return (at, side) => {
    const column = at % widthPx;
    if (side === 0) return column > 0 ? at - 1 : wraps ? at + widthPx - 1 : -1;
    if (side === 1) return column < widthPx - 1 ? at + 1 : wraps ? at - widthPx + 1 : -1;
    if (side === 2) return at >= widthPx ? at - widthPx : -1;
    return at < widthPx * (heightPx - 1) ? at + widthPx : -1;
  };
}
