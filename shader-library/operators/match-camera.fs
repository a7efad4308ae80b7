/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Adds the grain and the blur of the camera image to a rendered layer, so that virtual objects look like a part of it. Both are measured in the camera image while it plays. Put the result over the camera video.",
  "CREDIT": "Scrim. Idea: J. Fischer et al. 2006, Enhanced Visual Realism by Incorporating Camera Image Effects, ISMAR. Noise: J. Immerkaer 1996, Computer Vision and Image Understanding 64, 300. Blur: S. Zhuo and T. Sim 2011, Pattern Recognition 44, 1852. Random numbers: I. McEwan et al. 2012, J. Graphics Tools 16, 85",
  "CATEGORIES": ["Composite", "Noise", "Grain", "Blur", "Camera", "Realism", "Match"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_DEPTH": "same",
  "INPUTS": [
    { "NAME": "drawn", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to change, such as a scene. The depth of the result is from this layer." },
    { "NAME": "camera", "TYPE": "image", "LABEL": "Camera", "DOC": "The camera image to measure." },
    { "NAME": "grain", "TYPE": "float", "LABEL": "Grain", "DOC": "Fraction of the measured grain to add: 1 adds all of it.", "MIN": 0.0, "MAX": 2.0, "DEFAULT": 1.0, "UNIT": "ratio" },
    { "NAME": "blur", "TYPE": "float", "LABEL": "Blur", "DOC": "Fraction of the measured blur to add: 1 makes edges as soft as in the camera image.", "MIN": 0.0, "MAX": 2.0, "DEFAULT": 1.0, "UNIT": "ratio" },
    { "NAME": "follow", "TYPE": "float", "LABEL": "Follow", "DOC": "Weight of a new measurement in each frame: a small value keeps the grain steady, 1 follows at once.", "MIN": 0.02, "MAX": 1.0, "DEFAULT": 0.1, "UNIT": "ratio" },
    { "NAME": "rate", "TYPE": "float", "LABEL": "Rate", "DOC": "How often the grain changes, in hertz. 0 keeps it still.", "MIN": 0.0, "MAX": 60.0, "DEFAULT": 30.0, "UNIT": "Hz" }
  ],
  "PASSES": [
    { "TARGET": "noises", "WIDTH": "16", "HEIGHT": "9", "FLOAT": true, "DESCRIPTION": "Measures the noise at 16 by 9 places of the camera image: standard deviation per channel." },
    { "TARGET": "edges", "WIDTH": "16", "HEIGHT": "9", "FLOAT": true, "DESCRIPTION": "Measures the steepest edge at each place: its gradient per pixel, and the standard deviation of its blur in pixels." },
    { "TARGET": "found", "WIDTH": "1", "HEIGHT": "1", "FLOAT": true, "PERSISTENT": true, "DESCRIPTION": "Combines them to the noise per channel and the blur of the whole image, stored plus 1: 0 means not measured yet." },
    { "TARGET": "across", "DESCRIPTION": "Blurs along x." },
    { "DESCRIPTION": "Blurs along y, and adds the grain." }
  ]
}*/

const int TILES_X = 16;
const int TILES_Y = 9;
const int TILES = 144;
// Side of a tile, pixels.
const int SIDE = 20;

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

// Rounding to 8 bits adds a variance of 1/12 of a squared step, and the result is rounded again.
const float ROUNDING = 1.0 / (12.0 * 255.0 * 255.0);

// The minimum slope of an edge. Noise alone also has slopes: the steepest of 400 pixels is 1.5 times the noise.
const float EDGE = 0.02;
const float EDGE_OVER_NOISE = 2.5;

// Standard deviations of the two derivatives of Gaussians for an edge, and the radius of their kernels.
const float NEAR_SIGMA = 1.0;
const float FAR_SIGMA = 2.0;
const int SEEN_PX = 6;

// The blur of the rendered layer itself: the width of a pixel, as in a camera image.
const float PIXEL_VARIANCE = 1.0 / 12.0;

// The largest kernel of the blur, in pixels. Three standard deviations contain 99.7 % of the weight.
const float MAX_BLUR = 6.0;
const float REACH = 3.0;
const int MAX_REACH = 36;

// Bisections of the range when searching a rank.
const int HALVINGS = 12;
const float MAX_NOISE = 0.5;

// The period of the random numbers and their standard deviation, as in filters/film-grain.fs.
const float PERIOD = 509.0;
const float SPREAD = 1.7320508;

vec3 cameraAt(vec2 px) {
  return IMG_NORM_PIXEL(camera, px / IMG_SIZE(drawn)).rgb;
}

float brightness(vec2 px) {
  return dot(cameraAt(px), LUMA_709);
}

// The center of the first pixel of this pixel's tile.
vec2 tileStart() {
  vec2 room = max(IMG_SIZE(drawn) - float(SIDE + 2), 0.0);
  return floor(room * floor(gl_FragCoord.xy) / vec2(float(TILES_X - 1), float(TILES_Y - 1))) + 1.5;
}

// The difference of two Laplacians removes slopes and has 36 times the variance of the noise.
vec3 noiseAt(vec2 px) {
  vec3 corners = cameraAt(px + vec2(-1.0, -1.0)) + cameraAt(px + vec2(1.0, -1.0)) + cameraAt(px + vec2(-1.0, 1.0)) + cameraAt(px + vec2(1.0, 1.0));
  vec3 sides = cameraAt(px + vec2(-1.0, 0.0)) + cameraAt(px + vec2(1.0, 0.0)) + cameraAt(px + vec2(0.0, -1.0)) + cameraAt(px + vec2(0.0, 1.0));
  return corners - 2.0 * sides + 4.0 * cameraAt(px);
}

vec4 measureNoise() {
  vec2 start = tileStart();
  vec3 sum = vec3(0.0);
  for (int y = 0; y < SIDE; y++) {
    for (int x = 0; x < SIDE; x++) {
      vec3 noise = noiseAt(start + vec2(float(x), float(y)));
      sum += noise * noise;
    }
  }
  return vec4(sqrt(sum / (36.0 * float(SIDE * SIDE))), 1.0);
}

// The Sobel gradient per pixel; it reduces noise by more than half.
vec2 slopeAt(vec2 px) {
  float a = brightness(px + vec2(1.0, 1.0)) - brightness(px - vec2(1.0, 1.0));
  float b = brightness(px + vec2(1.0, -1.0)) - brightness(px - vec2(1.0, -1.0));
  float across = brightness(px + vec2(1.0, 0.0)) - brightness(px - vec2(1.0, 0.0));
  float up = brightness(px + vec2(0.0, 1.0)) - brightness(px - vec2(0.0, 1.0));
  return vec2(a + b + 2.0 * across, a - b + 2.0 * up) / 8.0;
}

// Logarithms of the slope along a direction, after the narrow and the wide Gaussian.
vec2 risesAt(vec2 px, vec2 along) {
  vec2 rises = vec2(0.0);
  vec2 center = floor(px) + 0.5;
  for (int y = -SEEN_PX; y <= SEEN_PX; y++) {
    for (int x = -SEEN_PX; x <= SEEN_PX; x++) {
      vec2 tap = center + vec2(float(x), float(y));
      vec2 away = tap - px;
      vec2 sigmas = vec2(NEAR_SIGMA, FAR_SIGMA);
      vec2 weights = exp(-0.5 * dot(away, away) / (sigmas * sigmas)) / (sigmas * sigmas * sigmas * sigmas);
      rises += dot(away, along) * brightness(tap) * weights;
    }
  }
  return log(max(rises, 1e-6));
}

// The blur of the edge here. After a Gaussian of s, an edge that is blurred by b has a slope proportional to 1 / sqrt(b * b + s * s),
// so the ratio of the slopes after both Gaussians gives b. The logarithm of the slope is a parabola across the edge, so
// three samples give its maximum, also between pixels.
float blurAt(vec2 px, vec2 along) {
  vec2 before = risesAt(px - along, along);
  vec2 here = risesAt(px, along);
  vec2 after = risesAt(px + along, along);
  vec2 bend = min(before - 2.0 * here + after, -1e-3);
  vec2 highest = here - (after - before) * (after - before) / (8.0 * bend);
  float ratio = exp(2.0 * (highest.x - highest.y));
  if (ratio < 1.01) return MAX_BLUR;
  float variance = (FAR_SIGMA * FAR_SIGMA - ratio * NEAR_SIGMA * NEAR_SIGMA) / (ratio - 1.0);
  return sqrt(clamp(variance, 0.0, MAX_BLUR * MAX_BLUR));
}

vec4 measureEdge() {
  vec2 start = tileStart();
  vec2 steepest = vec2(0.0);
  vec2 place = start;
  for (int y = 0; y < SIDE; y++) {
    for (int x = 0; x < SIDE; x++) {
      vec2 px = start + vec2(float(x), float(y));
      vec2 slope = slopeAt(px);
      if (dot(slope, slope) > dot(steepest, steepest)) {
        steepest = slope;
        place = px;
      }
    }
  }
  float rise = length(steepest);
  return vec4(rise, rise > EDGE ? blurAt(place, steepest / rise) : 0.0, 0.0, 1.0);
}

vec2 tileUv(int i) {
  vec2 tile = vec2(mod(float(i), float(TILES_X)), floor((float(i) + 0.5) / float(TILES_X)));
  return (tile + 0.5) / vec2(float(TILES_X), float(TILES_Y));
}

// Places without detail contain only noise. Places with at most 1.25 times the noise of the quietest fifth count.
vec3 noiseOfAll() {
  vec3 low = vec3(0.0);
  vec3 high = vec3(MAX_NOISE);
  for (int round = 0; round < HALVINGS; round++) {
    vec3 middle = 0.5 * (low + high);
    vec3 below = vec3(0.0);
    for (int i = 0; i < TILES; i++) below += step(IMG_NORM_PIXEL(noises, tileUv(i)).rgb, middle);
    vec3 isEnough = step(0.2 * float(TILES), below);
    low = mix(middle, low, isEnough);
    high = mix(high, middle, isEnough);
  }
  vec3 sum = vec3(0.0);
  vec3 count = vec3(0.0);
  for (int i = 0; i < TILES; i++) {
    vec3 noise = IMG_NORM_PIXEL(noises, tileUv(i)).rgb;
    vec3 counts = step(noise, 1.25 * high);
    sum += counts * noise * noise;
    count += counts;
  }
  return sqrt(sum / max(count, 1.0));
}

// The median of the edges; without edges there is no blur.
float blurOfAll(float noise) {
  float least = max(EDGE, EDGE_OVER_NOISE * noise);
  float edgeCount = 0.0;
  for (int i = 0; i < TILES; i++) edgeCount += step(least, IMG_NORM_PIXEL(edges, tileUv(i)).r);
  if (edgeCount < 1.0) return 0.0;
  float low = 0.0;
  float high = MAX_BLUR;
  for (int round = 0; round < HALVINGS; round++) {
    float middle = 0.5 * (low + high);
    float below = 0.0;
    for (int i = 0; i < TILES; i++) {
      vec2 edge = IMG_NORM_PIXEL(edges, tileUv(i)).rg;
      below += step(least, edge.r) * step(edge.g, middle);
    }
    if (below >= 0.5 * edgeCount) high = middle;
    else low = middle;
  }
  return high;
}

vec4 measureAll() {
  vec3 noise = noiseOfAll();
  vec4 now = vec4(noise, blurOfAll(dot(noise, LUMA_709)) + 1.0);
  vec4 before = IMG_NORM_PIXEL(found, vec2(0.5));
  return before.a == 0.0 ? now : mix(before, now, follow);
}

// Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha.
vec4 tap(vec2 uv) {
  if (PASSINDEX == 4) return IMG_NORM_PIXEL(across, uv);
  vec4 color = IMG_NORM_PIXEL(drawn, uv);
#ifndef SCRIM
  color.rgb *= color.a;
#endif
  return color;
}

vec4 blurred(vec2 stepUv) {
  float measured = blur * (IMG_NORM_PIXEL(found, vec2(0.5)).a - 1.0);
  float variance = measured * measured - PIXEL_VARIANCE;
  vec4 sum = tap(isf_FragNormCoord);
  if (variance < 0.01) return sum;
  float total = 1.0;
  for (int i = 1; i <= MAX_REACH; i++) {
    if (float(i) > REACH * sqrt(variance) + 1.0) break;
    float weight = exp(-0.5 * float(i * i) / variance);
    sum += weight * (tap(isf_FragNormCoord + stepUv * float(i)) + tap(isf_FragNormCoord - stepUv * float(i)));
    total += 2.0 * weight;
  }
  return sum / total;
}

// An integer modulo PERIOD. Adding one half compensates for rounding of the quotient.
float wrap(float whole) {
  return whole - PERIOD * floor((whole + 0.5) / PERIOD);
}

// A permutation of the integers below PERIOD, for noise. Nested, the quadratic ones modulo 289 of McEwan et al. 2012 and of Gustavson and
// McEwan 2022 repeat after 24 and 38 pixels along a line, because they are linear modulo 17.
float permute(float x) {
  return wrap(wrap(x * x) * x);
}

// A pseudorandom integer below PERIOD for a cell of a grid in a frame.
float seedOf(vec2 cell, float frame) {
  return permute(wrap(permute(wrap(permute(wrap(cell.x)) + cell.y)) + wrap(frame)));
}

// Approximately a normal distribution with standard deviation 1: two numbers from each of two seeds.
float grainAt(vec2 cell, float channel, float frame) {
  vec2 seeds = vec2(seedOf(cell, frame), seedOf(cell.yx + 11.0, frame));
  float sum = 0.0;
  for (int i = 0; i < 2; i++) {
    seeds.x = permute(wrap(seeds.x + 4.0 * channel + float(i) + 1.0));
    seeds.y = permute(wrap(seeds.y + 4.0 * channel + float(i) + 1.0));
    sum += (seeds.x + seeds.y + 1.0) / PERIOD;
  }
  return (sum - 2.0) * SPREAD;
}

vec3 grainHere() {
  vec3 noise = grain * IMG_NORM_PIXEL(found, vec2(0.5)).rgb;
  vec3 strength = sqrt(max(noise * noise - ROUNDING, 0.0));
  vec2 cell = floor(isf_FragNormCoord * RENDERSIZE);
  cell += floor(cell.yx / PERIOD) * vec2(37.0, 101.0);
  float frame = floor(TIME * rate);
  return strength * vec3(grainAt(cell, 0.0, frame), grainAt(cell, 1.0, frame), grainAt(cell, 2.0, frame));
}

void main() {
  if (PASSINDEX == 0) {
    gl_FragColor = measureNoise();
  } else if (PASSINDEX == 1) {
    gl_FragColor = measureEdge();
  } else if (PASSINDEX == 2) {
    gl_FragColor = measureAll();
  } else if (PASSINDEX == 3) {
    gl_FragColor = blurred(vec2(1.0 / RENDERSIZE.x, 0.0));
  } else {
    vec4 result = blurred(vec2(0.0, 1.0 / RENDERSIZE.y));
    result.rgb = clamp(result.rgb + result.a * grainHere(), 0.0, result.a);
#ifndef SCRIM
    if (result.a > 0.0) result.rgb /= result.a;
#endif
    gl_FragColor = result;
  }
}
