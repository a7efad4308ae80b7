import { type WebmFrame, writeWebm } from './write-webm.ts';

/** A frame of a video: Y, U and V as the codec takes them (BT.601, video range), and alpha in [0, 255]; rows from the top. */
export interface FilmPicture {
  readonly y: Uint8Array;
  readonly u: Uint8Array;
  readonly v: Uint8Array;
  readonly alpha?: Uint8Array;
}

export interface Film {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly picturesPerS: number;
  /** Interval of key frames. */
  readonly keyEvery: number;
  readonly bitrate: number;
  readonly pictures: readonly FilmPicture[];
  /** Whether the file states its duration. */
  readonly timed?: boolean;
}

/** VP9 profile 0, level 1, eight bits, which all browsers play. */
const CODEC = 'vp09.00.10.08';

/** Encodes a WebM video with WebCodecs in a browser, with alpha if the frames have it. */
export async function encodeFilm(film: Film): Promise<Uint8Array<ArrayBuffer>> {
  const { widthPx, heightPx, picturesPerS, pictures, timed = true } = film;
  const gray = new Uint8Array((widthPx / 2) * (heightPx / 2)).fill(128);
  const colors = await encode(film, ({ y, u, v }) => [y, u, v]);
  const hasAlpha = pictures.some(({ alpha }) => alpha !== undefined);
  const alphas = hasAlpha ? await encode(film, ({ y, alpha }) => [alpha ?? y.map(() => 255), gray, gray]) : [];
  const frames = colors.map((chunk, i): WebmFrame => {
    const alpha = alphas[i]?.data;
    return { ...chunk, timeMs: timeMsOf(i, picturesPerS), ...(alpha === undefined ? {} : { alpha }) };
  });
  return writeWebm({ codec: 'V_VP9', widthPx, heightPx, durationMs: timed ? timeMsOf(pictures.length, picturesPerS) : null, frames });
}

function timeMsOf(index: number, picturesPerS: number): number {
  return Math.round((index * 1000) / picturesPerS);
}

async function encode(
  { widthPx, heightPx, picturesPerS, keyEvery, bitrate, pictures }: Film,
  planes: (picture: FilmPicture) => readonly Uint8Array[],
): Promise<{ readonly key: boolean; readonly data: Uint8Array }[]> {
  const chunks: { readonly key: boolean; readonly data: Uint8Array }[] = [];
  const failures: unknown[] = [];
  const encoder = new VideoEncoder({
    output: (chunk) => {
      const data = new Uint8Array(chunk.byteLength);
      chunk.copyTo(data);
      chunks.push({ key: chunk.type === 'key', data });
    },
    error: (error) => failures.push(error),
  });
  encoder.configure({ codec: CODEC, width: widthPx, height: heightPx, bitrate, framerate: picturesPerS, latencyMode: 'realtime' });
  pictures.forEach((picture, i) => {
    const data = new Uint8Array(planes(picture).flatMap((plane) => [...plane]));
    const timestamp = timeMsOf(i, picturesPerS) * 1000;
    const frame = new VideoFrame(data, { format: 'I420', codedWidth: widthPx, codedHeight: heightPx, timestamp });
    encoder.encode(frame, { keyFrame: i % keyEvery === 0 });
    frame.close();
  });
  await encoder.flush();
  encoder.close();
  if (failures.length > 0) throw failures[0];
  return chunks;
}
