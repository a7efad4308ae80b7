import { linkProgram } from '../link-program.ts';
import { setPassState } from '../pass-state.ts';
import type { DrawView } from '../runtime.ts';
import { createFloatTarget } from './float-target.ts';
import { COLOR_FRAGMENT, FULL_VERTEX } from './splat-shaders.ts';

/** The image in which the colors of splats are blended before they become bytes. */
export interface ColorTarget {
  /** Binds the image to draw a view to it, and clears it. Returns false where half floats cannot be drawn to. */
  begin(view: DrawView): boolean;
  /** Writes the colors to the framebuffer of a view. */
  write(view: DrawView): void;
  dispose(): void;
}

/**
 * Creates the image, of half floats. Trained splats have colors above 1, which others in front of them darken: a sum in bytes loses what is
 * above 1, and rounds once per splat.
 *
 * @example
 * const target = createColorTarget(gl);
 */
export function createColorTarget(gl: WebGL2RenderingContext): ColorTarget {
  // Either extension allows half floats as targets.
  gl.getExtension('EXT_color_buffer_float') ?? gl.getExtension('EXT_color_buffer_half_float');
  const target = createFloatTarget(gl, 4, gl.HALF_FLOAT);
  const program = linkProgram(gl, FULL_VERTEX, COLOR_FRAGMENT);
  const originPx = gl.getUniformLocation(program, 'originPx');
  const sums = gl.getUniformLocation(program, 'sums');
  return {
    begin: ({ viewport: { widthPx, heightPx } }) => {
      if (!target.grow(widthPx, heightPx)) return false;
      target.begin(widthPx, heightPx);
      return true;
    },
    write: ({ framebuffer, viewport }) => {
      setPassState(gl, framebuffer, null, viewport.x, viewport.y, viewport.widthPx, viewport.heightPx);
      gl.useProgram(program);
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, target.texture);
      gl.uniform1i(sums, 0);
      gl.uniform2f(originPx, viewport.x, viewport.y);
      gl.enable(gl.BLEND);
      gl.blendEquation(gl.FUNC_ADD);
      gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      gl.disable(gl.BLEND);
    },
    dispose: () => {
      gl.deleteProgram(program);
      target.dispose();
    },
  };
}
