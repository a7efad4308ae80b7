import type { FrameClock } from '../../export/runtime/clock.ts';
import type { Player } from '../../export/runtime/player.ts';
import { readColor } from '../../export/runtime/readback.ts';
import type { FromPreview } from '../preview-protocol.ts';

/** Sends thumbnails of layers, one per frame, so that their number does not affect the cost of a frame. */
export interface Thumbnails {
  setPorts(ports: readonly string[], heightPx: number): void;
  /** Marks all thumbnails as outdated, also while time stands still. */
  invalidate(): void;
  /**
   * Marks all thumbnails as outdated. If every layer already has a thumbnail, waits for a pause first, because more changes are likely, as
   * while someone types.
   */
  invalidateAfterPause(): void;
  /** Returns the seconds until another frame is needed for outdated thumbnails; null if none is. */
  afterFrame(player: Pick<Player, 'inspect'>): number | null;
}

/** Maximum fraction of time for reading pixels back, which waits for the GPU. */
const SHARE = 0.1;
/**
 * Maximum fraction of time for reading the first thumbnail of a layer. Higher than `SHARE`, because a node without a thumbnail looks empty.
 */
const FIRST_SHARE = 0.5;

/** Pause before thumbnails are updated after a change. Each thumbnail needs a frame, which would delay the image after the next key. */
const PAUSE_S = 0.25;

type Send = (message: FromPreview, transfer: Transferable[]) => void;

export function createThumbnails(clock: Pick<FrameClock, 'nowS'>, send: Send, read = readColor): Thumbnails {
  let ports: readonly string[] = [];
  /** Requested ports that have had a thumbnail. */
  let seen = new Set<string>();
  let heightPx = 0;
  let next = 0;
  let restUntilS = Number.NEGATIVE_INFINITY;
  let left = 0;
  return {
    setPorts: (wanted, height) => {
      ports = wanted;
      seen = new Set(wanted.filter((port) => seen.has(port)));
      heightPx = height;
      left = ports.length;
    },
    invalidate: () => {
      left = ports.length;
    },
    invalidateAfterPause: () => {
      left = ports.length;
      if (seen.size === ports.length) restUntilS = Math.max(restUntilS, clock.nowS() + PAUSE_S);
    },
    afterFrame: (player) => {
      const beganS = clock.nowS();
      if (ports.length === 0) return null;
      if (beganS < restUntilS) return left > 0 ? restUntilS - beganS : null;
      next = (next + 1) % ports.length;
      left = Math.max(0, left - 1);
      const port = ports[next];
      const layer = port === undefined ? null : read(player.inspect(port), 0, heightPx);
      if (port !== undefined && layer !== null) {
        // `ImageData` has straight alpha, a layer premultiplied alpha.
        const image = new ImageData(straightAlpha(layer.pixels), layer.widthPx, layer.heightPx);
        void createImageBitmap(image).then((bitmap) => send({ kind: 'thumbnail', port, image: bitmap }, [bitmap]));
      }
      const isFirst = port !== undefined && layer !== null && !seen.has(port);
      if (isFirst) seen.add(port);
      const nowS = clock.nowS();
      restUntilS = nowS + (nowS - beganS) * (1 / (isFirst ? FIRST_SHARE : SHARE) - 1);
      return left > 0 ? restUntilS - nowS : null;
    },
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
