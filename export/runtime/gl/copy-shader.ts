import type { LayerEncoding } from '../../../nodes/kit/definition.ts';
import type { LinkedShader } from '../../program/program.ts';

// Marked as pure, so that a page contains the shaders that it uses.
const COPY_VERTEX = /* @__PURE__ */ vertexShader('', 'vec4(viewUv * 2.0 - 1.0, 0.0, 1.0)');
/** The fragment shader of `COPY_SHADER`. */
export const COPY_FRAGMENT = /* @__PURE__ */ fragmentShader('  color = texture(picture, uv.xy / uv.z);');

/**
 * Copies an image through its UV matrix. Used for the camera image in the background, for passes whose shader does not compile, and for
 * readback of layers.
 */
export const COPY_SHADER: LinkedShader = {
  id: 'scrim:copy',
  vertex: COPY_VERTEX,
  fragment: COPY_FRAGMENT,
};

/** Copies a scene layer as a display layer, clamped, so that it can be shown. Transfer function: IEC 61966-2-1. */
export const COPY_SCENE_SHADER: LinkedShader = {
  id: 'scrim:copy-scene',
  vertex: COPY_VERTEX,
  fragment: /* @__PURE__ */ fragmentShader(`  vec4 light = texture(picture, uv.xy / uv.z);
  vec3 straight = clamp(light.rgb / max(light.a, 0.0001), 0.0, 1.0);
  vec3 display = mix(1.055 * pow(straight, vec3(1.0 / 2.4)) - 0.055, straight * 12.92, vec3(lessThanEqual(straight, vec3(0.0031308))));
  color = vec4(display * light.a, light.a);`),
};

/** The shader that copies the layer in a target for display, by the layer's encoding. */
export function copyShaderFor(encoding: LayerEncoding): LinkedShader {
  return encoding === 'scene' ? COPY_SCENE_SHADER : COPY_SHADER;
}

export const COPY_SAMPLER = 'picture';
export const COPY_UV = 'picture_uvFromViewUv';

/** The vertex shader of a copy: a triangle over the viewport. */
export function vertexShader(declarations: string, position: string): string {
  return /* glsl */ `#version 300 es
out vec2 viewUv;
${declarations}void main() {
  viewUv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
  gl_Position = ${position};
}
`;
}

function fragmentShader(statements: string): string {
  return /* glsl */ `#version 300 es
precision highp float;
uniform highp sampler2D picture;
uniform mat3 picture_uvFromViewUv;
in vec2 viewUv;
out vec4 color;
void main() {
  vec3 uv = picture_uvFromViewUv * vec3(viewUv, 1.0);
${statements}
}
`;
}
