import { linkProgram } from '../../../../nodes/kit/link-program.ts';
import { COPY_SHADER } from '../../gl/copy-shader.ts';

/** A program that draws one full-screen triangle; `viewUv` is what its fragments know of where they are. */
export function linkPass(gl: WebGL2RenderingContext, fragmentText: string): WebGLProgram {
  return linkProgram(gl, COPY_SHADER.vertex, fragmentText);
}
