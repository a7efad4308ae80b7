import { encode } from 'fast-png';

/** A picture of the page: for those who link to it, and, where it was drawn from the project, while the page loads. */
export interface PosterPicture {
  readonly type: 'jpg' | 'png';
  readonly bytes: Uint8Array;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Shows what the page shows. */
  readonly drawn: boolean;
}

/** What those who show links expect: 1.91 to 1. */
export const POSTER_SIZE = { widthPx: 1200, heightPx: 630 } as const;

/** Soft as it is, it needs no more: 120 kB instead of 290. */
const NEUTRAL_SIZE = { widthPx: 600, heightPx: 315 } as const;

/** Red, green and blue of the page's background, dark and light, and of its accent; sRGB. */
const CHANNELS = [
  [20, 66, 255],
  [22, 70, 207],
  [26, 80, 92],
] as const;
const FOLDS = 9;

/** Where nothing can draw the project: a cloth in folds with a light behind it, the same for every page. */
export function neutralPoster(): PosterPicture {
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
