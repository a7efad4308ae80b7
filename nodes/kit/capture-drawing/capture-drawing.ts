import type { CaptureAsset } from '../capture-asset.ts';
import { createCaptureUse } from '../capture-glsl.ts';
import { linkProgram } from '../link-program.ts';
import type { DrawView } from '../runtime.ts';
import { createNearestViews } from './nearest-views.ts';
import { fragmentOf, type Method, MOST_VIEWS, VERTEX } from './shaders.ts';

/** Where a capture is drawn. A drawing that keeps something from frame to frame keeps it for each `viewIndex`; absent: 0. */
export type CaptureTarget = Pick<DrawView, 'framebuffer' | 'viewport'> & { readonly viewIndex?: number };

/** Draws a capture by one method. */
export interface CaptureDrawing {
  /**
   * Draws color and depth to the bound framebuffer.
   *
   * @param clipFromCapture Column-major 4×4.
   * @param eye Position in the space of the capture.
   * @param forward Unit vector in the space of the capture.
   * @param target The bound framebuffer, and the part of it that is drawn to.
   * @param excluded View whose photograph is left out; -1: none.
   */
  draw(clipFromCapture: Float32Array, eye: Float32Array, forward: Float32Array, target: CaptureTarget, excluded?: number): void;
  dispose(): void;
}

/**
 * Creates the program of a method.
 *
 * @param blended Number of photographs per pixel (lumigraph).
 *
 * @example
 * const drawing = createCaptureDrawing(gl, capture, 'lumigraph', 2);
 * drawing.draw(clipFromCapture, eye, forward, view);
 */
export function createCaptureDrawing(gl: WebGL2RenderingContext, capture: CaptureAsset, method: Method, blended: number): CaptureDrawing {
  const program = linkProgram(gl, VERTEX, fragmentOf(method, blended));
  const use = createCaptureUse(gl, program);
  const nearest = createNearestViews(capture, MOST_VIEWS);
  const matrix = gl.getUniformLocation(program, 'clipFromCapture');
  const eyeAt = gl.getUniformLocation(program, 'eye');
  const views = gl.getUniformLocation(program, 'views');
  const viewCount = gl.getUniformLocation(program, 'viewCount');
  return {
    draw: (clipFromCapture, eye, forward, _target, excluded) => {
      nearest.choose(eye, forward, excluded);
      use(capture);
      gl.uniformMatrix4fv(matrix, false, clipFromCapture);
      gl.uniform3fv(eyeAt, eye);
      gl.uniform1iv(views, nearest.views);
      gl.uniform1i(viewCount, nearest.count);
      drawTriangles(gl, capture.vertexArray, capture.indexCount);
    },
    dispose: () => gl.deleteProgram(program),
  };
}

/** Draws the triangles of a mesh by the active program, with depth. */
export function drawTriangles(gl: WebGL2RenderingContext, vertexArray: WebGLVertexArrayObject, indexCount: number): void {
  gl.enable(gl.DEPTH_TEST);
  gl.depthFunc(gl.LEQUAL);
  gl.depthMask(true);
  gl.bindVertexArray(vertexArray);
  gl.drawElements(gl.TRIANGLES, indexCount, gl.UNSIGNED_INT, 0);
  gl.bindVertexArray(null);
  gl.depthFunc(gl.LESS);
  gl.disable(gl.DEPTH_TEST);
}
