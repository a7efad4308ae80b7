import { encodeFilm, type FilmImage } from './encode-film.ts';

const BALL = { sidePx: 96, images: 24, framesPerS: 12 } as const;
/** BT.601 of a warm orange: about sRGB (255, 139, 60). */
const ORANGE = { y: 158, u: 76, v: 185 };

/** Two seconds of a pulsing ball with a soft edge on a transparent background. */
export async function makeBall(): Promise<number[]> {
  const { sidePx, images, framesPerS } = BALL;
  const bytes = await encodeFilm({
    widthPx: sidePx,
    heightPx: sidePx,
    framesPerS,
    keyEvery: framesPerS,
    bitrate: 150_000,
    images: Array.from({ length: images }, (_, i) => ball(Math.sin((2 * Math.PI * i) / images))),
  });
  return [...bytes];
}

function ball(swell: number): FilmImage {
  const { sidePx } = BALL;
  const radiusPx = 30 + 10 * swell;
  const alpha = new Uint8Array(sidePx * sidePx);
  for (let i = 0; i < alpha.length; i++) {
    const awayPx = Math.hypot((i % sidePx) + 0.5 - sidePx / 2, Math.floor(i / sidePx) + 0.5 - sidePx / 2);
    alpha[i] = 255 * Math.min(1, Math.max(0, (radiusPx - awayPx) / 4));
  }
  const plane = (value: number, length: number): Uint8Array => new Uint8Array(length).fill(value);
  const quarter = alpha.length / 4;
  return { y: plane(ORANGE.y, alpha.length), u: plane(ORANGE.u, quarter), v: plane(ORANGE.v, quarter), alpha };
}

const STRIPES = {
  widthPx: 160,
  heightPx: 90,
  images: 24,
  framesPerS: 12,
  /** Period of the rainbow along x and along y. */ periodPx: 60,
} as const;

/** Diagonal rainbows that move by their width in two seconds, in a seamless loop. */
export async function makeStripes(): Promise<number[]> {
  const { widthPx, heightPx, images, framesPerS } = STRIPES;
  const bytes = await encodeFilm({
    widthPx,
    heightPx,
    framesPerS,
    keyEvery: framesPerS,
    bitrate: 200_000,
    images: Array.from({ length: images }, (_, i) => stripes(i / images)),
  });
  return [...bytes];
}

function stripes(turn: number): FilmImage {
  const { widthPx, heightPx, periodPx } = STRIPES;
  const hueAt = (x: number, y: number): number => 2 * Math.PI * ((x + (heightPx - y)) / periodPx - turn);
  const luma = new Uint8Array(widthPx * heightPx);
  for (let i = 0; i < luma.length; i++) luma[i] = 125 + 25 * Math.cos(2 * hueAt((i % widthPx) + 0.5, Math.floor(i / widthPx) + 0.5));
  const chroma = (shift: number): Uint8Array => {
    const plane = new Uint8Array(luma.length / 4);
    for (let i = 0; i < plane.length; i++) {
      const [x, y] = [(i % (widthPx / 2)) * 2 + 1, Math.floor(i / (widthPx / 2)) * 2 + 1];
      plane[i] = 128 + 60 * Math.cos(hueAt(x, y) + shift);
    }
    return plane;
  };
  return { y: luma, u: chroma(0), v: chroma(Math.PI / 2) };
}
