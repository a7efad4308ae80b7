/**
 * Compiles two shaders and links them to a GL program. Errors are not checked: the texts must be known to compile.
 *
 * @param vertexText GLSL ES 3.00.
 * @param fragmentText GLSL ES 3.00.
 * @returns The caller deletes it.
 *
 * @example
 * const program = linkProgram(ctx.gl, VERTEX, FRAGMENT);
 */
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
