import sharp from 'sharp';

/** An image of an animation, as PNG, and how long it is shown. */
export interface AnimationFrame {
  readonly png: Uint8Array;
  readonly ms: number;
}

/**
 * Encodes an animated WebP that loops forever. WebP and not GIF: the images have more than 256 colors, and the file is a third of the size.
 *
 * @param quality 0 to 100.
 */
export async function encodeAnimation(frames: readonly AnimationFrame[], widthPx: number, quality: number): Promise<Uint8Array> {
  const small = await Promise.all(frames.map(({ png }) => sharp(png).resize({ width: widthPx }).png().toBuffer()));
  return sharp(small, { join: { animated: true } })
    .webp({ quality, effort: 6, loop: 0, delay: frames.map(({ ms }) => ms), smartSubsample: true })
    .toBuffer();
}
