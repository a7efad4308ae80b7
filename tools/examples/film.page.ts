import { encodeFilm, type FilmPicture } from './encode-film.ts';

const SIDE_PX = 96;
const PICTURES = 24;
const PICTURES_PER_S = 12;
/** BT.601 of a warm orange: about sRGB (255, 139, 60). */
const ORANGE = { y: 158, u: 76, v: 185 };

/** A ball of two seconds that swells and shrinks, with a soft edge; nothing around it. */
export async function makeFilm(): Promise<number[]> {
  const pictures = Array.from({ length: PICTURES }, (_, i) => picture(Math.sin((2 * Math.PI * i) / PICTURES)));
  const bytes = await encodeFilm({
    widthPx: SIDE_PX,
    heightPx: SIDE_PX,
    picturesPerS: PICTURES_PER_S,
    keyEvery: PICTURES_PER_S,
    bitrate: 150_000,
    pictures,
  });
  return [...bytes];
}

function picture(swell: number): FilmPicture {
  const radiusPx = 30 + 10 * swell;
  const alpha = new Uint8Array(SIDE_PX * SIDE_PX);
  for (let i = 0; i < alpha.length; i++) {
    const awayPx = Math.hypot((i % SIDE_PX) + 0.5 - SIDE_PX / 2, Math.floor(i / SIDE_PX) + 0.5 - SIDE_PX / 2);
    alpha[i] = 255 * Math.min(1, Math.max(0, (radiusPx - awayPx) / 4));
  }
  const plane = (value: number, length: number): Uint8Array => new Uint8Array(length).fill(value);
  const quarter = alpha.length / 4;
  return { y: plane(ORANGE.y, alpha.length), u: plane(ORANGE.u, quarter), v: plane(ORANGE.v, quarter), alpha };
}
