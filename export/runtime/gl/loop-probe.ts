import { PROBE_ATTACHMENT, PROBE_SIDE_PX, readProbe } from '../../program/loop-budget.ts';
import { allocateTexture } from './allocate-texture.ts';
import type { GlObjects } from './gl-objects.ts';

/** A pass that asks for the result of its probe. */
export interface Asker {
  /** The last round in which its result was read. */
  round: number;
  answer(line: number | null): void;
}

/**
 * Probes whether the loops of bounded shaders end (`export/program/loop-budget.ts`). All passes share one texture, because the GPU works in
 * order. Results for the user are read back later, one at a time, without waiting for the GPU.
 */
export interface LoopProbe {
  readonly texture: WebGLTexture;
  readonly framebuffer: WebGLFramebuffer;
  /**
   * Clears the texture, because pixels that a shader discards would keep the result of the previous shader. Requires the framebuffer to be
   * bound.
   */
  clear(): void;
  /**
   * Starts reading the result of the probe that was just drawn, unless another read is pending or this asker was read in this round.
   * Requires the framebuffer to be bound.
   */
  ask(asker: Asker): void;
  /** Called before each frame: delivers a result if the GPU has finished. */
  poll(): void;
  dispose(): void;
}

const BYTES = PROBE_SIDE_PX ** 2 * 4;
const ZERO = new Float32Array(4);

export function createLoopProbe(objects: GlObjects): LoopProbe {
  const { gl } = objects;
  const texture = allocateTexture(gl, objects.createTexture(), gl.RG8, gl.NEAREST, PROBE_SIDE_PX, PROBE_SIDE_PX);
  const framebuffer = objects.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + PROBE_ATTACHMENT, gl.TEXTURE_2D, texture, 0);
  gl.drawBuffers([gl.NONE, gl.COLOR_ATTACHMENT0 + PROBE_ATTACHMENT]);
  gl.readBuffer(gl.COLOR_ATTACHMENT0 + PROBE_ATTACHMENT);
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
  gl.bufferData(gl.PIXEL_PACK_BUFFER, BYTES, gl.STREAM_READ);
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
  const bytes = new Uint8Array(BYTES);
  let pending: { readonly asker: Asker; readonly fence: WebGLSync } | null = null;
  /** Number of the current round. In a round each asker is read once; the round ends with a frame in which nobody asks. */
  let round = 1;
  return {
    texture,
    framebuffer,
    clear: () => gl.clearBufferfv(gl.COLOR, PROBE_ATTACHMENT, ZERO),
    ask: (asker) => {
      if (pending || asker.round === round) return;
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
      gl.pixelStorei(gl.PACK_ALIGNMENT, 4);
      gl.pixelStorei(gl.PACK_ROW_LENGTH, 0);
      gl.pixelStorei(gl.PACK_SKIP_PIXELS, 0);
      gl.pixelStorei(gl.PACK_SKIP_ROWS, 0);
      gl.readPixels(0, 0, PROBE_SIDE_PX, PROBE_SIDE_PX, gl.RGBA, gl.UNSIGNED_BYTE, 0);
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
      const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
      if (!fence) return;
      gl.flush();
      asker.round = round;
      pending = { asker, fence };
    },
    poll: () => {
      if (!pending) {
        round++;
        return;
      }
      if (gl.getSyncParameter(pending.fence, gl.SYNC_STATUS) !== gl.SIGNALED) return;
      const { asker, fence } = pending;
      pending = null;
      gl.deleteSync(fence);
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
      gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, bytes);
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
      asker.answer(readProbe(bytes));
    },
    dispose: () => {
      if (pending) gl.deleteSync(pending.fence);
      pending = null;
      gl.deleteBuffer(buffer);
      objects.deleteFramebuffer(framebuffer);
      objects.deleteTexture(texture);
    },
  };
}
