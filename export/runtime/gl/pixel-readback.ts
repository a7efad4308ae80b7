import { prepareReadback } from './upload.ts';

/** Reads images to the CPU without waiting for the GPU, one at a time, through one buffer that is reused. */
export interface PixelReadback {
  /** Whether an image has been started and is not collected yet. */
  readonly isReading: boolean;
  /** Starts reading RGBA of the bound framebuffer, as bytes or as floats of 32 bits. */
  start(widthPx: number, heightPx: number, type: 'bytes' | 'floats'): void;
  /**
   * Writes the image to the array that `into` returns, once the GPU has read it; with `wait` it blocks until then.
   *
   * @param into Called with the size of the image in bytes, only when there is an image to collect.
   * @returns The array, or null while there is no image to collect
   */
  collect<T extends ArrayBufferView>(into: (byteLength: number) => T, wait: boolean): T | null;
  /** Drops the image that is being read. */
  cancel(): void;
  dispose(): void;
}

const BYTES_PER_PIXEL = { bytes: 4, floats: 16 } as const;

/** The buffer on the GPU is created with the first image. */
export function createPixelReadback(gl: WebGL2RenderingContext): PixelReadback {
  let buffer: WebGLBuffer | null = null;
  let bufferBytes = 0;
  let fence: WebGLSync | null = null;

  const cancel = (): void => {
    if (fence) gl.deleteSync(fence);
    fence = null;
  };
  return {
    get isReading() {
      return fence !== null;
    },
    start: (widthPx, heightPx, type) => {
      const byteLength = widthPx * heightPx * BYTES_PER_PIXEL[type];
      buffer ??= gl.createBuffer();
      prepareReadback(gl);
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
      if (bufferBytes !== byteLength) gl.bufferData(gl.PIXEL_PACK_BUFFER, byteLength, gl.STREAM_READ);
      bufferBytes = byteLength;
      gl.readPixels(0, 0, widthPx, heightPx, gl.RGBA, type === 'bytes' ? gl.UNSIGNED_BYTE : gl.FLOAT, 0);
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
      fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
      gl.flush();
    },
    collect: (into, wait) => {
      if (!fence || (!wait && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED)) return null;
      cancel();
      const image = into(bufferBytes);
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
      gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, image);
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
      return image;
    },
    cancel,
    dispose: () => {
      cancel();
      if (buffer) gl.deleteBuffer(buffer);
      buffer = null;
      bufferBytes = 0;
    },
  };
}
