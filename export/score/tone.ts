import type { Sum } from './mean-of.ts';
import { type ImagePixels, lumaOf, smoothed } from './smooth.ts';

/**
 * The difference between the tones of two images of one size, in steps of 8 bits: of the luma, smoothed over squares of 2 · `radiusPx` + 1
 * pixels, so that strokes count by the tone that they give together.
 *
 * @param counts Whether a pixel counts, row-major. The others are left out of the smoothing, too.
 */
export function toneError(styled: ImagePixels, reference: ImagePixels, counts: ArrayLike<number | boolean>, radiusPx: number): Sum {
  const { widthPx, heightPx } = styled;
  const [a, b] = [lumaOf(styled), lumaOf(reference)];
  const difference = a.map((value, i) => (counts[i] ? value - (b[i] ?? 0) : 0));
  const weights = smoothed(
    a.map((_, i) => (counts[i] ? 1 : 0)),
    widthPx,
    heightPx,
    radiusPx,
  );
  const smooth = smoothed(difference, widthPx, heightPx, radiusPx);
  let [sum, count] = [0, 0];
  for (let i = 0; i < a.length; i++) {
    if (!counts[i]) continue;
    sum += Math.abs((smooth[i] ?? 0) / (weights[i] ?? 1));
    count++;
  }
  return { sum, count };
}
