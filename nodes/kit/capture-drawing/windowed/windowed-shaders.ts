import { choiceOfViews, headOf } from '../shaders.ts';

/** Number of photographs that each vertex tests, and that have a part of a varying each. */
export const MOST_KEPT_VIEWS = 16;
/** The most photographs that a vertex has weights of: what its list holds. */
export const MOST_BLENDED = 4;
/** A list: four views and their weights, 16 bits each. */
export const LIST_BYTES = 16;

/** Computes the list of each vertex, for transform feedback. Weights add up to 1; all are 0 where no photograph sees the vertex. */
export function updateVertex(blended: number): string {
  return /* glsl */ `${headOf(MOST_KEPT_VIEWS)}${choiceOfViews(blended, false)}
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
flat out highp uvec4 list;
void main() {
  vec3 toEye = eye - position;
  float side = dot(normal, toEye);
  int best[BLENDED + 1];
  float weights[BLENDED];
  chooseViews(position, side == 0.0 ? toEye : normal * sign(side), toEye, best, weights);
  float sum = 0.0;
  for (int i = 0; i < BLENDED; i++) sum += weights[i];
  uvec4 chosen = uvec4(0u);
  vec4 shares = vec4(0.0);
  for (int i = 0; i < BLENDED; i++) {
    if (weights[i] <= 0.0) continue;
    chosen[i] = uint(best[i]);
    shares[i] = weights[i] / sum;
  }
  list = uvec4(chosen.x | chosen.y << 16, chosen.z | chosen.w << 16, packUnorm2x16(shares.xy), packUnorm2x16(shares.zw));
  gl_Position = vec4(0.0);
}`;
}

export const UPDATE_FRAGMENT = /* glsl */ `#version 300 es
precision highp float;
void main() {}`;

/**
 * Spreads the list of a vertex over the views of this frame, so that the weights of all views are interpolated over a triangle, whichever
 * of its vertices has them. What a vertex has of views that are no longer drawn goes to its others.
 */
export const WINDOWED_VERTEX = /* glsl */ `#version 300 es
precision highp float;
precision highp int;
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 color;
layout(location = 2) in uvec4 list;
uniform mat4 clipFromCapture;
uniform int views[${MOST_KEPT_VIEWS}];
uniform int viewCount;
out vec3 point;
out vec3 plainColor;
out vec4 shares[${MOST_KEPT_VIEWS / 4}];
void main() {
  point = position;
  plainColor = color.rgb;
  gl_Position = clipFromCapture * vec4(position, 1.0);
  ivec4 chosen = ivec4(list.x & 65535u, list.x >> 16, list.y & 65535u, list.y >> 16);
  vec4 weights = vec4(unpackUnorm2x16(list.z), unpackUnorm2x16(list.w));
  float spread[${MOST_KEPT_VIEWS}];
  float sum = 0.0;
  for (int i = 0; i < ${MOST_KEPT_VIEWS}; i++) {
    // A vertex has each view once, and an empty place has the weight 0.
    spread[i] = i < viewCount ? dot(weights, vec4(equal(chosen, ivec4(views[i])))) : 0.0;
    sum += spread[i];
  }
  float kept = sum > 0.0 ? dot(weights, vec4(1.0)) / sum : 0.0;
  for (int i = 0; i < ${MOST_KEPT_VIEWS / 4}; i++) shares[i] = kept * vec4(spread[4 * i], spread[4 * i + 1], spread[4 * i + 2], spread[4 * i + 3]);
}`;

/** Blends the photographs by the weights of the vertices; the colors of the mesh take what no photograph sees. */
export const WINDOWED_FRAGMENT = /* glsl */ `${headOf(MOST_KEPT_VIEWS)}
in vec3 point;
in vec3 plainColor;
in vec4 shares[${MOST_KEPT_VIEWS / 4}];
out vec4 color;
void main() {
  vec3 dx = dFdx(point);
  vec3 dy = dFdy(point);
  vec4 sum = vec4(0.0);
  float seen = 0.0;
  for (int i = 0; i < viewCount; i++) {
    float weight = shares[i >> 2][i & 3];
    if (weight <= 0.0) continue;
    seen += weight;
    int view = views[i];
    vec3 p = projectInto(view, point);
    if (p.z <= 0.0) continue;
    vec2 uv = p.xy / p.z;
    weight *= edgeOf(view, uv);
    if (weight <= 0.0) continue;
    sum += weight * vec4(photoAt(view, point, uv, dx, dy), 1.0);
  }
  color = vec4(sum.a > 0.0 ? mix(plainColor, sum.rgb / sum.a, min(1.0, seen)) : plainColor, 1.0);
}`;
