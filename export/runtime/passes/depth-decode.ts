import type { LayerDepthRef } from '../../program/program.ts';

/** Only the first two numbers change. */
const scratchDecode = new Float32Array([0, 0, 0, 1]);
const METRES = new Float32Array([1, 0, 0, 0]);

/**
 * `NAME_decode` of a depth sampler: with the texture's red channel `d`, metres are `d * x + y` where `w` is 0 (depth in
 * metres: 1, 0), else `y / (2 d - 1 + x)`, and 0 where `d` is 1: nothing was drawn.
 *
 * Window depth comes from the view's projection: clip z = p10 * z + p14 and clip w = -z, so with m = -z metres,
 * 2 d - 1 = -p10 + p14 / m. That holds for off-axis and infinite projections alike.
 */
export function setDecode(
  gl: WebGL2RenderingContext,
  location: WebGLUniformLocation,
  encoding: LayerDepthRef['encoding'],
  clipFromView: Float32Array | undefined,
): void {
  if (encoding === 'window' && clipFromView) {
    scratchDecode[0] = clipFromView[10] ?? 0;
    scratchDecode[1] = clipFromView[14] ?? 0;
    gl.uniform4fv(location, scratchDecode);
  } else {
    gl.uniform4fv(location, METRES);
  }
}
