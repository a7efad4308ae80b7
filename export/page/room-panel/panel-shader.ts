import type { LinkedShader } from '../../program/program.ts';

/**
 * Draws a textured quad: the panel with a dot where each hand points, or a ray. `dots` are in meters from the center of the panel; the
 * third number is 0 for no dot, 1 while pointing, 2 while holding. Output is premultiplied.
 */
export const PANEL_SHADER: LinkedShader = {
  id: 'scrim:room-panel',
  vertex: /* glsl */ `#version 300 es
uniform mat4 clipFromView;
uniform mat4 viewFromWorld;
uniform mat4 worldFromQuad;
out vec2 place;
void main() {
  place = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  gl_Position = clipFromView * (viewFromWorld * (worldFromQuad * vec4(place, 0.0, 1.0)));
}
`,
  fragment: /* glsl */ `#version 300 es
precision highp float;
uniform sampler2D picture;
uniform bool isRay;
uniform vec2 halfSizeM;
uniform vec3 dots[2];
in vec2 place;
out vec4 color;
vec4 over(vec4 above, vec4 below) {
  return above + below * (1.0 - above.a);
}
void main() {
  vec2 pointM = place * halfSizeM;
  vec4 panel = texture(picture, place * 0.5 + 0.5);
  float softM = max(fwidth(pointM.x), fwidth(pointM.y));
  if (isRay) {
    color = vec4(smoothstep(1.0, 0.3, abs(place.x)) * mix(0.15, 0.85, place.y * 0.5 + 0.5));
    return;
  }
  color = panel;
  for (int i = 0; i < 2; i++) {
    if (dots[i].z < 0.5) continue;
    bool holds = dots[i].z > 1.5;
    float radiusM = holds ? 0.0035 : 0.005;
    float fromM = distance(pointM, dots[i].xy);
    vec4 ring = vec4(0.05, 0.05, 0.06, 1.0) * smoothstep(radiusM + 0.0025 + softM, radiusM + 0.0025, fromM);
    vec4 disc = vec4(holds ? vec3(1.0, 0.81, 0.36) : vec3(1.0), 1.0) * smoothstep(radiusM + softM, radiusM, fromM);
    color = over(disc, over(ring * 0.7, color));
  }
}
`,
};
