import { allocateTexture } from '../gl/allocate-texture.ts';
import type { GlObjects } from '../gl/gl-objects.ts';
import { createPixelReadback } from '../gl/pixel-readback.ts';
import { prepareUpload } from '../gl/upload.ts';
import type { TargetBuffer } from '../targets/target-buffer.ts';

/**
 * Transfers the images of one view from the GPU to a worker and back: `read` to a GPU buffer, `collect` to a CPU buffer, which is `away`
 * while the worker has it and `back` afterwards, and `show`. One image is in transit at a time and its buffer is reused, so a slow worker
 * skips images instead of using more time or memory.
 */
export interface ViewExchange {
  readonly state: 'idle' | 'reading' | 'away' | 'back';
  /** Starts reading the image without waiting. */
  read(image: TargetBuffer): void;
  /** The bytes once the GPU has read them, else null; with `wait` it blocks until then. The caller owns the buffer until `giveBack`. */
  collect(wait: boolean): ViewBytes | null;
  giveBack(buffer: ArrayBuffer, isResult: boolean): void;
  /** The newest result, or null if there is none. */
  show(): WebGLTexture | null;
  /** Drops the result, and the one in transit; the latter must still be given back. */
  forget(): void;
  dispose(): void;
}

export interface ViewBytes {
  readonly buffer: ArrayBuffer;
  readonly widthPx: number;
  readonly heightPx: number;
}

export function createViewExchange(objects: GlObjects): ViewExchange {
  const { gl } = objects;
  const readback = createPixelReadback(gl);
  let state: ViewExchange['state'] = 'idle';
  /** Size of the image in transit. */
  let widthPx = 0;
  let heightPx = 0;
  /** Buffer for the bytes; null while the worker has it. */
  let room: Uint8Array<ArrayBuffer> | null = null;
  let result: { readonly texture: WebGLTexture; readonly widthPx: number; readonly heightPx: number } | null = null;
  let hasResult = false;

  const bufferOf = (byteLength: number): Uint8Array<ArrayBuffer> => (room?.length === byteLength ? room : new Uint8Array(byteLength));
  const resultOfSize = (): WebGLTexture => {
    if (result?.widthPx === widthPx && result.heightPx === heightPx) return result.texture;
    if (result) objects.deleteTexture(result.texture);
    const texture = allocateTexture(gl, objects.createTexture(), gl.RGBA8, gl.LINEAR, widthPx, heightPx);
    result = { texture, widthPx, heightPx };
    return texture;
  };
  return {
    get state() {
      return state;
    },
    read: (image) => {
      ({ widthPx, heightPx } = image);
      gl.bindFramebuffer(gl.FRAMEBUFFER, image.resolvedFramebuffer);
      readback.start(widthPx, heightPx, 'bytes');
      if (readback.isReading) state = 'reading';
    },
    collect: (wait) => {
      const bytes = readback.collect(bufferOf, wait);
      if (!bytes) return null;
      room = null;
      state = 'away';
      return { buffer: bytes.buffer, widthPx, heightPx };
    },
    giveBack: (buffer, isResult) => {
      room = new Uint8Array(buffer);
      state = isResult ? 'back' : 'idle';
    },
    show: () => {
      if (state === 'back' && room) {
        prepareUpload(gl, 4);
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(gl.TEXTURE_2D, resultOfSize());
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, widthPx, heightPx, gl.RGBA, gl.UNSIGNED_BYTE, room);
        state = 'idle';
        hasResult = true;
      }
      return hasResult && result ? result.texture : null;
    },
    forget: () => {
      readback.cancel();
      if (state !== 'away') state = 'idle';
      hasResult = false;
    },
    dispose: () => {
      readback.dispose();
      if (result) objects.deleteTexture(result.texture);
      result = null;
    },
  };
}
