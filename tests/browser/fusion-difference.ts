/** What differs between two images. */
export interface Difference {
  /** Channels of pixels that differ, and by how many of 255 steps at most. */
  readonly differing: number;
  readonly most: number;
  readonly channels: number;
  /** The fraction of channels that are neither 0 nor 255: an image without any tests nothing. */
  readonly tones: number;
}

/** Compares the bytes of two images of the same size. */
export function difference(a: Uint8Array, b: Uint8Array): Difference {
  let differing = 0;
  let most = 0;
  let tones = 0;
  for (let i = 0; i < a.length; i++) {
    const value = a[i] ?? 0;
    const apart = Math.abs(value - (b[i] ?? 0));
    if (apart > 0) differing++;
    if (apart > most) most = apart;
    if (value > 0 && value < 255) tones++;
  }
  return { differing, most, channels: a.length, tones: tones / a.length };
}
