import { linkProgram } from '../link-program.ts';
import { setPassState } from '../pass-state.ts';
import type { DrawView } from '../runtime.ts';
import { createFloatTarget } from './float-target.ts';
import { DEPTH_FRAGMENT, FULL_VERTEX } from './splat-shaders.ts';

/** Two images of sums of depth and alpha, and the pass that makes the depth of a layer of them. */
export interface DepthTargets {
  readonly mean: WebGLTexture;
  readonly front: WebGLTexture;
  /** Makes both images large enough for a view. Returns whether they can be drawn to. */
  grow(view: DrawView): boolean;
  /** Binds an image to draw a view to it, and clears it. */
  begin(image: 'mean' | 'front', view: DrawView): void;
  /** Writes depth to the framebuffer of a view. The images must be on texture units 0 and 1. */
  write(view: DrawView): void;
  dispose(): void;
}

/**
 * Creates the images. They have 32-bit floats where these can be blended, else half floats.
 *
 * @example
 * const targets = createDepthTargets(gl);
 */
export function createDepthTargets(gl: WebGL2RenderingContext): DepthTargets {
  const isFloat = gl.getExtension('EXT_color_buffer_float') !== null && gl.getExtension('EXT_float_blend') !== null;
  const targetOf = () => createFloatTarget(gl, 2, isFloat ? gl.FLOAT : gl.HALF_FLOAT);
  const targets = { mean: targetOf(), front: targetOf() };
  const program = linkProgram(gl, FULL_VERTEX, DEPTH_FRAGMENT);
  const clipFromView = gl.getUniformLocation(program, 'clipFromView');
  const originPx = gl.getUniformLocation(program, 'originPx');
  const mean = gl.getUniformLocation(program, 'meanDepth');
  const front = gl.getUniformLocation(program, 'frontDepth');
  return {
    mean: targets.mean.texture,
    front: targets.front.texture,
    grow: ({ viewport: { widthPx, heightPx } }) => targets.mean.grow(widthPx, heightPx) && targets.front.grow(widthPx, heightPx),
    begin: (image, { viewport: { widthPx, heightPx } }) => targets[image].begin(widthPx, heightPx),
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
      targets.mean.dispose();
      targets.front.dispose();
    },
  };
}
