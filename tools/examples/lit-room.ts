import { encode } from 'fast-png';
import { srgbFromLinear } from '../../nodes/kit/color-math.ts';
import { writeHdr } from './write-hdr.ts';

const WIDTH_PX = 256;
const HEIGHT_PX = 128;

type Vector = readonly [x: number, y: number, z: number];

/** Position of the camera, 1.6 m above the floor, and two opposite corners of the room, in meters. */
const EYE: Vector = [0, 1.6, 0];
const LOW: Vector = [-2, 0, -2.5];
const HIGH: Vector = [3, 3, 2.5];
/** A round lamp on the ceiling, to the right. */
const LAMP = { at: [1.3, 3, -1.2] as Vector, radiusM: 0.25, radiance: [70, 56, 38] as Vector };
/** A window in the left wall. */
const WINDOW = { low: [-2, 1.7, -0.9] as Vector, high: [-2, 2.8, 0.5] as Vector, radiance: [7, 8.5, 11] as Vector };
const WALLS: Vector = [0.62, 0.6, 0.56];
const FLOOR: Vector = [0.34, 0.27, 0.2];
const AMBIENT: Vector = [0.35, 0.36, 0.38];

/** A room with a lamp and a window as an equirectangular HDR image. The lamp and the window light the walls and the floor. */
export function makeLitRoom(): Uint8Array {
  return writeHdr(WIDTH_PX, HEIGHT_PX, litRoom());
}

/** A photo of the same room, as PNG: display-referred bytes, in which all that is brighter than white is clipped. */
export function makeLitRoomShot(stops: number): Uint8Array {
  const data = Uint8Array.from(litRoom(), (value) => Math.round(255 * srgbFromLinear(Math.min(1, value * 2 ** stops))));
  return encode({ width: WIDTH_PX, height: HEIGHT_PX, data, channels: 3, depth: 8 });
}

function litRoom(): readonly number[] {
  const rgb: number[] = [];
  for (let y = 0; y < HEIGHT_PX; y++) {
    const phi = Math.PI * (0.5 - (y + 0.5) / HEIGHT_PX);
    for (let x = 0; x < WIDTH_PX; x++) {
      const theta = 2 * Math.PI * ((x + 0.5) / WIDTH_PX - 0.5);
      rgb.push(...radianceOf([Math.sin(theta) * Math.cos(phi), Math.sin(phi), -Math.cos(theta) * Math.cos(phi)]));
    }
  }
  return rgb;
}

function radianceOf(way: Vector): Vector {
  const { at, axis } = hitWall(way);
  if (axis === 1 && way[1] > 0 && Math.hypot(at[0] - LAMP.at[0], at[2] - LAMP.at[2]) < LAMP.radiusM) return LAMP.radiance;
  const inWindow = [1, 2].every((i) => (at[i] ?? 0) > (WINDOW.low[i] ?? 0) && (at[i] ?? 0) < (WINDOW.high[i] ?? 0));
  if (axis === 0 && way[0] < 0 && inWindow) return WINDOW.radiance;
  const inwards: Vector = [axis === 0 ? -Math.sign(way[0]) : 0, axis === 1 ? -Math.sign(way[1]) : 0, axis === 2 ? -Math.sign(way[2]) : 0];
  const reflectance = axis === 1 && way[1] < 0 ? FLOOR : WALLS;
  const fromLamp = transfer(at, inwards, LAMP.at, [0, -1, 0], Math.PI * LAMP.radiusM ** 2);
  const middle: Vector = [WINDOW.low[0], (WINDOW.low[1] + WINDOW.high[1]) / 2, (WINDOW.low[2] + WINDOW.high[2]) / 2];
  const size = (WINDOW.high[1] - WINDOW.low[1]) * (WINDOW.high[2] - WINDOW.low[2]);
  const fromWindow = transfer(at, inwards, middle, [1, 0, 0], size);
  return [0, 1, 2].map((c) => {
    const irradiance = (LAMP.radiance[c] ?? 0) * fromLamp + (WINDOW.radiance[c] ?? 0) * fromWindow;
    return (reflectance[c] ?? 0) * ((AMBIENT[c] ?? 0) + irradiance / Math.PI);
  }) as unknown as Vector;
}

/** Where a ray from the eye meets a wall, and the index of the axis perpendicular to that wall. */
function hitWall(way: Vector): { readonly at: Vector; readonly axis: number } {
  const distances = way.map((part, i) => (((part > 0 ? HIGH : LOW)[i] ?? 0) - (EYE[i] ?? 0)) / part);
  const distance = Math.min(...distances.filter((d) => d > 0));
  const at = way.map((part, i) => (EYE[i] ?? 0) + part * distance) as unknown as Vector;
  return { at, axis: distances.indexOf(distance) };
}

/** Irradiance at a point of a wall, divided by the radiance of a small flat source that lights it. */
function transfer(at: Vector, normal: Vector, source: Vector, sourceNormal: Vector, areaM2: number): number {
  const way = source.map((part, i) => part - (at[i] ?? 0)) as unknown as Vector;
  const squared = Math.max(way[0] ** 2 + way[1] ** 2 + way[2] ** 2, areaM2);
  const cosines = Math.max(0, dot(way, normal)) * Math.max(0, -dot(way, sourceNormal));
  return (cosines * areaM2) / squared ** 2;
}

function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
