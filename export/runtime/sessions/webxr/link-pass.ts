import { COPY_SHADER } from '../../gl/copy-shader.ts';

/** A program that draws one full-screen triangle; `viewUv` is what its fragments know of where they are. */
export function linkPass(gl: WebGL2RenderingContext, fragmentText: string): WebGLProgram {
  return linkProgram(gl, COPY_SHADER.vertex, fragmentText);
}

export function linkProgram(gl: WebGL2RenderingContext, vertexText: string, fragmentText: string): WebGLProgram {
  const program = gl.createProgram();
  for (const [type, text] of [
    [gl.VERTEX_SHADER, vertexText],
    [gl.FRAGMENT_SHADER, fragmentText],
  ] as const) {
    const shader = gl.createShader(type);
    if (!shader) continue;
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
    gl.deleteShader(shader);
  }
  gl.linkProgram(program);
  return program;
}
