import type { LayerPixels, PixelsView } from '../../../nodes/kit/layer-pixels.ts';
import { createPixelReadback } from '../gl/pixel-readback.ts';
import { prepareReadback } from '../gl/upload.ts';
import type { TargetBuffer } from '../targets/target-buffer.ts';

/** Pixels of a small image on the CPU. One image is read at a time, so a slow GPU skips images instead of making frames wait. */
export interface LivePixels extends PixelsView {
  /** How many images have been read. */
  readonly taken: number;
  /** Reads the image: at once while the clock is held, else without waiting. */
  take(image: TargetBuffer, held: boolean): void;
  /** Drops the pixels, and those that are being read. */
  forget(): void;
  dispose(): void;
}

export function createLivePixels(gl: WebGL2RenderingContext): LivePixels {
  const readback = createPixelReadback(gl);
  const pixels = { data: new Uint8Array(0), widthPx: 0, heightPx: 0 } satisfies LayerPixels;
  let hasPixels = false;
  let taken = 0;

  const arrive = (): void => {
    hasPixels = true;
    taken++;
  };
  const resize = ({ widthPx, heightPx }: TargetBuffer): void => {
    if (pixels.widthPx === widthPx && pixels.heightPx === heightPx) return;
    pixels.data = new Uint8Array(widthPx * heightPx * 4);
    pixels.widthPx = widthPx;
    pixels.heightPx = heightPx;
    hasPixels = false;
  };
  const dataOf = (): Uint8Array<ArrayBuffer> => pixels.data;
  const collect = (): void => {
    if (readback.collect(dataOf, false)) arrive();
  };
  return {
    get taken() {
      return taken;
    },
    read: () => {
      collect();
      return hasPixels ? pixels : null;
    },
    take: (image, held) => {
      collect();
      if (readback.isReading) return;
      resize(image);
      gl.bindFramebuffer(gl.FRAMEBUFFER, image.resolvedFramebuffer);
      if (held) {
        prepareReadback(gl);
        gl.readPixels(0, 0, image.widthPx, image.heightPx, gl.RGBA, gl.UNSIGNED_BYTE, pixels.data);
        arrive();
      } else readback.start(image.widthPx, image.heightPx, 'bytes');
    },
    forget: () => {
      readback.cancel();
      hasPixels = false;
    },
    dispose: readback.dispose,
  };
}
