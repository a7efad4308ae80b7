import { encode } from 'fast-png';

/** An image of the page for link previews. If it was drawn from the project, it is also shown while the page loads. */
export interface PosterImage {
  readonly type: 'jpg' | 'png';
  readonly bytes: Uint8Array;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Whether it was drawn from the project. */
  readonly drawn: boolean;
}

/** The size that link previews expect, 1.91 to 1. */
export const POSTER_SIZE = { widthPx: 1200, heightPx: 630 } as const;

/** A blurred image needs no more pixels: 120 kB instead of 290. */
const NEUTRAL_SIZE = { widthPx: 600, heightPx: 315 } as const;

/** Red, green and blue of the page's dark and light background and of its accent; sRGB. */
const CHANNELS = [
  [20, 66, 255],
  [22, 70, 207],
  [26, 80, 92],
] as const;
const FOLDS = 9;

/** The poster if the project cannot be drawn: folds of a cloth with light behind it, the same for every page. */
export function neutralPoster(): PosterImage {
  const { widthPx, heightPx } = NEUTRAL_SIZE;
  const bell = (offset: number, width: number) => Math.exp(-((offset / width) ** 2));
  const across = Array.from({ length: widthPx }, (_, x) => {
    const u = x / widthPx;
    return { fold: 0.5 + 0.5 * Math.cos((u + 0.012 * Math.sin(u * 41)) * FOLDS * 2 * Math.PI), glow: bell(u - 0.5, 0.3) };
  });
  const data = new Uint8Array(widthPx * heightPx * 3);
  let at = 0;
  for (let y = 0; y < heightPx; y++) {
    const glowY = bell(y / heightPx - 0.56, 0.5);
    for (const { fold, glow } of across) {
      const cloth = (0.25 + 0.75 * fold) * (0.35 + 0.65 * glow * glowY);
      const light = glow * glowY * (0.15 + 0.27 * fold);
      for (const [dark, pale, warm] of CHANNELS) {
        const gray = dark + (pale - dark) * cloth;
        data[at++] = Math.round(gray + (warm - gray) * light);
      }
    }
  }
  return { type: 'png', bytes: encode({ width: widthPx, height: heightPx, data, channels: 3, depth: 8 }), widthPx, heightPx, drawn: false };
}
