import sharp from 'sharp';

export interface FilmFrame {
  readonly png: Uint8Array;
  readonly ms: number;
}

const WIDTH_PX = 900;
/** Node texts stay readable; 25 frames take about 500 kB. */
const QUALITY = 60;

/** An animated WebP that loops forever. WebP and not GIF: the preview has more than 256 colors, and the file is a third of the size. */
export async function encodeFilm(frames: readonly FilmFrame[]): Promise<Uint8Array> {
  const small = await Promise.all(frames.map(({ png }) => sharp(png).resize({ width: WIDTH_PX }).png().toBuffer()));
  return sharp(small, { join: { animated: true } })
    .webp({ quality: QUALITY, effort: 6, loop: 0, delay: frames.map(({ ms }) => ms), smartSubsample: true })
    .toBuffer();
}
