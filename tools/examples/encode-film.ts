import { BufferTarget, EncodedPacket, EncodedVideoPacketSource, Output, WebMOutputFormat } from 'mediabunny';

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
  /** Whether the file states its duration. Browser recordings do not. */
  readonly timed?: boolean;
}

/** VP9 profile 0, level 1, eight bits, which all browsers play. */
const CODEC = 'vp09.00.10.08';

interface Encoded {
  readonly chunks: readonly EncodedVideoChunk[];
  /** Of the first chunk. */
  readonly metadata: EncodedVideoChunkMetadata | undefined;
}

/** Encodes a WebM video with WebCodecs in a browser, with alpha if the frames have it. */
export async function encodeFilm(film: Film): Promise<Uint8Array<ArrayBuffer>> {
  const { widthPx, heightPx, picturesPerS, pictures, timed = true } = film;
  const gray = new Uint8Array((widthPx / 2) * (heightPx / 2)).fill(128);
  const colors = await encode(film, ({ y, u, v }) => [y, u, v]);
  const hasAlpha = pictures.some(({ alpha }) => alpha !== undefined);
  const alphas = hasAlpha ? await encode(film, ({ y, alpha }) => [alpha ?? y.map(() => 255), gray, gray]) : null;
  const source = new EncodedVideoPacketSource('vp9');
  const output = new Output({ format: new WebMOutputFormat({ appendOnly: !timed }), target: new BufferTarget() });
  output.addVideoTrack(source, { frameRate: picturesPerS });
  await output.start();
  for (const [i, chunk] of colors.chunks.entries()) {
    const alpha = alphas?.chunks[i];
    const packet = EncodedPacket.fromEncodedChunk(chunk, alpha && { alpha: bytesOf(alpha) });
    await source.add(packet, colors.metadata);
  }
  await output.finalize();
  if (!output.target.buffer) throw new Error('The film has no bytes.');
  return new Uint8Array(output.target.buffer);
}

function bytesOf(chunk: EncodedVideoChunk): Uint8Array {
  const bytes = new Uint8Array(chunk.byteLength);
  chunk.copyTo(bytes);
  return bytes;
}

function timeMsOf(index: number, picturesPerS: number): number {
  return Math.round((index * 1000) / picturesPerS);
}

async function encode(
  { widthPx, heightPx, picturesPerS, keyEvery, bitrate, pictures }: Film,
  planes: (picture: FilmPicture) => readonly Uint8Array[],
): Promise<Encoded> {
  const chunks: EncodedVideoChunk[] = [];
  let metadata: EncodedVideoChunkMetadata | undefined;
  const failures: unknown[] = [];
  const encoder = new VideoEncoder({
    output: (chunk, more) => {
      chunks.push(chunk);
      metadata ??= more;
    },
    error: (error) => failures.push(error),
  });
  encoder.configure({ codec: CODEC, width: widthPx, height: heightPx, bitrate, framerate: picturesPerS, latencyMode: 'realtime' });
  pictures.forEach((picture, i) => {
    const data = new Uint8Array(planes(picture).flatMap((plane) => [...plane]));
    const timestamp = timeMsOf(i, picturesPerS) * 1000;
    const duration = 1e6 / picturesPerS;
    const frame = new VideoFrame(data, { format: 'I420', codedWidth: widthPx, codedHeight: heightPx, timestamp, duration });
    encoder.encode(frame, { keyFrame: i % keyEvery === 0 });
    frame.close();
  });
  await encoder.flush();
  encoder.close();
  if (failures.length > 0) throw failures[0];
  return { chunks, metadata };
}
