/** The light at a pixel, by three.js' own materials and by hand: 1 is the luminance of white. */
export interface Lit {
  /** Luminance of a white matte surface. */
  readonly received: number;
  /** The same if it faced all light. */
  readonly onWhite: number;
  /** Cosine between the normal and the strongest light, times the part of it that is not in shadow. */
  readonly facing: number;
}

const luminance = (r: number, g: number, b: number): number => 0.2126 * r + 0.7152 * g + 0.0722 * b;
const mix = (a: number, b: number, t: number): number => a + (b - a) * t;
const clamp = (value: number): number => Math.min(Math.max(value, 0), 1);

/** sRGB to linear of 0 to 1; IEC 61966-2-1. */
export function linear(c: number): number {
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
}

const grayOf = (r: number, g: number, b: number): number => luminance(linear(r), linear(g), linear(b));

function smoothstep(from: number, to: number, x: number): number {
  const t = clamp((x - from) / (to - from));
  return t * t * (3 - 2 * t);
}

/** Luminance that each style asks for on a white object, by its params' defaults. */
export const ASKED: Readonly<Record<string, (lit: Lit) => number>> = {
  toon: ({ received, onWhite }) => {
    const brightest = Math.min(onWhite, 1);
    const step = Math.min(Math.floor(Math.min(Math.min(received, 1) / brightest, 1) * 3), 2);
    return brightest * mix(0.25, 1, step / 2);
  },
  hatching: ({ received }) => mix(grayOf(0.09, 0.08, 0.12), grayOf(0.97, 0.95, 0.9), clamp(received) ** (0.95 / 1.05)),
  charcoal: ({ received }) => {
    const [bright, dark] = [clamp(received) ** 1.8, (1 - clamp(received)) ** 1.8];
    return mix(grayOf(0.1, 0.09, 0.09), grayOf(0.95, 0.93, 0.88), bright / (bright + dark));
  },
  gooch: ({ onWhite, facing }) => {
    const cool = grayOf(0.1, 0.2, 0.75) + 0.25;
    const warm = grayOf(0.85, 0.7, 0.15) + 0.5;
    return Math.min(onWhite, 1) * mix(cool, warm, 0.5 + 0.5 * facing);
  },
  'loose-lines': ({ received, onWhite }) => {
    const brightest = Math.min(onWhite, 1);
    const light = smoothstep(0.05, 0.75, clamp(received) / brightest);
    return grayOf(1, 0.98, 0.94) * mix(0.6, 1, light) * brightest;
  },
  custom: ({ received }) => clamp(received),
  brick: ({ received }) => clamp(received),
};
