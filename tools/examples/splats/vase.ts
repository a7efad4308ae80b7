import { type SplatPoint, sogOf } from './write-sog.ts';

/** A glazed vase of flat splats on its surface, whose highlight moves with the eye. y is up, meters. */

type Vector = readonly [number, number, number];

const HEIGHT = 0.32;
const COUNT = 9000;
/** Spread of a splat along the surface. */
const SPREAD = 0.0045;
const THICKNESS = 0.0006;
const TOWARDS_LIGHT = unit([0.5, 0.8, 0.6]);
const GLAZE: Vector = [0.09, 0.3, 0.38];
const CLAY: Vector = [0.72, 0.43, 0.28];
const LINES: Vector = [0.9, 0.82, 0.62];
/** Directions of a normal that have their own highlight. */
const NORMALS = 256;
/** Directions that a highlight is measured in. */
const SAMPLES = 400;
const SHININESS = 10;

/** The file of the example, in the form SOG. */
export function makeVase(): Promise<Uint8Array> {
  const normals = evenDirections(NORMALS);
  const highlights = normals.map(highlightOf);
  const golden = Math.PI * (3 - Math.sqrt(5));
  const splats = evenHeights().map((y, i): SplatPoint => {
    const turn = i * golden;
    const radius = radiusAt(y);
    const normal = unit([Math.cos(turn), -slopeAt(y), Math.sin(turn)]);
    const nearest = normals.reduce((best, direction, j) => (dot(direction, normal) > dot(normals[best] ?? normal, normal) ? j : best), 0);
    const light = 0.35 + 0.65 * Math.max(0, dot(normal, TOWARDS_LIGHT));
    return {
      position: [radius * Math.cos(turn), y, radius * Math.sin(turn)],
      scale: [SPREAD, SPREAD, THICKNESS],
      rotation: zTo(normal),
      color: paint(y, turn).map((value) => value * light) as unknown as Vector,
      opacity: 0.95,
      harmonics: highlights[nearest] ?? [],
    };
  });
  return sogOf(splats);
}

/** The radius of the vase: foot, belly, neck and lip. */
function radiusAt(y: number): number {
  const t = y / HEIGHT;
  return (
    0.05 + 0.055 * Math.sin(Math.PI * Math.min(1, t * 1.25)) ** 2 * (1 - 0.2 * t) + 0.02 * Math.max(0, t - 0.8) * 5 * Math.max(0, t - 0.8)
  );
}

function slopeAt(y: number): number {
  return (radiusAt(y + 1e-4) - radiusAt(y - 1e-4)) / 2e-4;
}

/** Heights at which each splat lies, so that they are spread evenly over the surface. */
function evenHeights(): number[] {
  const steps = 4 * COUNT;
  const areas = [0];
  for (let i = 1; i <= steps; i++) {
    const y = ((i - 0.5) / steps) * HEIGHT;
    areas.push((areas[i - 1] ?? 0) + radiusAt(y) * Math.hypot(1, slopeAt(y)));
  }
  const total = areas[steps] ?? 1;
  let step = 0;
  return Array.from({ length: COUNT }, (_, i) => {
    while ((areas[step] ?? total) < (total * (i + 0.5)) / COUNT) step++;
    return (step / steps) * HEIGHT;
  });
}

function paint(y: number, turn: number): Vector {
  const t = y / HEIGHT;
  if (t < 0.12) return CLAY;
  const wave = 0.03 * Math.sin(6 * turn);
  const isLine = [0.2, 0.5, 0.56, 0.85].some((line, i) => Math.abs(t - line - (i === 0 ? wave : 0)) < 0.012);
  return isLine ? LINES : GLAZE;
}

/** The harmonics up to degree 2 of a highlight on a surface with this normal, without their mean. */
function highlightOf(normal: Vector): number[] {
  const sums = new Array<number>(8).fill(0);
  for (const direction of evenDirections(SAMPLES)) {
    // From the eye to the surface; what is mirrored there comes from the light.
    const mirrored = add(direction, normal, -2 * dot(direction, normal));
    const isSeen = dot(direction, normal) < 0;
    const glint = isSeen ? 0.5 * Math.max(0, dot(mirrored, TOWARDS_LIGHT)) ** SHININESS : 0;
    basisOf(direction).forEach((value, i) => {
      sums[i] = (sums[i] ?? 0) + (4 * Math.PI * glint * value) / SAMPLES;
    });
  }
  return sums.flatMap((sum) => [sum, sum, sum]);
}

/** Real spherical harmonics of degrees 1 and 2, as Gaussian splats have them. */
function basisOf([x, y, z]: Vector): number[] {
  const first = Math.sqrt(3 / (4 * Math.PI));
  const second = Math.sqrt(15 / (4 * Math.PI));
  const zonal = Math.sqrt(5 / (16 * Math.PI));
  return [
    ...[-first * y, first * z, -first * x],
    ...[second * x * y, -second * y * z, zonal * (3 * z * z - 1), -second * x * z, 0.5 * second * (x * x - y * y)],
  ];
}

/** Directions that are spread evenly, on a spiral. */
function evenDirections(count: number): Vector[] {
  const golden = Math.PI * (3 - Math.sqrt(5));
  return Array.from({ length: count }, (_, i) => {
    const y = 1 - (2 * (i + 0.5)) / count;
    const across = Math.sqrt(1 - y * y);
    return [across * Math.cos(i * golden), y, across * Math.sin(i * golden)];
  });
}

/** The rotation that turns z to a direction, x, y, z, w. */
function zTo([x, y, z]: Vector): SplatPoint['rotation'] {
  const length = Math.hypot(-y, x, 1 + z);
  return [-y / length, x / length, 0, (1 + z) / length];
}

function add(a: Vector, b: Vector, factor: number): Vector {
  return [a[0] + b[0] * factor, a[1] + b[1] * factor, a[2] + b[2] * factor];
}

function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function unit(a: Vector): Vector {
  return add([0, 0, 0], a, 1 / Math.hypot(...a));
}
