import type { LayerDepthRef } from '../../program/program.ts';

/** Numbers that decode a depth buffer. Only the first two change, which come from the projection. */
const scratchDecode = new Float32Array([0, 0, 0, 1]);
const METERS = new Float32Array([1, 0, 0, 0]);

/**
 * Sets `NAME_decode` of a depth sampler, which `scrim_meters` in `export/glsl/link/images.ts` reads: scale and offset for a texture in
 * meters, else two numbers of the projection that the depth buffer was drawn with.
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
    gl.uniform4fv(location, METERS);
  }
}
