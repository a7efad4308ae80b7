/**
 * The shaders of `chains.page.ts`: what the library filters of `chains.bench.ts` compute with their default params over opaque images, as
 * functions of straight colors. `at` is a place from (0, 0) to (1, 1), `stepUv` the distance to the next pixel.
 */

export const SEPIA = `vec3 sepia(vec3 c) {
  return vec3(dot(c, vec3(0.393, 0.769, 0.189)), dot(c, vec3(0.349, 0.686, 0.168)), dot(c, vec3(0.272, 0.534, 0.131)));
}`;

export const VIGNETTE = `vec3 vignette(vec3 c, vec2 at) {
  float t = clamp((length(2.0 * at - 1.0) / sqrt(2.0) - 0.35) / 0.65, 0.0, 1.0);
  return c * (1.0 - 0.7 * t * t * (3.0 - 2.0 * t));
}`;

/** A standard deviation of 8 pixels. */
export const BLUR = `float gauss(float px) { return exp(-0.5 * px * px / 64.0); }
vec4 blurred(sampler2D image, vec2 at, vec2 stepUv) {
  vec4 sum = texture(image, at);
  float total = 1.0;
  for (int i = 1; i <= 24; i += 2) {
    float near = gauss(float(i));
    float far = i < 24 ? gauss(float(i + 1)) : 0.0;
    float both = near + far;
    vec2 offset = stepUv * (float(i) + far / both);
    sum += both * (texture(image, at + offset) + texture(image, at - offset));
    total += 2.0 * both;
  }
  return sum / total;
}`;

export const CURVES = `float height(sampler2D curve, float x) { return texture(curve, vec2((clamp(x, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).r; }
vec3 graded(sampler2D curve, vec3 c) {
  vec3 all = vec3(height(curve, c.r), height(curve, c.g), height(curve, c.b));
  vec3 each = vec3(height(curve, all.r), height(curve, all.g), height(curve, all.b));
  float bright = dot(each, vec3(0.2126, 0.7152, 0.0722));
  return each + height(curve, bright) - bright;
}`;

export const LUMA = 'float luma(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }';

/** Both blurs of the ink along x, each as a step of 1/256 and the rest, for targets of 16-bit floats. */
export const ACROSS = `vec4 across(sampler2D image, vec2 at, float stepUv) {
  const vec3 LUMA = vec3(0.2126, 0.7152, 0.0722);
  vec2 sum = vec2(dot(texture(image, at).rgb, LUMA));
  vec2 total = vec2(1.0);
  for (int i = 1; i <= 5; i++) {
    float px = float(i);
    vec2 weight = exp(-0.5 * px * px / vec2(1.0, 2.56));
    vec2 offset = vec2(px * stepUv, 0.0);
    sum += weight * (dot(texture(image, at + offset).rgb, LUMA) + dot(texture(image, at - offset).rgb, LUMA));
    total += 2.0 * weight;
  }
  vec2 found = sum / total;
  vec2 whole = floor(found * 256.0) / 256.0;
  return vec4(whole.x, found.x - whole.x, whole.y, found.y - whole.y);
}`;

/** Both blurs along y, and how light the paper is. */
export const INK = `vec2 sums(sampler2D image, vec2 at) {
  vec4 parts = texture(image, at);
  return parts.xz + parts.yw;
}
float ink(sampler2D image, vec2 at, float stepUv) {
  vec2 sum = sums(image, at);
  vec2 total = vec2(1.0);
  for (int i = 1; i <= 5; i++) {
    float px = float(i);
    vec2 weight = exp(-0.5 * px * px / vec2(1.0, 2.56));
    vec2 offset = vec2(0.0, px * stepUv);
    sum += weight * (sums(image, at + offset) + sums(image, at - offset));
    total += 2.0 * weight;
  }
  vec2 found = sum / total;
  float e = exp(-8.0 * max(0.6 - (21.0 * found.x - 20.0 * found.y), 0.0));
  return 2.0 * e / (1.0 + e);
}`;
