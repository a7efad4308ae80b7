import { linkProgram } from '../../../../nodes/kit/link-program.ts';
import { COPY_SHADER } from '../../gl/copy-shader.ts';

/** Links a program that draws a full-screen triangle and passes `viewUv` to the fragment shader. */
export function linkFullScreenProgram(gl: WebGL2RenderingContext, fragmentText: string): WebGLProgram {
  return linkProgram(gl, COPY_SHADER.vertex, fragmentText);
}
