import { encode } from 'fast-png';

const WIDTH_PX = 480;
const HEIGHT_PX = 360;
/** Distance between neighboring strokes. */
const PITCH_PX = 7;
/** Length of strokes. */
const LENGTH_PX = 90;
const INK = [38, 34, 40] as const;

/**
 * A transparent image of loose pencil strokes as PNG with straight alpha. Strokes are slightly bent and vary in length and position.
 */
export function makeStrokes(): Uint8Array {
  const next = createChance();
  const alpha = new Float32Array(WIDTH_PX * HEIGHT_PX);
  const reach = WIDTH_PX + HEIGHT_PX;
  for (let across = -HEIGHT_PX; across < reach; across += PITCH_PX) {
    for (let along = -next() * LENGTH_PX; along < reach; along += LENGTH_PX * (0.7 + 0.5 * next())) {
      drawStroke(alpha, across + 3 * (next() - 0.5), along, LENGTH_PX * (0.8 + 0.5 * next()), next);
    }
  }
  const data = new Uint8Array(alpha.length * 4);
  for (let i = 0; i < alpha.length; i++) data.set([...INK, Math.round(255 * Math.min(alpha[i] ?? 0, 0.95))], i * 4);
  return encode({ width: WIDTH_PX, height: HEIGHT_PX, data, channels: 4 });
}

/** Repeatable random numbers in [0, 1) (Lehmer 1951, with the factor of Park and Miller 1988). */
function createChance(): () => number {
  let state = 20_071;
  return () => {
    state = (state * 48_271) % 2_147_483_647;
    return state / 2_147_483_647;
  };
}

/** Draws a stroke along the diagonal, thin at both ends. */
function drawStroke(alpha: Float32Array, across: number, along: number, lengthPx: number, next: () => number): void {
  const bend = 5 * (next() - 0.5);
  const tilt = 0.08 * (next() - 0.5);
  const weight = 0.55 + 0.4 * next();
  for (let t = 0; t < lengthPx; t += 0.5) {
    const part = t / lengthPx;
    const thin = Math.min(1, 6 * Math.min(part, 1 - part));
    const off = across + bend * Math.sin(Math.PI * part) + tilt * t;
    const x = (along + t + off) * Math.SQRT1_2;
    const y = (off - along - t) * Math.SQRT1_2 + HEIGHT_PX;
    dot(alpha, x, y, 0.9 * thin, weight * thin);
  }
}

function dot(alpha: Float32Array, x: number, y: number, radiusPx: number, weight: number): void {
  for (let py = Math.floor(y - 1); py <= Math.ceil(y + 1); py++) {
    for (let px = Math.floor(x - 1); px <= Math.ceil(x + 1); px++) {
      if (px < 0 || py < 0 || px >= WIDTH_PX || py >= HEIGHT_PX) continue;
      const cover = Math.min(Math.max(radiusPx + 0.5 - Math.hypot(px - x, py - y), 0), 1) * weight;
      const at = py * WIDTH_PX + px;
      alpha[at] = Math.max(alpha[at] ?? 0, cover);
    }
  }
}
