import type { CaptureAsset } from './capture-asset.ts';

/**
 * GLSL ES 3.00 functions over the textures of a `CaptureAsset`, for programs that draw its photographs.
 *
 * - `projectInto(view, point)`: u z, v z and z of a point in a view; z is its depth, meters.
 * - `insideOf(uv)`: 1 inside a photograph, falling to 0 at its edge, over a tenth of its width (feathered edges).
 * - `seenBy(view, uv, z)`: the part of five depth texels around `uv` at which the view sees depth `z`, or farther.
 *
 * @example
 * const FRAGMENT = `#version 300 es\nprecision highp float;\n${CAPTURE_GLSL}\nvoid main() { … }`;
 */
export const CAPTURE_GLSL = `
uniform highp sampler2D cameras;
uniform highp sampler2DArray photos;
uniform highp sampler2DArray depths;
uniform float farM;

const float FEATHER = 0.1;
const float DEPTH_TOLERANCE = 0.02;

vec3 projectInto(int view, vec3 point) {
  vec4 p = vec4(point, 1.0);
  return vec3(
    dot(texelFetch(cameras, ivec2(0, view), 0), p),
    dot(texelFetch(cameras, ivec2(1, view), 0), p),
    dot(texelFetch(cameras, ivec2(2, view), 0), p));
}

vec3 cameraAt(int view) {
  return texelFetch(cameras, ivec2(3, view), 0).xyz;
}

float insideOf(vec2 uv) {
  vec2 margin = min(uv, 1.0 - uv);
  return clamp(min(margin.x, margin.y) / FEATHER, 0.0, 1.0);
}

float agrees(int view, vec2 uv, float z) {
  float seen = texture(depths, vec3(uv, view)).r * farM;
  return step(abs(z - seen), DEPTH_TOLERANCE * z);
}

float seenBy(int view, vec2 uv, float z) {
  vec2 texel = 1.0 / vec2(textureSize(depths, 0).xy);
  float sum = agrees(view, uv, z);
  sum += agrees(view, uv + texel * vec2(1.0, 1.0), z) + agrees(view, uv + texel * vec2(-1.0, 1.0), z);
  sum += agrees(view, uv + texel * vec2(1.0, -1.0), z) + agrees(view, uv + texel * vec2(-1.0, -1.0), z);
  return sum * 0.2;
}
`;

/**
 * Prepares a program that contains `CAPTURE_GLSL`.
 *
 * @param program A linked program.
 * @returns A function that activates the program with a capture, on texture units 0 to 2.
 *
 * @example
 * const use = createCaptureUse(gl, program);
 * use(capture);
 */
export function createCaptureUse(gl: WebGL2RenderingContext, program: WebGLProgram): (capture: CaptureAsset) => void {
  const units = ['cameras', 'photos', 'depths'].map((name) => gl.getUniformLocation(program, name));
  const far = gl.getUniformLocation(program, 'farM');
  const bind = (unit: number, target: GLenum, texture: WebGLTexture): void => {
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(target, texture);
    gl.bindSampler(unit, null);
    gl.uniform1i(units[unit] ?? null, unit);
  };
  return ({ cameras, photos, depths, farM }) => {
    gl.useProgram(program);
    bind(0, gl.TEXTURE_2D, cameras);
    bind(1, gl.TEXTURE_2D_ARRAY, photos);
    bind(2, gl.TEXTURE_2D_ARRAY, depths);
    gl.uniform1f(far, farM);
  };
}
