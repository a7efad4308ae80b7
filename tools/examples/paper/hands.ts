import { encode } from 'fast-png';

const WIDTH_PX = 560;
const HEIGHT_PX = 350;
/** Antialiasing: samples along each side of a pixel. */
const SAMPLES = 2;

type Color = readonly [r: number, g: number, b: number];

/** Ends of a limb with their radii, in palm widths; y up, wrist at 0. */
type Limb = readonly [x0: number, y0: number, r0: number, x1: number, y1: number, r1: number];

const HAND: readonly Limb[] = [
  [-0.24, 0.08, 0.22, -0.29, 0.56, 0.17],
  [-0.07, 0.05, 0.24, -0.09, 0.64, 0.17],
  [0.1, 0.05, 0.24, 0.12, 0.6, 0.17],
  [0.24, 0.08, 0.2, 0.3, 0.46, 0.15],
  [-0.29, 0.58, 0.14, -0.42, 1.2, 0.1],
  [-0.09, 0.66, 0.14, -0.11, 1.38, 0.105],
  [0.12, 0.62, 0.14, 0.2, 1.28, 0.1],
  [0.3, 0.48, 0.12, 0.48, 0.98, 0.085],
  [-0.28, 0.1, 0.18, -0.6, 0.46, 0.13],
  [-0.6, 0.46, 0.13, -0.76, 0.78, 0.105],
  [0, 0.05, 0.3, 0, -1.4, 0.3],
];

const SLEEVE: readonly Limb[] = [[0, -0.85, 0.42, 0, -2.6, 0.52]];

interface Arm {
  /** Position of the wrist as fractions of width and height, from the top left. */
  readonly x: number;
  readonly y: number;
  /** Width of the palm in pixels. */
  readonly sizePx: number;
  readonly turnRad: number;
  /** 1 for a right hand, -1 for a left hand. */
  readonly side: 1 | -1;
  readonly skin: Color;
  readonly cloth: Color;
}

/** Skin from light to dark, as hands have it in daylight. */
const ARMS: readonly Arm[] = [
  { x: 0.15, y: 0.72, sizePx: 76, turnRad: 0.16, side: 1, skin: [238, 196, 168], cloth: [52, 82, 140] },
  { x: 0.385, y: 0.62, sizePx: 82, turnRad: -0.1, side: -1, skin: [206, 152, 112], cloth: [236, 236, 230] },
  { x: 0.62, y: 0.73, sizePx: 76, turnRad: 0.1, side: 1, skin: [158, 104, 70], cloth: [60, 116, 88] },
  { x: 0.85, y: 0.63, sizePx: 80, turnRad: -0.16, side: -1, skin: [104, 66, 46], cloth: [120, 132, 160] },
];

/** Direction of the light: from the upper left; x right, y up, z toward the viewer. */
const LIGHT = [-0.42, 0.48, 0.77] as const;

/** Four raised hands in front of a wall with a window and a plant, as opaque PNG. */
export function makeHands(): Uint8Array {
  const data = new Uint8Array(WIDTH_PX * HEIGHT_PX * 4);
  for (let y = 0; y < HEIGHT_PX; y++) {
    for (let x = 0; x < WIDTH_PX; x++) {
      const sum = [0, 0, 0];
      for (let i = 0; i < SAMPLES ** 2; i++) {
        const color = colorAt(x + ((i % SAMPLES) + 0.5) / SAMPLES, y + (Math.floor(i / SAMPLES) + 0.5) / SAMPLES);
        color.forEach((value, channel) => {
          sum[channel] = (sum[channel] ?? 0) + value / SAMPLES ** 2;
        });
      }
      data.set([...sum.map((value) => Math.round(Math.min(Math.max(value, 0), 255))), 255], (y * WIDTH_PX + x) * 4);
    }
  }
  return encode({ width: WIDTH_PX, height: HEIGHT_PX, data, channels: 4 });
}

function colorAt(x: number, y: number): Color {
  for (const arm of ARMS) {
    const at = (dx: number, dy: number) => placeOn(arm, x + dx, y + dy);
    for (const [limbs, color] of [
      [SLEEVE, arm.cloth],
      [HAND, arm.skin],
    ] as const) {
      const [u, v] = at(0, 0);
      const height = heightOf(limbs, u, v);
      if (height <= 0) continue;
      const [ru, rv] = at(0.75, 0);
      const [du, dv] = at(0, 0.75);
      const slope = arm.sizePx / 0.75;
      const normalX = (height - heightOf(limbs, ru, rv)) * slope;
      const normalY = (heightOf(limbs, du, dv) - height) * slope;
      const length = Math.hypot(normalX, normalY, 1);
      const facing = Math.max((normalX * LIGHT[0] + normalY * LIGHT[1] + LIGHT[2]) / length, 0);
      return shaded(color, 0.56 + 0.48 * facing);
    }
  }
  return wallAt(x / WIDTH_PX, y / HEIGHT_PX);
}

/** Converts a pixel to a position on the upright hand, in palm widths from the wrist. */
function placeOn({ x, y, sizePx, turnRad, side }: Arm, px: number, py: number): readonly [u: number, v: number] {
  const right = (px - x * WIDTH_PX) / sizePx;
  const up = (y * HEIGHT_PX - py) / sizePx;
  const cos = Math.cos(turnRad);
  const sin = Math.sin(turnRad);
  return [side * (right * cos - up * sin), right * sin + up * cos];
}

/** Height of the rounded body at a position. Limbs that meet blend into each other. */
function heightOf(limbs: readonly Limb[], u: number, v: number): number {
  let height = 0;
  for (const [x0, y0, r0, x1, y1, r1] of limbs) {
    const along = Math.min(Math.max(((u - x0) * (x1 - x0) + (v - y0) * (y1 - y0)) / ((x1 - x0) ** 2 + (y1 - y0) ** 2), 0), 1);
    const radius = r0 + (r1 - r0) * along;
    const distance = Math.hypot(u - x0 - (x1 - x0) * along, v - y0 - (y1 - y0) * along);
    if (distance < radius) height = blend(height, Math.sqrt(radius * radius - distance * distance));
  }
  return height;
}

/** A smooth maximum of two heights. */
function blend(a: number, b: number): number {
  const share = Math.max(0.06 - Math.abs(a - b), 0) / 0.06;
  return Math.max(a, b) + share * share * 0.015;
}

/** A blue-green wall, lit by a window, with leaves of a plant. Nothing has the color of skin. */
function wallAt(u: number, v: number): Color {
  const light = 1.12 - 0.4 * Math.hypot(u - 0.2, v - 0.1);
  const [wu, wv] = [u - 0.5, v - 0.02];
  if (Math.abs(wu) < 0.11 && wv < 0.3) {
    const isFrame = Math.abs(wu) > 0.1 || Math.abs(wu) < 0.006 || wv > 0.285;
    return isFrame ? [238, 242, 244] : [164 + 60 * v, 204 + 30 * v, 240];
  }
  for (let leaf = 0; leaf < 9; leaf++) {
    const turn = -1.25 + leaf * 0.31;
    const [du, dv] = [(u - 0.985) * 1.6, v - 0.62];
    const along = -du * Math.cos(turn) - dv * Math.sin(turn);
    const across = -du * Math.sin(turn) + dv * Math.cos(turn);
    const wide = 0.045 * Math.sin(Math.PI * Math.min(Math.max(along / 0.42, 0), 1));
    if (along > 0 && along < 0.42 && Math.abs(across) < wide) return shaded([58, 132, 76], 0.8 + 0.5 * (across / 0.045) + 0.1 * (leaf % 2));
  }
  if (v > 0.9) return shaded([64, 92, 104], light);
  return shaded([112, 164, 170], light);
}

function shaded([r, g, b]: Color, light: number): Color {
  return [r * light, g * light, b * light];
}
