import { CAPTURE_GLSL } from '../../capture-glsl.ts';

const HEAD = /* glsl */ `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2DArray;
`;

/**
 * Moves all points towards the eye by a share of their distance. They stay at their pixel, and the depth test becomes soft: it lets pass
 * what is behind the nearest surface by less than that share.
 */
const NEARER = /* glsl */ `
uniform mat4 clipFromCapture;
uniform vec3 eye;
uniform float nearer;
out vec3 point;
vec4 clipOf(vec3 at) {
  return clipFromCapture * vec4(mix(at, eye, nearer), 1.0);
}
`;

/** Draws a depth mesh, whose vertices are pixels of the map of a view; a hidden mesh with colors. */
function viewVertex(colored: boolean): string {
  return /* glsl */ `${HEAD}${CAPTURE_GLSL}${NEARER}
layout(location = 0) in uvec2 place;
layout(location = 1) in float depthM;
${colored ? 'layout(location = 2) in vec4 color;\nout vec3 plainColor;' : ''}
uniform int view;
/** Twice the size of the map. */
uniform vec2 mapSize;
void main() {
  vec2 uv = vec2(place) / mapSize;
  point = pointSeenBy(view, vec2(uv.x, 1.0 - uv.y), depthM);
  gl_Position = clipOf(point);
  ${colored ? 'plainColor = color.rgb;' : ''}
}`;
}

export const VIEW_VERTEX = viewVertex(false);
export const HIDDEN_VERTEX = viewVertex(true);

/** Writes the color of a hidden mesh with a weight of 1. */
export const HIDDEN_FRAGMENT = /* glsl */ `${HEAD}
in vec3 plainColor;
out vec4 color;
void main() { color = vec4(plainColor, 1.0); }`;

/** Draws the mesh of the place. */
export const PLACE_VERTEX = /* glsl */ `${HEAD}${NEARER}
layout(location = 0) in vec3 position;
void main() {
  point = position;
  gl_Position = clipOf(position);
}`;

/** Writes depth only. */
export const DEPTH_FRAGMENT = /* glsl */ `${HEAD}
void main() {}`;

/** How steeply weights fall with the cost. A lumigraph, which knows all costs of a pixel, takes the two best; a sum must weigh them so. */
const STEEPNESS = '3.0';
const HALF_COST = '0.01';
/** Weights are 16-bit floats in the sum: the largest is far below their limit, and the smallest keeps all bits of a color. */
const MOST_WEIGHT = '1000.0';
const LEAST_WEIGHT = '1.0';

/** Adds a photograph: color times weight, and the weight in alpha. */
export const VIEW_FRAGMENT = /* glsl */ `${HEAD}${CAPTURE_GLSL}
uniform vec3 eye;
uniform int view;
in vec3 point;
out vec4 color;
void main() {
  vec3 p = projectInto(view, point);
  vec2 uv = p.xy / p.z;
  vec3 toEye = eye - point;
  vec3 toCamera = cameraAt(view) - point;
  float cost = costOf(toEye, toCamera);
  float weight = ${MOST_WEIGHT} * edgeOf(view, uv) * pow(${HALF_COST} / (${HALF_COST} + cost), ${STEEPNESS});
  color = vec4(photoAt(view, point, uv, dFdx(point), dFdy(point)), 1.0) * max(weight, ${LEAST_WEIGHT});
}`;

export const SCREEN_VERTEX = /* glsl */ `${HEAD}
void main() {
  gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}`;

/**
 * Divides the sum by its weight, and writes a factor times the depth of the nearest surface. Where hidden meshes are drawn, they have the
 * farther half of all depths.
 */
export const RESOLVE_FRAGMENT = /* glsl */ `${HEAD}
uniform highp sampler2D sum;
uniform highp sampler2D depth;
uniform ivec2 origin;
uniform float depthFactor;
uniform bool hasHidden;
out vec4 color;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy) - origin;
  vec4 added = texelFetch(sum, at, 0);
  if (added.a <= 0.0) discard;
  color = vec4(added.rgb / added.a, 1.0);
  float window = texelFetch(depth, at, 0).r;
  if (hasHidden) window = 2.0 * window - (window < 0.5 ? 0.0 : 1.0);
  gl_FragDepth = depthFactor * window;
}`;
