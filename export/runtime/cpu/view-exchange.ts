import { allocateTexture } from '../gl/allocate-texture.ts';
import type { GlObjects } from '../gl/gl-objects.ts';
import { prepareReadback, prepareUpload } from '../gl/upload.ts';
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
  const packBuffer = gl.createBuffer();
  let packBytes = 0;
  let fence: WebGLSync | null = null;
  let state: ViewExchange['state'] = 'idle';
  /** Size of the image in transit. */
  let widthPx = 0;
  let heightPx = 0;
  /** Buffer for the bytes; null while the worker has it. */
  let room: Uint8Array<ArrayBuffer> | null = null;
  let result: { readonly texture: WebGLTexture; readonly widthPx: number; readonly heightPx: number } | null = null;
  let hasResult = false;

  const endReading = (): void => {
    if (fence) gl.deleteSync(fence);
    fence = null;
  };
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
      const bytes = widthPx * heightPx * 4;
      prepareReadback(gl);
      gl.bindFramebuffer(gl.FRAMEBUFFER, image.resolvedFramebuffer);
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, packBuffer);
      if (packBytes !== bytes) gl.bufferData(gl.PIXEL_PACK_BUFFER, bytes, gl.STREAM_READ);
      packBytes = bytes;
      gl.readPixels(0, 0, widthPx, heightPx, gl.RGBA, gl.UNSIGNED_BYTE, 0);
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
      fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
      gl.flush();
      if (fence) state = 'reading';
    },
    collect: (wait) => {
      if (!fence || (!wait && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED)) return null;
      endReading();
      const bytes = room?.length === packBytes ? room : new Uint8Array(packBytes);
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, packBuffer);
      gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, bytes);
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
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
      endReading();
      if (state !== 'away') state = 'idle';
      hasResult = false;
    },
    dispose: () => {
      endReading();
      gl.deleteBuffer(packBuffer);
      if (result) objects.deleteTexture(result.texture);
      result = null;
    },
  };
}
