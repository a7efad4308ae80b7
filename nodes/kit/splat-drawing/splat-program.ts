import type { OcclusionView } from '../early-occlusion.ts';
import { linkProgram } from '../link-program.ts';
import type { DrawView } from '../runtime.ts';
import type { SplatAsset } from '../splat-asset.ts';
import { createOcclusionUse } from './occlusion-use.ts';
import { type SplatOutput, splatFragmentShader, splatVertexShader } from './splat-shaders.ts';

/** Texture units of a splat program. */
export const SPLAT_UNITS = { data: 0, harmonics: 1, meanDepth: 2, room: 3, order: 4 } as const;

/** A GL program that draws splats. */
export interface SplatProgram {
  /**
   * Activates the program and writes its uniforms.
   *
   * @param originX Left edge of the view in the framebuffer, pixels; `originY` is its bottom edge.
   */
  use(view: DrawView, viewFromSplats: Float32Array, eye: Float32Array, originX: number, originY: number): void;
  dispose(): void;
}

interface ProgramOptions {
  readonly output: SplatOutput;
  readonly antialiased: boolean;
  readonly occlusion: OcclusionView | null;
  /** A texture that stands for room depth where there is none. */
  readonly empty: WebGLTexture;
}

/**
 * Creates a program for some splats.
 *
 * @example
 * const program = createSplatProgram(gl, splats, { output: 'color', antialiased: false, occlusion: null, empty });
 */
export function createSplatProgram(gl: WebGL2RenderingContext, splats: SplatAsset, options: ProgramOptions): SplatProgram {
  const { output, antialiased, occlusion, empty } = options;
  const shader = { degree: splats.degree, antialiased, occluded: occlusion !== null, output };
  const program = linkProgram(gl, splatVertexShader(shader), splatFragmentShader(shader));
  const at = (name: string) => gl.getUniformLocation(program, name);
  const viewFromSplatsAt = at('viewFromSplats');
  const clipFromView = at('clipFromView');
  const viewPx = at('viewPx');
  const eyeAt = at('eye');
  const originPx = at('originPx');
  const order = at('order');
  const count = at('count');
  const data = at('data');
  const harmonics = at('harmonics');
  const meanDepth = at('meanDepth');
  const ranges = at('ranges');
  const useOcclusion = occlusion && createOcclusionUse(gl, program, occlusion, SPLAT_UNITS.room, empty);
  return {
    use: (view, viewFromSplats, eye, originX, originY) => {
      gl.useProgram(program);
      gl.uniform1i(order, SPLAT_UNITS.order);
      gl.uniform1i(count, splats.count);
      gl.uniform1i(data, SPLAT_UNITS.data);
      gl.uniform1i(harmonics, SPLAT_UNITS.harmonics);
      gl.uniform1i(meanDepth, SPLAT_UNITS.meanDepth);
      gl.uniform3f(ranges, splats.ranges[0], splats.ranges[1], splats.ranges[2]);
      gl.uniformMatrix4fv(viewFromSplatsAt, false, viewFromSplats);
      gl.uniformMatrix4fv(clipFromView, false, view.view.clipFromView);
      gl.uniform2f(viewPx, view.viewport.widthPx, view.viewport.heightPx);
      gl.uniform3fv(eyeAt, eye);
      gl.uniform2f(originPx, originX, originY);
      useOcclusion?.(view);
    },
    dispose: () => gl.deleteProgram(program),
  };
}
