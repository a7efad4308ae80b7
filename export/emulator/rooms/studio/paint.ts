import { fractal, hash, noise } from './noise.ts';

/** Display-referred sRGB in [0, 1]. */
export type Color = readonly [number, number, number];

/** Color of a texture at (u, v) in [0, 1), u to the right and v up. */
export type Painter = (u: number, v: number) => Color;

export function mix(a: Color, b: Color, t: number): Color {
  return [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t];
}

export function scale(color: Color, factor: number): Color {
  return [color[0] * factor, color[1] * factor, color[2] * factor];
}

export function step(edge0: number, edge1: number, x: number): number {
  const t = Math.min(Math.max((x - edge0) / (edge1 - edge0), 0), 1);
  return t * t * (3 - 2 * t);
}

/** Boards along v with random tone, offset and grain, and dark joints. */
export const oakBoards: Painter = (u, v) => {
  const boards = 8;
  const board = Math.floor(u * boards);
  const across = u * boards - board;
  const along = v * 2 + hash(board, 7, 11);
  const piece = Math.floor(along);
  const within = along - piece;
  const tone = hash(board, piece % 2, 3);
  const grain = fractal(across * 3 + board * 5, within * 2 + piece * 3 + tone * 8, 64, 64, 21);
  const streak = noise(across * 22 + grain * 3, within * 3, 512, 64, board * 2 + (piece % 2));
  const color = mix([0.72, 0.55, 0.38], [0.53, 0.37, 0.24], 0.25 * tone + 0.45 * grain + 0.25 * streak);
  const joint = Math.min(across, 1 - across) * 0.14 < 0.0022 || Math.min(within, 1 - within) * 1.12 < 0.002 ? 0.5 : 1;
  return scale(color, joint * (0.93 + 0.14 * tone));
};

export const walnut: Painter = (u, v) => {
  const bend = fractal(u * 3, v * 6, 3, 6, 31);
  const ring = 0.5 + 0.5 * Math.sin((u * 6 + bend * 2.2) * Math.PI * 2);
  const fiber = noise(u * 90, v * 6, 90, 6, 33);
  return mix([0.42, 0.28, 0.19], [0.27, 0.17, 0.11], 0.55 * ring + 0.4 * fiber * bend);
};

export const plaster: Painter = (u, v) => scale([0.9, 0.88, 0.84], 0.98 + 0.03 * fractal(u * 12, v * 12, 12, 12, 41));

/** Wallpaper: thin crossing lines with a small diamond in every other field. */
export const wallpaper: Painter = (u, v) => {
  const [x, y] = [u * 4, v * 4];
  const a = Math.abs(((x + y) % 1) - 0.5);
  const b = Math.abs(((((x - y) % 1) + 1) % 1) - 0.5);
  const line = 1 - step(0.018, 0.032, Math.min(a, b));
  const diamond = 1 - step(0.1, 0.115, Math.abs((x % 1) - 0.5) + Math.abs((y % 1) - 0.5));
  const ground = scale([0.5, 0.57, 0.53], 0.97 + 0.05 * fractal(u * 16, v * 16, 16, 16, 43));
  return mix(ground, [0.72, 0.74, 0.66], 0.55 * Math.max(line, diamond));
};

/** A woven cloth of the given color. */
export function weave(color: Color, contrast: number, seed: number): Painter {
  const threads = 26;
  return (u, v) => {
    const [x, y] = [u * threads, v * threads];
    const over = (Math.floor(x) + Math.floor(y)) % 2 === 0;
    const ridge = Math.sin(Math.PI * ((over ? x : y) % 1));
    const thread = hash(Math.floor(over ? y : x), over ? 1 : 2, seed);
    return scale(color, 1 - contrast + contrast * (0.65 * ridge + 0.55 * thread));
  };
}

/** Stripes of two colors over a weave. */
export function stripes(a: Color, b: Color, count: number, seed: number): Painter {
  const cloth = weave([1, 1, 1], 0.25, seed);
  return (u, v) => {
    const [shade] = cloth(u, v);
    return scale((v * count) % 1 < 0.5 ? a : b, shade);
  };
}

export function triangles(a: Color, b: Color, count: number, seed: number): Painter {
  const cloth = weave([1, 1, 1], 0.2, seed);
  return (u, v) => {
    const [shade] = cloth(u, v);
    const row = Math.floor(v * count);
    const up = (v * count - row) * 0.5;
    const across = Math.abs(((u * count + (row % 2) * 0.5) % 1) - 0.5);
    return scale(across < 0.5 - up - 0.06 ? a : b, shade);
  };
}

/** A rug: border, bands and rows of lozenges, woven. */
export const rug: Painter = (u, v) => {
  const cream: Color = [0.86, 0.81, 0.7];
  const red: Color = [0.6, 0.27, 0.2];
  const navy: Color = [0.2, 0.26, 0.36];
  const knot = 0.86 + 0.18 * hash(Math.floor(u * 260), Math.floor(v * 180), 51);
  const edge = Math.min(u * 1.5, (1 - u) * 1.5, v, 1 - v);
  if (edge < 0.035) return scale(navy, knot);
  if (edge < 0.05) return scale(cream, knot);
  if (edge < 0.11) return scale((u * 24 + v * 16) % 1 < 0.5 ? red : cream, knot);
  if (edge < 0.125) return scale(navy, knot);
  const [x, y] = [u * 9, v * 6];
  const lozenge = Math.abs((x % 1) - 0.5) + Math.abs((y % 1) - 0.5);
  const field = (Math.floor(x) + Math.floor(y)) % 2 === 0 ? red : navy;
  return scale(lozenge < 0.16 ? cream : lozenge < 0.34 ? field : lozenge < 0.42 ? cream : [0.74, 0.64, 0.5], knot);
};

/** Abstract hills under a sun, in flat colors. */
export const imageOfHills: Painter = (u, v) => {
  if (Math.min(u, 1 - u, v, 1 - v) < 0.1) return [0.93, 0.92, 0.88];
  const ridge = (height: number, seed: number): number => height + 0.13 * fractal(u * 4, seed, 64, 64, seed) - 0.06;
  if (v < ridge(0.28, 61)) return [0.18, 0.29, 0.31];
  if (v < ridge(0.42, 62)) return [0.33, 0.46, 0.43];
  if (v < ridge(0.55, 63)) return [0.6, 0.66, 0.56];
  if (Math.hypot(u - 0.62, (v - 0.72) * 1.25) < 0.11) return [0.86, 0.45, 0.26];
  return mix([0.93, 0.8, 0.62], [0.86, 0.87, 0.83], step(0.5, 0.9, v));
};

/** Overlapping discs and a line. */
export const imageOfDiscs: Painter = (u, v) => {
  if (Math.min(u, 1 - u, v, 1 - v) < 0.1) return [0.93, 0.92, 0.88];
  const disc = (x: number, y: number, r: number): boolean => Math.hypot(u - x, (v - y) * 1.25) < r;
  if (Math.abs(v - 0.3 - 0.3 * u) < 0.008) return [0.15, 0.16, 0.18];
  if (disc(0.42, 0.44, 0.2) && disc(0.58, 0.6, 0.17)) return [0.45, 0.22, 0.16];
  if (disc(0.42, 0.44, 0.2)) return [0.78, 0.56, 0.24];
  if (disc(0.58, 0.6, 0.17)) return [0.24, 0.36, 0.42];
  return [0.88, 0.85, 0.78];
};

/** The view through the window: sky, trees and a lawn, bright and blurred. */
export const outdoors: Painter = (u, v) => {
  const trees = 0.34 + 0.16 * fractal(u * 5, 3, 5, 64, 71);
  const sky = mix([0.93, 0.96, 1], [0.78, 0.88, 1], step(0.4, 1, v));
  const leaves = mix([0.55, 0.66, 0.45], [0.72, 0.8, 0.6], fractal(u * 9, v * 9, 9, 9, 73));
  return mix(mix([0.75, 0.82, 0.58], leaves, step(0.12, 0.22, v)), sky, step(trees - 0.05, trees + 0.05, v));
};

export const leaf: Painter = (u, v) => {
  const rib = Math.abs(u - 0.5);
  const vein = Math.abs(((v * 9 - rib * 6) % 1) - 0.5) < 0.06 ? 1.15 : 1;
  return scale(mix([0.2, 0.38, 0.2], [0.36, 0.52, 0.28], step(0, 0.5, rib)), rib < 0.03 ? 1.35 : vein);
};

export const plain: Painter = () => [1, 1, 1];
