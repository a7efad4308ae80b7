import { BufferTarget, EncodedPacket, EncodedVideoPacketSource, Output, WebMOutputFormat } from 'mediabunny';

/** A frame of a video: Y, U and V as the codec takes them (BT.601, video range), and alpha in [0, 255]; rows from the top. */
export interface FilmImage {
  readonly y: Uint8Array;
  readonly u: Uint8Array;
  readonly v: Uint8Array;
  readonly alpha?: Uint8Array;
}

export interface Film {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly framesPerS: number;
  /** Number of frames from one key frame to the next. */
  readonly keyEvery: number;
  readonly bitrate: number;
  readonly images: readonly FilmImage[];
  /** Whether the file states its duration. Browser recordings do not. */
  readonly timed?: boolean;
}

/** VP9 profile 0, level 1, eight bits, which all browsers play. */
const CODEC = 'vp09.00.10.08';

interface Encoded {
  readonly chunks: readonly EncodedVideoChunk[];
  /** Metadata of the first chunk. */
  readonly metadata: EncodedVideoChunkMetadata | undefined;
}

/** Encodes a WebM video with WebCodecs in a browser, with alpha if the frames have it. */
export async function encodeFilm(film: Film): Promise<Uint8Array<ArrayBuffer>> {
  const { widthPx, heightPx, framesPerS, images, timed = true } = film;
  const gray = new Uint8Array((widthPx / 2) * (heightPx / 2)).fill(128);
  const colors = await encode(film, ({ y, u, v }) => [y, u, v]);
  const hasAlpha = images.some(({ alpha }) => alpha !== undefined);
  const alphas = hasAlpha ? await encode(film, ({ y, alpha }) => [alpha ?? y.map(() => 255), gray, gray]) : null;
  const source = new EncodedVideoPacketSource('vp9');
  const output = new Output({ format: new WebMOutputFormat({ appendOnly: !timed }), target: new BufferTarget() });
  output.addVideoTrack(source, { frameRate: framesPerS });
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

function timeMsOf(index: number, framesPerS: number): number {
  return Math.round((index * 1000) / framesPerS);
}

async function encode(
  { widthPx, heightPx, framesPerS, keyEvery, bitrate, images }: Film,
  planes: (image: FilmImage) => readonly Uint8Array[],
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
  encoder.configure({ codec: CODEC, width: widthPx, height: heightPx, bitrate, framerate: framesPerS, latencyMode: 'realtime' });
  images.forEach((image, i) => {
    const data = new Uint8Array(planes(image).flatMap((plane) => [...plane]));
    const timestamp = timeMsOf(i, framesPerS) * 1000;
    const duration = 1e6 / framesPerS;
    const frame = new VideoFrame(data, { format: 'I420', codedWidth: widthPx, codedHeight: heightPx, timestamp, duration });
    encoder.encode(frame, { keyFrame: i % keyEvery === 0 });
    frame.close();
  });
  await encoder.flush();
  encoder.close();
  if (failures.length > 0) throw failures[0];
  return { chunks, metadata };
}
