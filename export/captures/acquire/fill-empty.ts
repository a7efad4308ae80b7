/**
 * Fills the colors of transparent pixels from the opaque ones around them, and divides the others by their alpha, so that neither a linear
 * sampler nor the blocks of a JPEG file bring the background into the edge of an object. Alpha stays. Push–pull: means over ever larger
 * blocks fill what smaller ones leave (Gortler et al., “The Lumigraph”, SIGGRAPH 1996, §3.4).
 *
 * @param pixels Premultiplied RGBA, 8 bits.
 * @returns RGBA with straight alpha.
 */
export function fillEmpty(pixels: Uint8Array, widthPx: number, heightPx: number): Uint8Array {
  const straight = Uint8Array.from(pixels);
  if (!pixels.some((value, i) => i % 4 === 3 && value < 255)) return straight;
  const levels: Level[] = [];
  for (let level: Level = { widthPx, heightPx, sums: pixels }; level.widthPx > 1 || level.heightPx > 1; ) {
    level = halved(level);
    levels.push(level);
  }
  // From the coarsest level down: what a level does not have comes from the coarser one.
  for (let i = levels.length - 2; i >= 0; i--) {
    const [fine, coarse] = [levels[i], levels[i + 1]];
    if (fine && coarse) pull(fine, coarse);
  }
  const [half] = levels;
  for (let i = 0; i < straight.length; i += 4) {
    const isEmpty = pixels[i + 3] === 0;
    const [column, row] = [(i >> 2) % widthPx, Math.floor((i >> 2) / widthPx)];
    const from = isEmpty && half ? 4 * ((row >> 1) * half.widthPx + (column >> 1)) : i;
    const sums = isEmpty && half ? half.sums : pixels;
    const alpha = sums[from + 3] ?? 0;
    for (let c = 0; c < 3; c++) straight[i + c] = alpha > 0 ? Math.min(255, Math.round((255 * (sums[from + c] ?? 0)) / alpha)) : 0;
  }
  return straight;
}

/** RGBA: sums of premultiplied colors and of alphas, in which 255 is opaque. */
interface Level {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly sums: Float32Array | Uint8Array;
}

function halved({ widthPx, heightPx, sums }: Level): Level {
  const [width, height] = [Math.ceil(widthPx / 2), Math.ceil(heightPx / 2)];
  const half = new Float32Array(4 * width * height);
  for (let row = 0; row < heightPx; row++) {
    for (let column = 0; column < widthPx; column++) {
      const to = 4 * ((row >> 1) * width + (column >> 1));
      const from = 4 * (row * widthPx + column);
      for (let c = 0; c < 4; c++) half[to + c] = (half[to + c] ?? 0) + (sums[from + c] ?? 0);
    }
  }
  return { widthPx: width, heightPx: height, sums: half };
}

function pull({ widthPx, heightPx, sums }: Level, coarse: Level): void {
  for (let row = 0; row < heightPx; row++) {
    for (let column = 0; column < widthPx; column++) {
      const at = 4 * (row * widthPx + column);
      if ((sums[at + 3] ?? 0) > 0) continue;
      const from = 4 * ((row >> 1) * coarse.widthPx + (column >> 1));
      for (let c = 0; c < 4; c++) sums[at + c] = coarse.sums[from + c] ?? 0;
    }
  }
}
