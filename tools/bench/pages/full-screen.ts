/** The vertex shader of a triangle that covers the view. `at` is the position on the view, from (0, 0) to (1, 1). */
export const FULL_SCREEN = `#version 300 es
out vec2 at;
void main() {
  at = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
  gl_Position = vec4(at * 2.0 - 1.0, 0.0, 1.0);
}`;
