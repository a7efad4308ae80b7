import { gridDirection } from '../../nodes/kit/panorama/bright-regions.ts';
import type { FoundLamp, FoundLamps } from '../../nodes/kit/panorama/found-lamps.ts';
import type { SphereGrid } from '../../nodes/kit/panorama/sphere-grid.ts';
import { harmonicsBasis } from './spherical-harmonics.ts';

/** How far light from lamps and a rest is from the light of the whole panorama, relative to the mean irradiance. */
export interface LightError {
  /** Irradiance of 64 normals: root mean square. */
  readonly normals: number;
  /** Irradiance of 24 points of a floor beside a box that blocks light, relative to the floor without the box: root mean square. */
  readonly shadow: number;
}

type Vector = readonly [x: number, y: number, z: number];

const NORMALS: readonly Vector[] = spiral(64);
/** Three distances from the sides of a box of one meter, in eight directions. */
const POINTS: readonly (readonly [x: number, z: number])[] = [0.15, 0.4, 0.9].flatMap((gap) =>
  Array.from({ length: 8 }, (_, i): readonly [number, number] => {
    const [x, z] = [Math.cos((i * Math.PI) / 4), Math.sin((i * Math.PI) / 4)];
    const scale = (0.5 + gap) / Math.max(Math.abs(x), Math.abs(z));
    return [x * scale, z * scale];
  }),
);

/** Luminance per direction, all pixels of the grid. */
interface Sky {
  readonly directions: readonly Vector[];
  readonly energy: Float64Array;
}

/** Compares lights with the whole of a panorama, by integration over all pixels. A box blocks both. */
export interface LightMeasure {
  /**
   * Of lamps and the rest of the panorama.
   *
   * @param rest Luminance without the lamps.
   * @param gain Factor on the lamps; `null` for the one with which they give all of the light that the rest lacks.
   */
  errorOf(found: FoundLamps, rest: Float32Array, gain?: number | null): LightError;
  /** Of nine coefficients of spherical harmonics, which cast no shadow. */
  harmonicsError(): LightError;
}

export function measureOf(grid: SphereGrid): LightMeasure {
  const whole = skyOf(grid, grid.luminance);
  const normals = NORMALS.map((n) => irradiance(whole, n));
  const floors = POINTS.map((p) => floor(whole, p, true));
  const open = floor(whole, [0, 0], false);
  const mean = meanOf(normals);

  function compare(byNormal: readonly number[], byPoint: readonly number[]): LightError {
    return {
      normals: rootMeanSquare(byNormal.map((value, i) => (value - (normals[i] ?? 0)) / mean)),
      shadow: rootMeanSquare(byPoint.map((value, i) => (value - (floors[i] ?? 0)) / open)),
    };
  }

  return {
    errorOf: (found, rest, gain = 1) => {
      const remaining: Sky = { ...whole, energy: energyOf(grid, rest) };
      const lamps = found.lamps.map(discOf);
      const restByNormal = NORMALS.map((n) => irradiance(remaining, n));
      const lampsByNormal = NORMALS.map((n) => lamps.reduce((sum, lamp) => sum + lamp.energy * Math.max(0, dot(lamp.towards, n)), 0));
      const factor = gain ?? (mean - meanOf(restByNormal)) / meanOf(lampsByNormal);
      return compare(
        restByNormal.map((value, i) => value + factor * (lampsByNormal[i] ?? 0)),
        POINTS.map((p) => floor(remaining, p, true) + factor * lamps.reduce((sum, lamp) => sum + floor(lamp.sky, p, true), 0)),
      );
    },
    harmonicsError: () => {
      const coefficients = harmonicsBasis(0, 1, 0).map(() => 0);
      for (const [k, direction] of whole.directions.entries()) {
        const basis = harmonicsBasis(...direction);
        for (let i = 0; i < basis.length; i++) coefficients[i] = (coefficients[i] ?? 0) + (whole.energy[k] ?? 0) * (basis[i] ?? 0);
      }
      // Ramamoorthi and Hanrahan 2001: factors of the clamped cosine.
      const factors = [Math.PI, ...[0, 0, 0].fill((2 * Math.PI) / 3), ...[0, 0, 0, 0, 0].fill(Math.PI / 4)];
      const smooth = (n: Vector): number =>
        harmonicsBasis(...n).reduce((sum, value, i) => sum + value * (coefficients[i] ?? 0) * (factors[i] ?? 0), 0);
      return compare(
        NORMALS.map(smooth),
        POINTS.map(() => smooth([0, 1, 0])),
      );
    },
  };
}

function meanOf(values: readonly number[]): number {
  return values.reduce((sum, one) => sum + one, 0) / values.length;
}

function skyOf(grid: SphereGrid, luminance: Float32Array): Sky {
  return { directions: Array.from(luminance, (_, i) => gridDirection(grid, i)), energy: energyOf(grid, luminance) };
}

function energyOf({ widthPx, pixelSr }: SphereGrid, luminance: Float32Array): Float64Array {
  return Float64Array.from(luminance, (l, i) => l * (pixelSr[Math.floor(i / widthPx)] ?? 0));
}

/** A lamp as 64 directions over its disk. */
function discOf({ towards, irradiance: [red, green, blue], sizeRad }: FoundLamp) {
  const energy = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  const side = normalize(cross(towards, Math.abs(towards[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0]));
  const up = cross(side, towards);
  const directions = Array.from({ length: 64 }, (_, i): Vector => {
    const radius = Math.tan(sizeRad / 2) * Math.sqrt((i + 0.5) / 64);
    const angle = i * 2.399963;
    const [u, v] = [radius * Math.cos(angle), radius * Math.sin(angle)];
    return normalize([towards[0] + u * side[0] + v * up[0], towards[1] + u * side[1] + v * up[1], towards[2] + u * side[2] + v * up[2]]);
  });
  return { towards, energy, sky: { directions, energy: new Float64Array(64).fill(energy / 64) } };
}

function irradiance({ directions, energy }: Sky, n: Vector): number {
  let sum = 0;
  for (let i = 0; i < energy.length; i++) {
    const cosine = dot(directions[i] as Vector, n);
    if (cosine > 0) sum += cosine * (energy[i] ?? 0);
  }
  return sum;
}

function floor({ directions, energy }: Sky, [x, z]: readonly [number, number], box: boolean): number {
  let sum = 0;
  for (let i = 0; i < energy.length; i++) {
    const direction = directions[i] as Vector;
    if (direction[1] <= 0 || (box && hitsBox(x, z, direction))) continue;
    sum += direction[1] * (energy[i] ?? 0);
  }
  return sum;
}

/** Whether a ray from the floor enters the box from (-0.5, 0, -0.5) to (0.5, 1, 0.5). */
function hitsBox(x: number, z: number, [dx, dy, dz]: Vector): boolean {
  let [near, far] = [0, 1 / dy];
  for (const [origin, way] of [
    [x, dx],
    [z, dz],
  ] as const) {
    const [a, b] = [(-0.5 - origin) / way, (0.5 - origin) / way];
    near = Math.max(near, Math.min(a, b));
    far = Math.min(far, Math.max(a, b));
  }
  return near < far;
}

/** Directions spread evenly over the sphere. */
function spiral(count: number): Vector[] {
  return Array.from({ length: count }, (_, i): Vector => {
    const y = 1 - (2 * i + 1) / count;
    const radius = Math.sqrt(1 - y * y);
    return [radius * Math.cos(i * 2.399963), y, radius * Math.sin(i * 2.399963)];
  });
}

function rootMeanSquare(values: readonly number[]): number {
  return Math.sqrt(values.reduce((sum, value) => sum + value * value, 0) / values.length);
}

function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function normalize([x, y, z]: Vector): Vector {
  const length = Math.hypot(x, y, z);
  return [x / length, y / length, z / length];
}
