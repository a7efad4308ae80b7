import { LatheGeometry, SphereGeometry, Vector2 } from 'three';
import { RoundedBoxGeometry } from 'three/examples/jsm/geometries/RoundedBoxGeometry.js';
import { type Color, drawTexture, mix, wood } from './draw-texture.ts';
import { type ModelPart, type Paint, writeModel } from './write-model.ts';

export const CAN = { radiusM: 0.043, heightM: 0.122 } as const;
export const CRATE_M = [0.56, 0.2, 0.24] as const;
export const BALL_RADIUS_M = 0.045;

const CREAM: Color = [0.96, 0.9, 0.76];
const RED: Color = [0.78, 0.12, 0.1];
const BLUE: Color = [0.07, 0.24, 0.42];

/** A tin can with a printed label: stripes above and below a band of stars. */
export function makeCan(): Promise<Uint8Array> {
  const { radiusM: r, heightM: h } = CAN;
  const label = drawTexture(512, 128, (u, v) => {
    if (v < 0.05 || v > 0.95) return BLUE;
    if (v < 0.3 || v > 0.7) return (u * 24) % 1 < 0.5 ? RED : CREAM;
    if (v < 0.34 || v > 0.66) return CREAM;
    // Six stars, in meters on the can.
    const x = (((u * 6) % 1) - 0.5) * ((2 * Math.PI * r) / 6);
    return isStar(x, (v - 0.5) * 0.77 * h, 0.014) ? CREAM : BLUE;
  });
  const tin: Paint = { name: 'tin', color: [0.72, 0.72, 0.7], metalness: 0.95, roughness: 0.3 };
  const lathe = (points: readonly (readonly [number, number])[]) =>
    new LatheGeometry(
      points.map(([x, y]) => new Vector2(x * r, y * h)),
      40,
    );
  const rim = 0.035;
  return writeModel([
    {
      name: 'ends',
      geometry: lathe([
        [0, -0.46],
        [0.9, -0.46],
        [0.93, -0.5],
        [1, -0.5],
        [1, -0.5 + rim],
        [0.965, -0.5 + rim + 0.02],
        [0.965, -0.39],
      ]),
      paint: tin,
    },
    {
      name: 'label',
      geometry: lathe([
        [0.965, -0.39],
        [0.972, -0.385],
        [0.972, 0.385],
        [0.965, 0.39],
      ]),
      paint: { name: 'label', color: [1, 1, 1], metalness: 0.35, roughness: 0.35, texture: label },
    },
    {
      name: 'top',
      geometry: lathe([
        [0.965, 0.39],
        [0.965, 0.5 - rim - 0.02],
        [1, 0.5 - rim],
        [1, 0.5],
        [0.93, 0.5],
        [0.9, 0.46],
        [0, 0.46],
      ]),
      paint: tin,
    },
  ]);
}

/** Whether a point lies in a five-pointed star around the origin with this outer radius, one point up. */
function isStar(x: number, y: number, radius: number): boolean {
  const turn = (2 * Math.PI) / 5;
  const angle = Math.abs(((((Math.atan2(x, y) + turn / 2) % turn) + turn) % turn) - turn / 2);
  const away = Math.hypot(x, y);
  // The edge from a point to the notch at 0.382 of the radius.
  const notch = 0.382 * radius;
  const [nx, ny] = [notch * Math.sin(turn / 2), notch * Math.cos(turn / 2)];
  const [px, py] = [away * Math.sin(angle), away * Math.cos(angle)];
  return nx * (py - radius) - (ny - radius) * px < 0;
}

/** A crate of planks. */
export function makeCrate(): Promise<Uint8Array> {
  const [width, height, depth] = CRATE_M;
  const pine: Paint = {
    name: 'pine',
    color: [1, 1, 1],
    roughness: 0.75,
    texture: drawTexture(256, 128, wood([0.86, 0.68, 0.45], [0.66, 0.45, 0.26], 2.2)),
  };
  const dark: Paint = { name: 'shade', color: [0.05, 0.035, 0.025], roughness: 0.95 };
  const plank = (name: string, size: readonly [number, number, number], at: readonly [number, number, number]): ModelPart => ({
    name,
    geometry: new RoundedBoxGeometry(...size, 2, 0.004).translate(...at),
    paint: pine,
  });
  const parts: ModelPart[] = [
    {
      name: 'inside',
      geometry: new RoundedBoxGeometry(width - 0.03, height - 0.02, depth - 0.03, 1, 0.002).translate(0, height / 2 - 0.005, 0),
      paint: dark,
    },
  ];
  // The lid is closed: cans stand on it.
  for (let i = 0; i < 3; i++) parts.push(plank(`lid ${i}`, [width, 0.014, depth / 3 - 0.001], [0, height - 0.007, ((i - 1) * depth) / 3]));
  for (const z of [-1, 1]) {
    for (let i = 0; i < 3; i++) {
      const y = 0.026 + i * 0.062;
      parts.push(plank(`side ${z} ${i}`, [width - 0.004, 0.052, 0.012], [0, y, z * (depth / 2 - 0.008)]));
    }
    for (const x of [-1, 1])
      parts.push(plank(`post ${x} ${z}`, [0.04, height - 0.014, 0.014], [x * (width / 2 - 0.022), (height - 0.014) / 2, z * (depth / 2)]));
  }
  for (const x of [-1, 1])
    parts.push(plank(`end ${x}`, [0.012, height - 0.03, depth - 0.03], [x * (width / 2 - 0.008), (height - 0.03) / 2, 0]));
  return writeModel(parts);
}

/** A rubber ball in two colors with a band. */
export function makeBall(): Promise<Uint8Array> {
  const texture = drawTexture(128, 64, (u, v) => {
    if (Math.abs(v - 0.5) < 0.07) return CREAM;
    return v > 0.5 === Math.floor(u * 8) % 2 < 1 ? RED : mix(RED, [0.25, 0.02, 0.03], 0.55);
  });
  return writeModel([
    {
      name: 'ball',
      geometry: new SphereGeometry(BALL_RADIUS_M, 32, 20),
      paint: { name: 'rubber', color: [1, 1, 1], roughness: 0.5, texture },
    },
  ]);
}
