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
  /** Returns the layer that this frame must draw for its thumbnail; null if none. */
  beforeFrame(): string | null;
  /** Reads that layer. Returns the seconds until another frame is needed for outdated thumbnails; null if none is. */
  afterFrame(player: Pick<Player, 'inspect'>): number | null;
}

/** Maximum fraction of time for reading pixels back, which waits until the GPU has drawn the layer. */
const SHARE = 0.1;
/** Maximum fraction of time for the first thumbnail of a layer. Higher than `SHARE`, because a node without a thumbnail looks empty. */
const FIRST_SHARE = 0.5;
/** Time between two thumbnails of a layer. */
const INTERVAL_S = 0.1;

/** Pause before thumbnails are updated after a change. Each thumbnail needs a frame, which would delay the image after the next key. */
const PAUSE_S = 0.25;

type Send = (message: FromPreview, transfer: Transferable[]) => void;

export function createThumbnails(clock: Pick<FrameClock, 'nowS'>, send: Send, read = readColor): Thumbnails {
  let ports: readonly string[] = [];
  /** Requested ports that have had a thumbnail. */
  let seen = new Set<string>();
  /** Time at which each requested port was last read, in seconds. */
  let readAtS = new Map<string, number>();
  let heightPx = 0;
  let next = 0;
  let restUntilS = Number.NEGATIVE_INFINITY;
  let left = 0;
  let drawn: string | null = null;
  return {
    setPorts: (wanted, height) => {
      ports = wanted;
      seen = new Set(wanted.filter((port) => seen.has(port)));
      readAtS = new Map([...readAtS].filter(([port]) => wanted.includes(port)));
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
    beforeFrame: () => {
      const nowS = clock.nowS();
      const port = ports[(next + 1) % ports.length];
      drawn = null;
      if (port === undefined || nowS < restUntilS) return null;
      const freeS = (readAtS.get(port) ?? Number.NEGATIVE_INFINITY) + INTERVAL_S;
      if (nowS < freeS) {
        restUntilS = freeS;
        return null;
      }
      next = (next + 1) % ports.length;
      drawn = port;
      return port;
    },
    afterFrame: (player) => {
      const beganS = clock.nowS();
      const port = drawn;
      drawn = null;
      if (port === null) return left > 0 ? Math.max(0, restUntilS - beganS) : null;
      left = Math.max(0, left - 1);
      readAtS.set(port, beganS);
      const layer = read(player.inspect(port), 0, heightPx);
      if (layer !== null) {
        // `ImageData` has straight alpha, a layer premultiplied alpha.
        const image = new ImageData(straightAlpha(layer.pixels), layer.widthPx, layer.heightPx);
        void createImageBitmap(image).then((bitmap) => send({ kind: 'thumbnail', port, image: bitmap }, [bitmap]));
      }
      const isFirst = layer !== null && !seen.has(port);
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
