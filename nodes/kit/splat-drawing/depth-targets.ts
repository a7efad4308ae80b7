import { linkProgram } from '../link-program.ts';
import { setPassState } from '../pass-state.ts';
import type { DrawView } from '../runtime.ts';
import { DEPTH_FRAGMENT, FULL_VERTEX } from './splat-shaders.ts';

/** Two images of sums of depth and alpha, and the pass that makes the depth of a layer of them. */
export interface DepthTargets {
  readonly mean: WebGLTexture;
  readonly front: WebGLTexture;
  /** Gives both images a size. Returns whether they can be drawn to. */
  resize(widthPx: number, heightPx: number): boolean;
  /** Binds an image to draw to, and clears it. */
  begin(image: 'mean' | 'front'): void;
  /** Writes depth to the framebuffer of a view. The images must be on texture units 0 and 1. */
  write(view: DrawView): void;
  dispose(): void;
}

const CLEAR = Float32Array.of(0, 0, 0, 0);

/**
 * Creates the images. They have 32-bit floats where these can be blended, else half floats.
 *
 * @example
 * const targets = createDepthTargets(gl);
 */
export function createDepthTargets(gl: WebGL2RenderingContext): DepthTargets {
  const isFloat = gl.getExtension('EXT_color_buffer_float') !== null && gl.getExtension('EXT_float_blend') !== null;
  const format = isFloat ? gl.RG32F : gl.RG16F;
  const textures = { mean: gl.createTexture(), front: gl.createTexture() };
  const framebuffers = { mean: gl.createFramebuffer(), front: gl.createFramebuffer() };
  const program = linkProgram(gl, FULL_VERTEX, DEPTH_FRAGMENT);
  const clipFromView = gl.getUniformLocation(program, 'clipFromView');
  const originPx = gl.getUniformLocation(program, 'originPx');
  const mean = gl.getUniformLocation(program, 'meanDepth');
  const front = gl.getUniformLocation(program, 'frontDepth');
  let width = 0;
  let height = 0;
  let isComplete = false;
  return {
    ...textures,
    resize: (widthPx, heightPx) => {
      if (widthPx === width && heightPx === height) return isComplete;
      width = widthPx;
      height = heightPx;
      gl.activeTexture(gl.TEXTURE0);
      for (const image of ['mean', 'front'] as const) {
        gl.bindTexture(gl.TEXTURE_2D, textures[image]);
        gl.texImage2D(gl.TEXTURE_2D, 0, format, width, height, 0, gl.RG, isFloat ? gl.FLOAT : gl.HALF_FLOAT, null);
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffers[image]);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, textures[image], 0);
      }
      isComplete = gl.checkFramebufferStatus(gl.FRAMEBUFFER) === gl.FRAMEBUFFER_COMPLETE;
      return isComplete;
    },
    begin: (image) => {
      setPassState(gl, framebuffers[image], null, 0, 0, width, height);
      gl.clearBufferfv(gl.COLOR, 0, CLEAR);
    },
    write: ({ view, viewport, framebuffer }) => {
      setPassState(gl, framebuffer, null, viewport.x, viewport.y, viewport.widthPx, viewport.heightPx);
      gl.useProgram(program);
      gl.uniform1i(mean, 0);
      gl.uniform1i(front, 1);
      gl.uniformMatrix4fv(clipFromView, false, view.clipFromView);
      gl.uniform2f(originPx, viewport.x, viewport.y);
      gl.enable(gl.DEPTH_TEST);
      gl.depthFunc(gl.ALWAYS);
      gl.depthMask(true);
      gl.colorMask(false, false, false, false);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      gl.colorMask(true, true, true, true);
      gl.depthFunc(gl.LESS);
      gl.disable(gl.DEPTH_TEST);
    },
    dispose: () => {
      gl.deleteProgram(program);
      for (const image of ['mean', 'front'] as const) {
        gl.deleteTexture(textures[image]);
        gl.deleteFramebuffer(framebuffers[image]);
      }
    },
  };
}
