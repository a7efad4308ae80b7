import type { FrameClock } from '../../export/runtime/clock.ts';
import type { Player } from '../../export/runtime/player.ts';
import { readColor } from '../../export/runtime/readback.ts';
import type { SessionFrame } from '../../nodes/kit/session.ts';
import type { FromPreview } from '../preview-protocol.ts';

/**
 * Sends thumbnails of layers: the first ones of several layers in one frame, later ones one per frame, so that their number does not affect
 * the cost of a frame.
 */
export interface Thumbnails {
  setPorts(ports: readonly string[], heightPx: number): void;
  /** Marks all thumbnails as outdated, also while time stands still. */
  invalidate(): void;
  /**
   * Marks all thumbnails as outdated. If every layer already has a thumbnail, waits for a pause first, because more changes are likely, as
   * while someone types.
   */
  invalidateAfterPause(): void;
  /**
   * Returns the layers that this frame must draw for their thumbnails. The list is valid until the next call. A frame of another time, size
   * or pose than the last one outdates the thumbnails, also of the last frame before a pause.
   */
  beforeFrame(frame: ShownFrame): readonly string[];
  /** Whether thumbnails are outdated. Others are read again because a layer may change without a sign. */
  readonly outdated: boolean;
  /** Called if the frame was not drawn, so that the layers that `beforeFrame` returned cannot be read. */
  skip(): void;
  /** Reads those layers. Returns the seconds until another frame is needed for outdated thumbnails; null if none is. */
  afterFrame(player: Pick<Player, 'inspect'>): number | null;
}

/** Maximum fraction of time for reading pixels back, which waits until the GPU has drawn the layer. */
const SHARE = 0.1;
/** Maximum fraction of time for the first thumbnail of a layer. Higher than `SHARE`, because a node without a thumbnail looks empty. */
const FIRST_SHARE = 0.5;
/**
 * Number of first thumbnails per frame. Where the CPU draws, a frame of a large graph takes seconds, and most of it is the same for one
 * thumbnail and for several.
 */
const FIRST_AT_ONCE = 6;
/** Time between two thumbnails of a layer. */
const INTERVAL_S = 0.1;

/** Pause before thumbnails are updated after a change. Each thumbnail needs a frame, which would delay the image after the next key. */
const PAUSE_S = 0.25;

/** What the image of a frame depends on besides the program. */
export type ShownFrame = Pick<SessionFrame, 'timeS' | 'framebufferWidthPx' | 'framebufferHeightPx' | 'views'>;

type Send = (message: FromPreview, transfer: Transferable[]) => void;

export function createThumbnails(clock: Pick<FrameClock, 'nowS'>, send: Send, read = readColor): Thumbnails {
  let ports: readonly string[] = [];
  /** Requested ports that have had a thumbnail. */
  let seen = new Set<string>();
  /** Requested ports that have had none, and have not been read since the last change either. */
  let fresh = new Set<string>();
  /** Time at which each requested port was last read, in seconds. */
  let readAtS = new Map<string, number>();
  let heightPx = 0;
  let next = 0;
  let restUntilS = Number.NEGATIVE_INFINITY;
  let left = 0;
  const drawn: string[] = [];
  const isOther = createFrameWatch();
  const markAll = () => {
    left = ports.length;
    fresh = new Set(ports.filter((port) => !seen.has(port)));
  };
  return {
    setPorts: (wanted, height) => {
      ports = wanted;
      seen = new Set(wanted.filter((port) => seen.has(port)));
      readAtS = new Map([...readAtS].filter(([port]) => wanted.includes(port)));
      heightPx = height;
      markAll();
    },
    invalidate: markAll,
    invalidateAfterPause: () => {
      markAll();
      if (seen.size === ports.length) restUntilS = Math.max(restUntilS, clock.nowS() + PAUSE_S);
    },
    beforeFrame: (frame) => {
      // Layers without an image are not asked for it again.
      if (isOther(frame)) left = ports.length;
      const nowS = clock.nowS();
      drawn.length = 0;
      if (nowS < restUntilS) return drawn;
      for (const port of fresh) if (drawn.length < FIRST_AT_ONCE) drawn.push(port);
      if (drawn.length > 0) return drawn;
      const port = ports[(next + 1) % ports.length];
      if (port === undefined) return drawn;
      const freeS = (readAtS.get(port) ?? Number.NEGATIVE_INFINITY) + INTERVAL_S;
      if (nowS < freeS) {
        restUntilS = freeS;
        return drawn;
      }
      next = (next + 1) % ports.length;
      drawn.push(port);
      return drawn;
    },
    get outdated() {
      return left > 0;
    },
    skip: () => {
      drawn.length = 0;
    },
    afterFrame: (player) => {
      const beganS = clock.nowS();
      if (drawn.length === 0) return left > 0 ? Math.max(0, restUntilS - beganS) : null;
      left = Math.max(0, left - drawn.length);
      let isFirst = false;
      for (const port of drawn) {
        fresh.delete(port);
        readAtS.set(port, beganS);
        const layer = read(player.inspect(port), 0, heightPx);
        if (layer === null) continue;
        // `ImageData` has straight alpha, a layer premultiplied alpha.
        const image = new ImageData(straightAlpha(layer.pixels), layer.widthPx, layer.heightPx);
        void createImageBitmap(image).then((bitmap) => send({ kind: 'thumbnail', port, image: bitmap }, [bitmap]));
        isFirst ||= !seen.has(port);
        seen.add(port);
      }
      drawn.length = 0;
      const nowS = clock.nowS();
      restUntilS = nowS + (nowS - beganS) * (1 / (isFirst ? FIRST_SHARE : SHARE) - 1);
      return left > 0 ? restUntilS - nowS : null;
    },
  };
}

/** Returns a function that tells whether a frame has another time, size or pose than the one before. */
function createFrameWatch(): (frame: ShownFrame) => boolean {
  let timeS = Number.NaN;
  let widthPx = 0;
  let heightPx = 0;
  const pose = new Float32Array(16);
  return (frame) => {
    const worldFromView = frame.views[0]?.worldFromView ?? pose;
    let moved = false;
    for (let i = 0; i < pose.length; i++) moved ||= worldFromView[i] !== pose[i];
    const isOther = moved || frame.timeS !== timeS || frame.framebufferWidthPx !== widthPx || frame.framebufferHeightPx !== heightPx;
    ({ timeS, framebufferWidthPx: widthPx, framebufferHeightPx: heightPx } = frame);
    pose.set(worldFromView);
    return isOther;
  };
}

function straightAlpha(pixels: Uint8Array<ArrayBuffer>): Uint8ClampedArray<ArrayBuffer> {
  const straight = new Uint8ClampedArray(pixels.length);
  for (let i = 0; i < pixels.length; i += 4) {
    const alpha = pixels[i + 3] ?? 0;
    const scale = alpha === 0 ? 0 : 255 / alpha;
    for (let channel = 0; channel < 3; channel++) straight[i + channel] = (pixels[i + channel] ?? 0) * scale;
    straight[i + 3] = alpha;
  }
  return straight;
}
