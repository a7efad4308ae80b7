import { OCCLUSION_GLSL } from '../early-occlusion.ts';
import { HARMONICS_WORDS, SPLATS_PER_ROW, type Splats } from '../splats/splats.ts';
import { harmonicsGlsl } from './harmonics-glsl.ts';

/**
 * What a program writes. `color`: premultiplied color. `depth`: depth and alpha, both times alpha, so that blending gives their sums.
 * `front`: the same for what is not behind the mean depth of the pixel.
 */
export type SplatOutput = 'color' | 'depth' | 'front';

/** What is nearer is not drawn, meters. */
const NEAR_M = '0.2';

/** Instances of a few vertices leave most of a graphics card idle. */
export const SPLATS_PER_INSTANCE = 128;

export interface SplatProgramOptions {
  readonly degree: Splats['degree'];
  readonly antialiased: boolean;
  /** Whether room depth hides fragments. */
  readonly occluded: boolean;
  readonly output: SplatOutput;
}

/**
 * A quad per splat. The covariance is projected by the Jacobian of the projection at the center of the splat (Zwicker et al., “EWA Splatting”,
 * 2002), and widened by 0.3 pixels² on each axis; both as in Kerbl et al. 2023, whose constants these are. The quad has the axes of the
 * ellipse, and ends where alpha falls below 1/255.
 *
 * The depth of a fragment is the mean depth of the projected Gaussian there, which is linear over the quad: for a flat splat it is the depth
 * of its plane.
 */
export function splatVertexShader({ degree, antialiased, output }: SplatProgramOptions): string {
  return /* glsl */ `#version 300 es
precision highp float;
precision highp int;
precision highp usampler2D;
uniform usampler2D order;
uniform int count;
uniform usampler2D data;
uniform mat4 viewFromSplats;
uniform mat4 clipFromView;
uniform vec2 viewPx;
uniform vec3 eye;
out vec2 at;
flat out vec4 look;
flat out vec3 depthM;
${output === 'color' && degree > 0 ? harmonicsGlsl(degree) : ''}
const float NEAR_M = ${NEAR_M};
const float LOW_PASS = 0.3;
const float LEAST_ALPHA = 1.0 / 255.0;
// Beyond this multiple of the field of view the Jacobian is that of its border.
const float WIDEST = 1.3;

/** The rotation of a splat from its three smallest components, of 15 bits, and the index of the largest. */
mat3 rotationOf(uvec3 bits) {
  vec3 kept = (vec3(bits & 32767u) / 32767.0 * 2.0 - 1.0) * 0.70710678;
  uint largest = (bits.x >> 15) | ((bits.y >> 15) << 1);
  float rest = sqrt(max(0.0, 1.0 - dot(kept, kept)));
  vec4 q = largest == 0u ? vec4(rest, kept) : largest == 1u ? vec4(kept.x, rest, kept.yz)
    : largest == 2u ? vec4(kept.xy, rest, kept.z) : vec4(kept, rest);
  vec3 d = q.xyz * q.xyz;
  vec3 p = q.xyz * q.yzx;
  vec3 w = q.xyz * q.w;
  return mat3(
    1.0 - 2.0 * (d.y + d.z), 2.0 * (p.x + w.z), 2.0 * (p.z - w.y),
    2.0 * (p.x - w.z), 1.0 - 2.0 * (d.x + d.z), 2.0 * (p.y + w.x),
    2.0 * (p.z + w.y), 2.0 * (p.y - w.x), 1.0 - 2.0 * (d.x + d.y));
}

void main() {
  // Outside of the view, for splats that are not drawn.
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  at = vec2(0.0);
  look = vec4(0.0);
  depthM = vec3(0.0);
  int place = gl_InstanceID * ${SPLATS_PER_INSTANCE} + (gl_VertexID >> 2);
  if (place >= count) return;
  int index = int(texelFetch(order, ivec2(place % ${SPLATS_PER_ROW}, place / ${SPLATS_PER_ROW}), 0).r);
  ivec2 texel = ivec2(2 * (index % ${SPLATS_PER_ROW}), index / ${SPLATS_PER_ROW});
  uvec4 first = texelFetch(data, texel, 0);
  uvec4 second = texelFetch(data, texel + ivec2(1, 0), 0);
  vec3 center = uintBitsToFloat(first.xyz);
  vec3 view = (viewFromSplats * vec4(center, 1.0)).xyz;
  float z = -view.z;
  if (z < NEAR_M) return;

  // M maps a unit ball to the splat in view space; M transposed of a direction is its spread along the axes of the splat.
  vec3 scale = vec3(unpackHalf2x16(second.y), unpackHalf2x16(second.z).x);
  mat3 m = mat3(viewFromSplats) * rotationOf(uvec3(second.z >> 16, second.w & 65535u, second.w >> 16));
  m = mat3(m[0] * scale.x, m[1] * scale.y, m[2] * scale.z);
  vec2 focal = vec2(clipFromView[0][0], clipFromView[1][1]);
  vec2 middle = clipFromView[2].xy;
  vec2 slope = clamp(view.xy / z, (middle - WIDEST) / focal, (middle + WIDEST) / focal);
  vec2 focalPx = 0.5 * focal * viewPx;
  vec3 right = vec3(focalPx.x / z, 0.0, focalPx.x * slope.x / z) * m;
  vec3 up = vec3(0.0, focalPx.y / z, focalPx.y * slope.y / z) * m;
  vec3 away = vec3(0.0, 0.0, -1.0) * m;
  float xx = dot(right, right);
  float xy = dot(right, up);
  float yy = dot(up, up);
  float opacity = float(second.x >> 16) / 65535.0;
  ${antialiased ? 'float sharp = xx * yy - xy * xy;' : ''}
  xx += LOW_PASS;
  yy += LOW_PASS;
  ${antialiased ? 'opacity *= sqrt(max(0.0, sharp / (xx * yy - xy * xy)));' : ''}
  if (opacity < LEAST_ALPHA) return;
  float reach = sqrt(2.0 * log(opacity / LEAST_ALPHA));
  vec2 ndc = focal * view.xy / z - middle;
  vec2 halfSize = 2.0 * reach * sqrt(vec2(xx, yy)) / viewPx;
  if (any(greaterThan(abs(ndc) - halfSize, vec2(1.0)))) return;

  float mean = 0.5 * (xx + yy);
  float apart = length(vec2(0.5 * (xx - yy), xy));
  vec2 axis = xx >= yy ? vec2(mean + apart - yy, xy) : vec2(xy, mean + apart - xx);
  axis = apart < 1e-6 * mean ? vec2(1.0, 0.0) : normalize(axis);
  vec2 major = axis * sqrt(mean + apart);
  vec2 minor = vec2(-axis.y, axis.x) * sqrt(max(mean - apart, LOW_PASS));
  vec2 corner = vec2(gl_VertexID & 1, (gl_VertexID >> 1) & 1) * 2.0 - 1.0;
  at = corner * reach;
  gl_Position = vec4(ndc + 2.0 * (major * at.x + minor * at.y) / viewPx, 0.0, 1.0);
  vec2 along = vec2(dot(right, away), dot(up, away));
  depthM = vec3(z, dot(along, major) / dot(major, major), dot(along, minor) / dot(minor, minor));
  vec3 color = vec3(unpackHalf2x16(first.w), unpackHalf2x16(second.x).x);
  ${output === 'color' && degree > 0 ? `color += harmonicsAt(ivec2(${HARMONICS_WORDS[degree] / 4} * (index % ${SPLATS_PER_ROW}), texel.y), normalize(center - eye));` : ''}
  look = vec4(max(color, 0.0), opacity);
}`;
}

/** Alpha of a fragment, at most 0.99 as in Kerbl et al. 2023. */
export function splatFragmentShader({ occluded, output }: SplatProgramOptions): string {
  return /* glsl */ `#version 300 es
precision highp float;
in vec2 at;
flat in vec4 look;
// The depth of the center, and how it grows along both axes, per standard deviation; meters.
flat in vec3 depthM;
${output === 'front' ? 'uniform sampler2D meanDepth;' : ''}
uniform vec2 originPx;
out vec4 result;
${occluded ? OCCLUSION_GLSL : ''}
void main() {
  float alpha = min(0.99, look.a * exp(-0.5 * dot(at, at)));
  if (alpha < 1.0 / 255.0) discard;
  // A splat that reaches past the eye would have depths behind it.
  float z = max(depthM.x + dot(depthM.yz, at), ${NEAR_M});
  ${occluded ? `alpha *= scrimVisibility((gl_FragCoord.xy - originPx) / scrimViewPx, z);\n  if (alpha <= 0.0) discard;` : ''}
  ${output === 'front' ? 'vec2 sums = texelFetch(meanDepth, ivec2(gl_FragCoord.xy), 0).rg;\n  if (z * sums.g > sums.r) discard;' : ''}
  result = ${output === 'color' ? 'vec4(look.rgb * alpha, alpha)' : 'vec4(z * alpha, alpha, 0.0, alpha)'};
}`;
}

/** A triangle over the view. */
export const FULL_VERTEX = /* glsl */ `#version 300 es
void main() {
  gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}`;

/** Copies blended colors, which become bytes. */
export const COLOR_FRAGMENT = /* glsl */ `#version 300 es
precision highp float;
uniform sampler2D sums;
uniform vec2 originPx;
out vec4 color;
void main() {
  color = texelFetch(sums, ivec2(gl_FragCoord.xy - originPx), 0);
}`;

/**
 * Writes the depth of a layer where the splats cover at least half: the mean depth of those in front of the mean of all, if they alone cover
 * half, else of those behind it. So a pixel that shows a near and a far surface has the depth of one of them, never one between.
 */
export const DEPTH_FRAGMENT = /* glsl */ `#version 300 es
precision highp float;
uniform sampler2D meanDepth;
uniform sampler2D frontDepth;
uniform mat4 clipFromView;
uniform vec2 originPx;
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy - originPx);
  vec2 all = texelFetch(meanDepth, pixel, 0).rg;
  vec2 front = texelFetch(frontDepth, pixel, 0).rg;
  if (all.g < 0.5) discard;
  vec2 chosen = front.g >= 0.5 ? front : all - front;
  if (chosen.g < 0.01) chosen = all;
  float z = chosen.r / chosen.g;
  gl_FragDepth = 0.5 * (clipFromView[3].z - clipFromView[2].z * z) / z + 0.5;
}`;
