import type { DepthImage } from './drawing.ts';
import { TRUSTED, UNKNOWN } from './registration.ts';

/** Reports once if the camera image does not match the depth. */
export interface RegistrationCheck {
  /** Call it in each frame with the result of `RegistrationMeter`. It reads a pixel every few frames, without waiting for the GPU. */
  look(measured: DepthImage): void;
  dispose(): void;
}

const EVERY_FRAMES = 20;
/** How many bad results in a row are a mismatch; a single view may have too few edges to tell. */
const IN_A_ROW = 4;

/** Creates a check. `onMismatch` is called at most once. */
export function createRegistrationCheck(gl: WebGL2RenderingContext, onMismatch: () => void): RegistrationCheck {
  const pixel = new Float32Array(4);
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
  gl.bufferData(gl.PIXEL_PACK_BUFFER, pixel.byteLength, gl.STREAM_READ);
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
  let fence: WebGLSync | null = null;
  let frames = 0;
  let misses = 0;

  const ask = (framebuffer: WebGLFramebuffer): void => {
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, 0);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  };
  const answered = (): boolean => {
    if (!fence) return false;
    const status = gl.getSyncParameter(fence, gl.SYNC_STATUS) as GLenum;
    if (status !== gl.SIGNALED) return false;
    gl.deleteSync(fence);
    fence = null;
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, pixel);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    return true;
  };
  return {
    look: ({ framebuffer }) => {
      if (misses >= IN_A_ROW) return;
      if (answered()) {
        const [gain = UNKNOWN] = pixel;
        if (gain > UNKNOWN) misses = gain < TRUSTED[0] ? misses + 1 : 0;
        if (misses >= IN_A_ROW) onMismatch();
      }
      if (!fence && frames++ % EVERY_FRAMES === 0) ask(framebuffer);
    },
    dispose: () => {
      gl.deleteBuffer(buffer);
      if (fence) gl.deleteSync(fence);
    },
  };
}
