import { BufferTarget, CanvasSource, canEncodeVideo, Mp4OutputFormat, Output, type OutputFormat, WebMOutputFormat } from 'mediabunny';

/** Makes a video of a canvas, frame by frame, however long each takes. */
export interface FrameEncoder {
  /** What the canvas shows now is the next frame. */
  add(): Promise<void>;
  finish(): Promise<Blob>;
}

export interface FrameEncoderOptions {
  readonly canvas: HTMLCanvasElement;
  readonly widthPx: number;
  readonly heightPx: number;
  readonly frameRateHz: number;
}

/** Best first: what plays everywhere, then what every Chromium can make. */
const KINDS = ['avc', 'vp9', 'vp8'] as const;

/** Twice what video sites ask for: the file is worked on further. */
const BITS_PER_PIXEL = 0.25;
const LEAST_BITS_PER_S = 1_000_000;
const KEY_FRAME_S = 1;

/** Throws where the browser makes no videos of that size. */
export async function createFrameEncoder({ canvas, widthPx, heightPx, frameRateHz }: FrameEncoderOptions): Promise<FrameEncoder> {
  const bitrate = Math.max(LEAST_BITS_PER_S, Math.round(widthPx * heightPx * frameRateHz * BITS_PER_PIXEL));
  const kind = await firstOf(KINDS, (codec) => canEncodeVideo(codec, { width: widthPx, height: heightPx, bitrate }));
  if (kind === null) throw new Error(`this browser makes no videos of ${widthPx} × ${heightPx}.`);
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
      if (target.buffer === null) throw new Error('the video was not finished.');
      return new Blob([target.buffer], { type: kind === 'avc' ? 'video/mp4' : 'video/webm' });
    },
  };
}

async function firstOf<T>(all: readonly T[], passes: (one: T) => Promise<boolean>): Promise<T | null> {
  for (const one of all) if (await passes(one)) return one;
  return null;
}
