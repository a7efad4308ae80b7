import { CAPTURE_GLSL } from '../capture-glsl.ts';

/** How a capture is drawn: the param of the node Capture. */
export type Method = 'plain' | 'nearest' | 'lumigraph';

/** Number of photographs that each pixel tests. Of measured captures, all that any pixel needs are among them, but for one in 4,000. */
export const MOST_VIEWS = 24;

/** The vertex shader of all methods. */
export const VERTEX = /* glsl */ `#version 300 es
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

/** What all shaders know that read up to `most` photographs. */
export function headOf(most: number): string {
  return /* glsl */ `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2DArray;
${CAPTURE_GLSL}
uniform vec3 eye;
uniform int views[${most}];
uniform int viewCount;
`;
}

const HEAD = /* glsl */ `${headOf(MOST_VIEWS)}
in vec3 point;
in vec3 plainColor;
out vec4 color;
`;

const PLAIN = /* glsl */ `#version 300 es
precision highp float;
in vec3 plainColor;
out vec4 color;
void main() { color = vec4(plainColor, 1.0); }`;

const NEAREST = /* glsl */ `${HEAD}
void main() {
  vec3 dx = dFdx(point);
  vec3 dy = dFdy(point);
  color = vec4(plainColor, 1.0);
  for (int i = 0; i < viewCount; i++) {
    int view = views[i];
    vec3 p = projectInto(view, point);
    if (p.z <= 0.0) continue;
    vec2 uv = p.xy / p.z;
    if (edgeOf(view, uv) <= 0.0 || seenBy(view, uv, p.z) < 0.5) continue;
    color.rgb = photoAt(view, point, uv, dx, dy);
    break;
  }
}`;

/**
 * Makes the weighted mean of the directions to the cameras that to the eye, as far as no weight gets below 0, by a factor that is linear in
 * the direction (moving least squares; Lancaster and Salkauskas 1981). So what moves with the eye, such as a highlight, is in the mean where
 * it belongs. Two cameras span no plane of directions.
 */
const CENTERED = /* glsl */ `
  vec3 ahead = normalize(toEye);
  vec3 right = normalize(cross(ahead, abs(ahead.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
  vec3 up = cross(right, ahead);
  vec2 offsets[BLENDED];
  vec2 mean = vec2(0.0);
  vec3 spread = vec3(0.0);
  for (int i = 0; i < BLENDED; i++) {
    offsets[i] = vec2(0.0);
    if (weights[i] <= 0.0) continue;
    vec3 direction = normalize(cameraAt(best[i]) - point);
    vec2 offset = vec2(dot(direction, right), dot(direction, up));
    offsets[i] = offset;
    mean += weights[i] * offset;
    spread += weights[i] * vec3(offset.x * offset.x, offset.x * offset.y, offset.y * offset.y);
  }
  spread += vec3(1e-6, 0.0, 1e-6);
  float area = spread.x * spread.z - spread.y * spread.y;
  vec2 slope = vec2(spread.z * mean.x - spread.y * mean.y, spread.x * mean.y - spread.y * mean.x) / area;
  for (int i = 0; i < BLENDED; i++) weights[i] *= max(1e-3, 1.0 - dot(slope, offsets[i]));`;

/**
 * Unstructured lumigraph rendering (Buehler et al. 2001; Dupont de Dinechin and Paljic 2020, §3.1): `chooseViews` finds, of the photographs
 * that see a point, the best by angle and distance, with weights that fall to 0 at the next best one.
 *
 * @param blended Number of photographs.
 * @param feathers Whether weights fall to 0 at the edges of photographs, too.
 */
export function choiceOfViews(blended: number, feathers: boolean): string {
  return /* glsl */ `
const int BLENDED = ${blended};
/** A best view of -1 has the weight 0. */
void chooseViews(vec3 point, vec3 normal, vec3 toEye, out int best[BLENDED + 1], out float weights[BLENDED]) {
  float costs[BLENDED + 1];
  float seen[BLENDED + 1];
  for (int i = 0; i <= BLENDED; i++) {
    costs[i] = 1.0;
    best[i] = -1;
  }
  for (int i = 0; i < viewCount; i++) {
    int view = views[i];
    vec3 toCamera = cameraAt(view) - point;
    if (dot(normal, toCamera) <= 0.0) continue;
    // The cost first: it rejects most views, and reads least.
    float cost = costOf(toEye, toCamera);
    if (cost >= costs[BLENDED]) continue;
    vec3 p = projectInto(view, point);
    if (p.z <= 0.0) continue;
    vec2 uv = p.xy / p.z;
    float weight = edgeOf(view, uv);
    if (weight <= 0.0) continue;
    weight ${feathers ? '*' : ''}= seenBy(view, uv, p.z);
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
  for (int i = 0; i < BLENDED; i++) weights[i] = best[i] < 0 ? 0.0 : seen[i] * (max(0.0, 1.0 - costs[i] / threshold) + 1e-4);
  ${blended > 2 ? CENTERED : ''}
}`;
}

/** The lumigraph with weights for each pixel. */
function lumigraph(blended: number): string {
  return /* glsl */ `${HEAD}${choiceOfViews(blended, true)}
void main() {
  vec3 dx = dFdx(point);
  vec3 dy = dFdy(point);
  vec3 toEye = eye - point;
  vec3 normal = cross(dx, dy);
  normal *= sign(dot(normal, toEye));
  int best[BLENDED + 1];
  float weights[BLENDED];
  chooseViews(point, normal, toEye, best, weights);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < BLENDED; i++) {
    if (weights[i] <= 0.0) continue;
    vec3 p = projectInto(best[i], point);
    float weight = weights[i];
    sum += weight * vec4(photoAt(best[i], point, p.xy / p.z, dx, dy), 1.0);
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
