import type { LayerPixels, PixelsView } from '../../../nodes/kit/layer-pixels.ts';
import { prepareReadback } from '../gl/upload.ts';
import type { TargetBuffer } from '../targets/target-buffer.ts';

/** Pixels of a small image on the CPU. One image is read at a time, so a slow GPU skips images instead of making frames wait. */
export interface LivePixels extends PixelsView {
  /** Reads the image: at once while the clock is held, else without waiting. */
  take(image: TargetBuffer, held: boolean): void;
  /** Drops the pixels, and those that are being read. */
  forget(): void;
  dispose(): void;
}

/** The buffer on the GPU is created with the first image that is not awaited. */
export function createLivePixels(gl: WebGL2RenderingContext): LivePixels {
  const pixels = { data: new Uint8Array(0), widthPx: 0, heightPx: 0 } satisfies LayerPixels;
  let buffer: WebGLBuffer | null = null;
  let bufferBytes = 0;
  let fence: WebGLSync | null = null;
  let hasPixels = false;

  const endReading = (): void => {
    if (fence) gl.deleteSync(fence);
    fence = null;
  };
  const resize = ({ widthPx, heightPx }: TargetBuffer): void => {
    if (pixels.widthPx === widthPx && pixels.heightPx === heightPx) return;
    pixels.data = new Uint8Array(widthPx * heightPx * 4);
    pixels.widthPx = widthPx;
    pixels.heightPx = heightPx;
    hasPixels = false;
  };
  const collect = (): void => {
    if (!fence || gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) return;
    endReading();
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, pixels.data);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    hasPixels = true;
  };
  const startReading = ({ widthPx, heightPx }: TargetBuffer): void => {
    const bytes = pixels.data.byteLength;
    buffer ??= gl.createBuffer();
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    if (bufferBytes !== bytes) gl.bufferData(gl.PIXEL_PACK_BUFFER, bytes, gl.STREAM_READ);
    bufferBytes = bytes;
    gl.readPixels(0, 0, widthPx, heightPx, gl.RGBA, gl.UNSIGNED_BYTE, 0);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
  };
  return {
    read: () => {
      collect();
      return hasPixels ? pixels : null;
    },
    take: (image, held) => {
      collect();
      if (fence) return;
      resize(image);
      prepareReadback(gl);
      gl.bindFramebuffer(gl.FRAMEBUFFER, image.resolvedFramebuffer);
      if (held) {
        gl.readPixels(0, 0, image.widthPx, image.heightPx, gl.RGBA, gl.UNSIGNED_BYTE, pixels.data);
        hasPixels = true;
      } else startReading(image);
    },
    forget: () => {
      endReading();
      hasPixels = false;
    },
    dispose: () => {
      endReading();
      if (buffer) gl.deleteBuffer(buffer);
      buffer = null;
    },
  };
}
