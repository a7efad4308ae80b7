import type { AssetSource } from '../../assets/asset-source.ts';
import type { SessionFile, SessionFileFrame } from '../session-format.ts';
import { decodeDepth } from './decode-depth.ts';

/** A decoded frame of the recording. */
export interface DecodedFrame {
  readonly index: number;
  /** The color image; its first row is the top row. */
  readonly color: ImageBitmap;
  /** Depth in meters, as `decodeDepth` returns it; null if the frame has none or the file is invalid. */
  readonly meters: Float32Array<ArrayBuffer> | null;
}

export interface FrameCache {
  /** Number of frames that fit into the budget. */
  readonly capacity: number;
  /** Whether the frame is being decoded. */
  isPending(index: number): boolean;
  /** The frame if it is decoded. Marks it as recently used. */
  get(index: number): DecodedFrame | null;
  /** Returns the frame, decoding it if necessary; null if its color image is invalid. */
  request(index: number): Promise<DecodedFrame | null>;
  /** Starts decoding the frame if it is neither decoded nor pending. */
  prefetch(index: number): void;
  dispose(): void;
}

/**
 * Decodes frames and keeps the most recently used ones, up to `budgetBytes` but at least one. `onProblem` is called once per invalid file.
 */
export function createFrameCache(
  files: AssetSource,
  session: SessionFile,
  budgetBytes: number,
  onProblem: (message: string) => void,
): FrameCache {
  const bytesPerFrame =
    4 * (session.color.widthPx * session.color.heightPx + (session.depth ? session.depth.widthPx * session.depth.heightPx : 0));
  const capacity = Math.max(1, Math.floor(budgetBytes / bytesPerFrame));
  /** Decoded frames by index, in the order of their last use. */
  const decoded = new Map<number, DecodedFrame>();
  const pending = new Map<number, Promise<DecodedFrame | null>>();
  const broken = new Set<number>();
  let disposed = false;

  const touch = (frame: DecodedFrame): void => {
    decoded.delete(frame.index);
    decoded.set(frame.index, frame);
    for (const [index, oldest] of decoded) {
      if (decoded.size <= capacity) break;
      oldest.color.close();
      decoded.delete(index);
    }
  };
  const load = async (index: number, frame: SessionFileFrame): Promise<DecodedFrame | null> => {
    const { depth } = session;
    const [color, meters] = await Promise.allSettled([
      files.load(frame.color).then((bytes) => decodeColor(bytes, session)),
      depth && frame.depth !== undefined ? files.load(frame.depth).then((bytes) => decodeDepth(bytes, depth)) : null,
    ]);
    pending.delete(index);
    // In this order whichever file failed first: of a frame without any file, the color image is reported.
    if (color.status === 'rejected') onProblem(unusableImage(frame.color, color.reason));
    if (meters.status === 'rejected') onProblem(unusableImage(frame.depth ?? '', meters.reason));
    if (color.status === 'rejected') {
      broken.add(index);
      return null;
    }
    if (disposed) {
      color.value.close();
      return null;
    }
    const result = { index, color: color.value, meters: meters.status === 'fulfilled' ? meters.value : null };
    touch(result);
    return result;
  };
  const request = (index: number): Promise<DecodedFrame | null> => {
    const known = decoded.get(index);
    const frame = session.frames[index];
    if (known || !frame || broken.has(index) || disposed) return Promise.resolve(known ?? null);
    const running = pending.get(index) ?? load(index, frame);
    pending.set(index, running);
    return running;
  };
  return {
    capacity,
    isPending: (index) => pending.has(index),
    get: (index) => {
      const frame = decoded.get(index);
      if (frame) touch(frame);
      return frame ?? null;
    },
    request,
    prefetch: (index) => {
      if (!decoded.has(index) && !pending.has(index) && !broken.has(index)) void request(index);
    },
    dispose: () => {
      disposed = true;
      for (const frame of decoded.values()) frame.color.close();
      decoded.clear();
    },
  };
}

async function decodeColor(bytes: ArrayBuffer, session: SessionFile): Promise<ImageBitmap> {
  const { widthPx, heightPx } = session.color;
  const bitmap = await createImageBitmap(new Blob([bytes]), { premultiplyAlpha: 'none', colorSpaceConversion: 'none' }).catch(() => null);
  if (!bitmap) throw new Error('the browser cannot decode it');
  const { width, height } = bitmap;
  if (width === widthPx && height === heightPx) return bitmap;
  bitmap.close();
  throw new Error(`it has ${width} × ${height} pixels, but session.json specifies ${widthPx} × ${heightPx}`);
}

const unusableImage = (path: string, reason: unknown): string =>
  `The image "${path}" cannot be used: ${reason instanceof Error ? reason.message : String(reason)}.`;
