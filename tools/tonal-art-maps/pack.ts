import type { TonalArtMaps } from './make-maps.ts';
import type { Ink } from './strokes.ts';

/** Number of gray steps. So few make the files half as large, and the difference is invisible between strokes. */
const GRAYS = 15;

/**
 * Packs three tones into the red, green and blue channel of one image with white paper. It contains all sizes side by side, down to one
 * pixel; sizes that were not drawn are means of the next larger size.
 */
export function packTones({ sidesPx, ink }: TonalArtMaps, tones: readonly number[]) {
  const [largest = 1] = sidesPx;
  const width = 2 * largest - 1;
  const data = new Uint8Array(width * largest * 3).fill(255);
  for (const [channel, tone] of tones.entries()) {
    let left = 0;
    let last: Ink = new Float32Array(1);
    for (let side = largest, size = 0; side >= 1; side >>= 1, size++) {
      last = ink[tone]?.[size] ?? halved(last, side * 2);
      for (let y = 0; y < side; y++) {
        for (let x = 0; x < side; x++) {
          const gray = Math.round((1 - (last[y * side + x] ?? 0)) * GRAYS) / GRAYS;
          data[(y * width + left + x) * 3 + channel] = Math.round(gray * 255);
        }
      }
      left += side;
    }
  }
  return { width, height: largest, data, channels: 3, depth: 8 } as const;
}

function halved(ink: Ink, sidePx: number): Ink {
  const half = sidePx / 2;
  return Float32Array.from({ length: half * half }, (_, i) => {
    const at = Math.floor(i / half) * 2 * sidePx + (i % half) * 2;
    return ((ink[at] ?? 0) + (ink[at + 1] ?? 0) + (ink[at + sidePx] ?? 0) + (ink[at + sidePx + 1] ?? 0)) / 4;
  });
}
