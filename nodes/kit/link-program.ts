/**
 * Compiles two shaders and links them to a GL program. Errors are not checked: the texts must be known to compile.
 *
 * @param vertexText GLSL ES 3.00.
 * @param fragmentText GLSL ES 3.00.
 * @param feedback Outputs of the vertex shader that transform feedback writes, each to a buffer of its own.
 * @returns The caller deletes it.
 *
 * @example
 * const program = linkProgram(ctx.gl, VERTEX, FRAGMENT);
 */
export function linkProgram(
  gl: WebGL2RenderingContext,
  vertexText: string,
  fragmentText: string,
  feedback: readonly string[] = [],
): WebGLProgram {
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
  if (feedback.length > 0) gl.transformFeedbackVaryings(program, [...feedback], gl.SEPARATE_ATTRIBS);
  gl.linkProgram(program);
  return program;
}
