import { BufferTarget, CanvasSource, canEncodeVideo, Mp4OutputFormat, Output, type OutputFormat, WebMOutputFormat } from 'mediabunny';

/** Encodes a canvas as a video, frame by frame, independent of real time. */
export interface FrameEncoder {
  /** Adds the current content of the canvas as the next frame. */
  add(): Promise<void>;
  finish(): Promise<Blob>;
}

export interface FrameEncoderOptions {
  readonly canvas: HTMLCanvasElement;
  readonly widthPx: number;
  readonly heightPx: number;
  readonly frameRateHz: number;
}

/** Codecs in order of preference: AVC plays everywhere, VP8 can be encoded by every Chromium. */
const KINDS = ['avc', 'vp9', 'vp8'] as const;

/** Bit rate of videos, in bits per pixel. Twice what video sites recommend, because renders are edited further. */
const BITS_PER_PIXEL = 0.25;
const LEAST_BITS_PER_S = 1_000_000;
const KEY_FRAME_S = 1;

/**
 * Creates an encoder for a canvas.
 *
 * @throws If the browser cannot encode videos of this size.
 */
export async function createFrameEncoder({ canvas, widthPx, heightPx, frameRateHz }: FrameEncoderOptions): Promise<FrameEncoder> {
  const bitrate = Math.max(LEAST_BITS_PER_S, Math.round(widthPx * heightPx * frameRateHz * BITS_PER_PIXEL));
  const kind = await firstOf(KINDS, (codec) => canEncodeVideo(codec, { width: widthPx, height: heightPx, bitrate }));
  if (kind === null) throw new Error(`this browser cannot encode videos of ${widthPx} × ${heightPx}.`);
  const format: OutputFormat = kind === 'avc' ? new Mp4OutputFormat() : new WebMOutputFormat();
  const target = new BufferTarget();
  const output = new Output({ format, target });
  const source = new CanvasSource(canvas, { codec: kind, bitrate, keyFrameInterval: KEY_FRAME_S, latencyMode: 'quality' });
  output.addVideoTrack(source, { frameRate: frameRateHz });
  await output.start();
  let count = 0;
  return {
    add: () => source.add(count++ / frameRateHz, 1 / frameRateHz),
    finish: async () => {
      await output.finalize();
      if (target.buffer === null) throw new Error('the video is incomplete.');
      return new Blob([target.buffer], { type: kind === 'avc' ? 'video/mp4' : 'video/webm' });
    },
  };
}

async function firstOf<T>(all: readonly T[], passes: (one: T) => Promise<boolean>): Promise<T | null> {
  for (const one of all) if (await passes(one)) return one;
  return null;
}
