import type { CaptureAsset } from './capture-asset.ts';

/**
 * GLSL ES 3.00 functions over the textures of a `CaptureAsset`, for programs that draw its photographs.
 *
 * - `projectInto(view, point)`: u z, v z and z of a point in a view; z is its depth, meters; in a 360° view, its distance.
 * - `pointSeenBy(view, uv, z)`: the point that a view sees at `uv` in the depth z.
 * - `isLoaded(view)`: whether its photograph is there.
 * - `costOf(toEye, toCamera)`: how little a view suits the eye at a point, from 0 to 1, by angle and distance.
 * - `edgeOf(view, uv)`: 1 inside a photograph, falling to 0 at its edge, over a tenth of its width (feathered edges).
 * - `seenBy(view, uv, z)`: the part of five depth texels around `uv` at which the view sees depth `z`, or farther.
 * - `photoAt(view, point, uv, dx, dy)`: the photograph, read with the derivatives of its own projection.
 *
 * @example
 * const FRAGMENT = `#version 300 es\nprecision highp float;\n${CAPTURE_GLSL}\nvoid main() { … }`;
 */
export const CAPTURE_GLSL = /* glsl */ `
uniform highp sampler2D cameras;
uniform highp sampler2DArray photos;
uniform highp sampler2DArray depths;
uniform float farM;
uniform bool hasPanoramas;

const float FEATHER = 0.1;
const float DEPTH_TOLERANCE = 0.02;
// Distances count a fifth of angles, as in COLIBRI VR, whose other weights these are too.
const float RESOLUTION_WEIGHT = 0.2;
const float PI = 3.14159265;

vec3 cameraAt(int view) {
  return texelFetch(cameras, ivec2(3, view), 0).xyz;
}

bool isLoaded(int view) {
  return texelFetch(cameras, ivec2(3, view), 0).w >= 0.0;
}

bool isPanorama(int view) {
  return hasPanoramas && abs(texelFetch(cameras, ivec2(3, view), 0).w) == 1.0;
}

vec3 alongAxes(int view, vec3 point) {
  vec4 p = vec4(point, 1.0);
  return vec3(
    dot(texelFetch(cameras, ivec2(0, view), 0), p),
    dot(texelFetch(cameras, ivec2(1, view), 0), p),
    dot(texelFetch(cameras, ivec2(2, view), 0), p));
}

vec3 projectInto(int view, vec3 point) {
  vec3 p = alongAxes(view, point);
  if (!isPanorama(view)) return p;
  float distance = max(length(p), 1e-6);
  vec2 uv = vec2(atan(p.x, p.z) / (2.0 * PI), asin(clamp(p.y / distance, -1.0, 1.0)) / PI) + 0.5;
  return vec3(uv, 1.0) * distance;
}

vec3 pointSeenBy(int view, vec2 uv, float z) {
  mat3 axes = mat3(
    texelFetch(cameras, ivec2(0, view), 0).xyz,
    texelFetch(cameras, ivec2(1, view), 0).xyz,
    texelFetch(cameras, ivec2(2, view), 0).xyz);
  if (!isPanorama(view)) return cameraAt(view) + z * (inverse(transpose(axes)) * vec3(uv, 1.0));
  vec2 angles = (uv - 0.5) * vec2(2.0 * PI, PI);
  return cameraAt(view) + z * (axes * vec3(sin(angles.x) * cos(angles.y), sin(angles.y), cos(angles.x) * cos(angles.y)));
}

float costOf(vec3 toEye, vec3 toCamera) {
  float eyeDistance = length(toEye);
  float cameraDistance = length(toCamera);
  float angle = acos(clamp(dot(toEye, toCamera) / (eyeDistance * cameraDistance), -1.0, 1.0)) / PI;
  return mix(angle, max(0.0, 1.0 - eyeDistance / cameraDistance), RESOLUTION_WEIGHT);
}

float edgeOf(int view, vec2 uv) {
  if (isPanorama(view)) return 1.0;
  vec2 margin = min(uv, 1.0 - uv);
  return clamp(min(margin.x, margin.y) / FEATHER, 0.0, 1.0);
}

vec3 photoAt(int view, vec3 point, vec2 uv, vec3 dx, vec3 dy) {
  vec3 right = projectInto(view, point + dx);
  vec3 up = projectInto(view, point + dy);
  vec2 du = right.xy / right.z - uv;
  vec2 dv = up.xy / up.z - uv;
  // The left edge of a 360° photograph is beside the right one.
  du.x -= round(du.x);
  dv.x -= round(dv.x);
  return textureGrad(photos, vec3(uv, view), du, dv).rgb;
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

/** What a program that contains `CAPTURE_GLSL` reads of a capture. */
export type CaptureUsed = Pick<CaptureAsset, 'cameras' | 'photos' | 'depths' | 'farM' | 'panoramas'>;

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
export function createCaptureUse(gl: WebGL2RenderingContext, program: WebGLProgram): (capture: CaptureUsed) => void {
  const units = ['cameras', 'photos', 'depths'].map((name) => gl.getUniformLocation(program, name));
  const far = gl.getUniformLocation(program, 'farM');
  const around = gl.getUniformLocation(program, 'hasPanoramas');
  const bind = (unit: number, target: GLenum, texture: WebGLTexture): void => {
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(target, texture);
    gl.bindSampler(unit, null);
    gl.uniform1i(units[unit] ?? null, unit);
  };
  return ({ cameras, photos, depths, farM, panoramas }) => {
    gl.useProgram(program);
    bind(0, gl.TEXTURE_2D, cameras);
    bind(1, gl.TEXTURE_2D_ARRAY, photos);
    bind(2, gl.TEXTURE_2D_ARRAY, depths);
    gl.uniform1f(far, farM);
    gl.uniform1i(around, panoramas.size > 0 ? 1 : 0);
  };
}
