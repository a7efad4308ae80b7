import type { FrameClock } from '../../export/runtime/clock.ts';
import type { Player } from '../../export/runtime/player.ts';
import type { FromPreview } from '../preview-protocol.ts';

/** Small copies of tapped layers, one a turn, so that looking at many costs no more than looking at one. */
export interface Thumbnails {
  want(ports: readonly string[], heightPx: number): void;
  afterFrame(player: Pick<Player, 'readLayer'>): void;
}

/** Reading pixels back waits for the GPU. */
const INTERVAL_S = 0.1;

export function createThumbnails(clock: FrameClock, send: (message: FromPreview, transfer: Transferable[]) => void): Thumbnails {
  let ports: readonly string[] = [];
  let heightPx = 0;
  let next = 0;
  let lastS = Number.NEGATIVE_INFINITY;
  return {
    want: (wanted, height) => {
      ports = wanted;
      heightPx = height;
    },
    afterFrame: (player) => {
      if (ports.length === 0 || clock.nowS() - lastS < INTERVAL_S) return;
      lastS = clock.nowS();
      next = (next + 1) % ports.length;
      const port = ports[next];
      const layer = port === undefined ? null : player.readLayer(port, 0, heightPx);
      if (port === undefined || layer === null) return;
      // Pixels of `ImageData` are straight, those of a layer premultiplied.
      const image = new ImageData(straightAlpha(layer.pixels), layer.widthPx, layer.heightPx);
      void createImageBitmap(image).then((bitmap) => send({ kind: 'thumbnail', port, image: bitmap }, [bitmap]));
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
