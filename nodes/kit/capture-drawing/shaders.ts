import { CAPTURE_GLSL } from '../capture-glsl.ts';

/** How a capture is drawn: the param of the node Capture. */
export type Method = 'plain' | 'nearest' | 'lumigraph';

/** Number of photographs that each pixel tests. */
export const MOST_VIEWS = 16;

/** The vertex shader of all methods. */
export const VERTEX = `#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 color;
uniform mat4 clipFromCapture;
out vec3 point;
out vec3 plainColor;
void main() {
  point = position;
  plainColor = color.rgb;
  gl_Position = clipFromCapture * vec4(position, 1.0);
}`;

/** Distances count a fifth of angles, as in COLIBRI VR, whose other weights these are too. */
const RESOLUTION_WEIGHT = '0.2';

const HEAD = `#version 300 es
precision highp float;
precision highp sampler2DArray;
${CAPTURE_GLSL}
uniform vec3 eye;
uniform int views[${MOST_VIEWS}];
uniform int viewCount;
in vec3 point;
in vec3 plainColor;
out vec4 color;

/** Reads a photograph with the derivatives of its own projection. */
vec3 photoAt(int view, vec2 uv, vec3 dx, vec3 dy) {
  vec3 right = projectInto(view, point + dx);
  vec3 up = projectInto(view, point + dy);
  return textureGrad(photos, vec3(uv, view), right.xy / right.z - uv, up.xy / up.z - uv).rgb;
}
`;

const PLAIN = `#version 300 es
precision highp float;
in vec3 plainColor;
out vec4 color;
void main() { color = vec4(plainColor, 1.0); }`;

const NEAREST = `${HEAD}
void main() {
  vec3 dx = dFdx(point);
  vec3 dy = dFdy(point);
  color = vec4(plainColor, 1.0);
  for (int i = 0; i < viewCount; i++) {
    int view = views[i];
    vec3 p = projectInto(view, point);
    if (p.z <= 0.0) continue;
    vec2 uv = p.xy / p.z;
    if (insideOf(uv) <= 0.0 || seenBy(view, uv, p.z) < 0.5) continue;
    color.rgb = photoAt(view, uv, dx, dy);
    break;
  }
}`;

/**
 * Unstructured lumigraph rendering (Buehler et al. 2001; Dupont de Dinechin and Paljic 2020, §3.1), per pixel: of the photographs that see
 * the point, the best by angle and distance, with weights that fall to 0 at the next best one.
 */
function lumigraph(blended: number): string {
  return `${HEAD}
const int BLENDED = ${blended};
void main() {
  vec3 dx = dFdx(point);
  vec3 dy = dFdy(point);
  vec3 toEye = eye - point;
  vec3 normal = cross(dx, dy);
  normal *= sign(dot(normal, toEye));
  float eyeDistance = length(toEye);
  float costs[BLENDED + 1];
  float seen[BLENDED + 1];
  int best[BLENDED + 1];
  for (int i = 0; i <= BLENDED; i++) {
    costs[i] = 1.0;
    best[i] = -1;
  }
  for (int i = 0; i < viewCount; i++) {
    int view = views[i];
    vec3 p = projectInto(view, point);
    if (p.z <= 0.0) continue;
    vec2 uv = p.xy / p.z;
    float weight = insideOf(uv);
    vec3 toCamera = cameraAt(view) - point;
    if (weight <= 0.0 || dot(normal, toCamera) <= 0.0) continue;
    float cameraDistance = length(toCamera);
    float angle = acos(clamp(dot(toEye, toCamera) / (eyeDistance * cameraDistance), -1.0, 1.0)) / 3.14159265;
    float cost = mix(angle, max(0.0, 1.0 - eyeDistance / cameraDistance), ${RESOLUTION_WEIGHT});
    if (cost >= costs[BLENDED]) continue;
    weight *= seenBy(view, uv, p.z);
    if (weight <= 0.0) continue;
    int at = BLENDED;
    for (; at > 0 && costs[at - 1] > cost; at--) {
      costs[at] = costs[at - 1];
      seen[at] = seen[at - 1];
      best[at] = best[at - 1];
    }
    costs[at] = cost;
    seen[at] = weight;
    best[at] = view;
  }
  // With fewer photographs than one more than are blended, it is 1.
  float threshold = costs[BLENDED];
  vec4 sum = vec4(0.0);
  for (int i = 0; i < BLENDED; i++) {
    if (best[i] < 0) break;
    vec3 p = projectInto(best[i], point);
    float weight = seen[i] * (max(0.0, 1.0 - costs[i] / threshold) + 1e-4);
    sum += weight * vec4(photoAt(best[i], p.xy / p.z, dx, dy), 1.0);
  }
  color = vec4(sum.a > 0.0 ? sum.rgb / sum.a : plainColor, 1.0);
}`;
}

/**
 * The fragment shader of a method.
 *
 * @param blended Number of photographs per pixel (lumigraph).
 *
 * @example
 * const program = linkProgram(gl, VERTEX, fragmentOf('lumigraph', 2));
 */
export function fragmentOf(method: Method, blended: number): string {
  if (method === 'plain') return PLAIN;
  return method === 'nearest' ? NEAREST : lumigraph(blended);
}
