import type { OcclusionView } from '../early-occlusion.ts';
import type { DrawView } from '../runtime.ts';

/**
 * Prepares a program that contains `OCCLUSION_GLSL`.
 *
 * @param unit The texture unit of the room depth.
 * @param empty A texture that stands for room depth where there is none.
 * @returns A function that writes the uniforms for a view; the program must be active.
 *
 * @example
 * const use = createOcclusionUse(gl, program, ctx.occlusion, 3, empty);
 */
export function createOcclusionUse(
  gl: WebGL2RenderingContext,
  program: WebGLProgram,
  { roomDepth, params: { softnessM, biasM, borderPx } }: OcclusionView,
  unit: number,
  empty: WebGLTexture,
): (view: DrawView) => void {
  const texture = gl.getUniformLocation(program, 'scrimRoomDepth');
  const uv = gl.getUniformLocation(program, 'scrimRoomUvFromViewUv');
  const occlusion = gl.getUniformLocation(program, 'scrimOcclusion');
  const viewPx = gl.getUniformLocation(program, 'scrimViewPx');
  return ({ viewIndex, viewport }) => {
    const depth = roomDepth.views[viewIndex] ?? null;
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, depth?.texture ?? empty);
    gl.uniform1i(texture, unit);
    const reading = depth?.texture ? (depth.interpolate ? 2 : 1) : 0;
    gl.uniform4f(occlusion, reading, softnessM?.value ?? 0, biasM?.value ?? 0, (borderPx?.value ?? 0) / 2);
    gl.uniform2f(viewPx, viewport.widthPx, viewport.heightPx);
    if (depth) gl.uniformMatrix3fv(uv, false, depth.uvFromViewUv);
  };
}
