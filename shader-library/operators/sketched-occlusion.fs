/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Sketched occlusion",
  "DESCRIPTION": "Hides the parts of a layer that are behind real surfaces, and draws the borders that the depth sensor is unsure of as sketch lines. Where the depth is certain on both sides of a border, it is the hard edge of “Depth occlusion”. Use it in place of that node, with both outputs of “Room depth”. The lines belong to the virtual object: their wobble stays in place as the camera moves.",
  "CREDIT": "Scrim",
  "CATEGORIES": ["Composite", "Depth", "Occlusion", "Style", "Confidence", "Uncertainty", "Sketch", "NPR", "Border", "World space"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_DEPTH": "same",
  "SCRIM_RENAMED": [{ "widthPx": { "TO": "widthPx", "WAS": 20 }, "surePx": { "TO": "surePx", "WAS": 16 } }],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to occlude. It needs depth." },
    { "NAME": "room", "TYPE": "depth", "LABEL": "Room depth", "DOC": "Distance to real surfaces." },
    { "NAME": "confidence", "TYPE": "image", "LABEL": "Confidence", "DOC": "How certain the depth is: the output of “Room depth”." },
    { "NAME": "biasM", "TYPE": "float", "LABEL": "Depth bias", "DOC": "How far behind a real surface an object may be and stay visible.", "MIN": 0.0, "MAX": 0.5, "DEFAULT": 0.0, "UNIT": "m" },
    { "NAME": "widthPx", "TYPE": "float", "LABEL": "Width", "DOC": "Width of the band that sketched borders take on either side. 0: two and a half samples of the sensor as they appear in the view, from 8 to 64 pixels.", "MIN": 0.0, "MAX": 64.0, "DEFAULT": 0.0, "UNIT": "px" },
    { "NAME": "surePx", "TYPE": "float", "LABEL": "Sure within", "DOC": "A border is sure if the depth is certain this near to it, on both sides. 0: four samples of the sensor as they appear in the view, from 4 to 6 pixels, so that all borders are sketched where a sample is larger than two pixels.", "MIN": 0.0, "MAX": 64.0, "DEFAULT": 0.0, "UNIT": "px" },
    { "NAME": "tolerance", "TYPE": "float", "LABEL": "Tolerance", "DOC": "How much uncertainty counts as sure. 1 sketches nothing.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.2, "UNIT": "ratio" },
    { "NAME": "linePx", "TYPE": "float", "LABEL": "Line width", "DOC": "Width of the lines.", "MIN": 0.5, "MAX": 8.0, "DEFAULT": 1.8, "UNIT": "px" },
    { "NAME": "lineColor", "TYPE": "color", "LABEL": "Lines", "DOC": "Color of the lines.", "DEFAULT": [0.09, 0.08, 0.12, 1.0] }
  ],
  "PASSES": [
    { "TARGET": "sides", "FLOAT": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Whether the layer is there and in front, and the confidence, at half size." },
    { "TARGET": "rows", "FLOAT": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Smooths the two sides along rows." },
    { "TARGET": "smoothSides", "FLOAT": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Smooths the two sides." },
    { "TARGET": "sureRows", "FLOAT": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "The best confidence of each side, and whether it is near, along rows." },
    { "TARGET": "unsure", "FLOAT": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Where borders are, and how unsure they are." },
    { "TARGET": "unsureRows", "FLOAT": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Spreads that over the bands, along rows." },
    { "TARGET": "bands", "FLOAT": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Spreads that over the bands." },
    { "DESCRIPTION": "Cuts sure borders and sketches the others." }
  ]
}*/

// Samples on either side of a pixel.
const int TAPS = 8;
const int LINES = 3;

// A border is where both sides are this near. From there, the confidence of both is read beyond the samples at the border, which are never
// certain.
const int NEAR_TAPS = 2;

// What both distances are by themselves: samples of the sensor, and the limits in pixels.
const float BAND_SAMPLES = 2.5;
const vec2 BAND_PX = vec2(8.0, 64.0);
const float SURE_SAMPLES = 4.0;
const vec2 SURE_PX = vec2(4.0, 6.0);

// Where the lines run, in widths of the band, and how far they stray from there.
const float APART = 0.3;
const float STRAY = 0.4;

// Length of the waves of a line, in widths of the band, and the share of the noise at which it is interrupted.
const float WAVE = 2.0;
const vec2 GAP = vec2(0.3, 0.5);

// Smallest length of waves, meters. All others are it times a power of two.
const float FINEST_M = 0.0009765625;

// A side that is not there has no confidence, and this in place of it.
const float ABSENT = -1.0;

// Above this confidence, a step of depth is as exact as the sensor measures it.
const float RANGE = 0.3;

// A prime p for which 3 does not divide p - 1, so that cubes permute the integers below it. Squares of numbers below 2 p are exact.
const float PERIOD = 509.0;

#ifdef SCRIM
vec2 sensorSamples() { return IMG_SAMPLES(confidence); }
float layerM(vec2 uv) { return LAYER_DEPTH(inputImage, uv); }
float roomM(vec2 uv) { return ROOM_DEPTH(room, uv); }
mat4 projection() { return SCRIM_CLIP_FROM_VIEW; }
mat4 pose() { return SCRIM_WORLD_FROM_VIEW; }
#else
vec2 sensorSamples() { return IMG_SIZE(confidence); }
float layerM(vec2 uv) { return 0.0; }
float roomM(vec2 uv) { return 0.0; }
mat4 projection() { return mat4(1.0); }
mat4 pose() { return mat4(1.0); }
#endif

// The view, pixels: all passes but the last have half of its size.
vec2 viewPx() { return IMG_SIZE(inputImage); }

// Size of a sample of the sensor in the view, pixels.
float samplePx() {
  vec2 view = viewPx();
  vec2 samples = max(sensorSamples(), vec2(1.0));
  return max(1.0, sqrt(view.x * view.y / (samples.x * samples.y)));
}

float bandPx() { return widthPx > 0.0 ? max(widthPx, 4.0) : clamp(BAND_SAMPLES * samplePx(), BAND_PX.x, BAND_PX.y); }
float nearPx() { return surePx > 0.0 ? max(surePx, 2.0) : clamp(SURE_SAMPLES * samplePx(), SURE_PX.x, SURE_PX.y); }

// 1 where the layer is in front, 0 where a real surface is. Unknown depth hides nothing.
float inFront(float layer, float real) {
  return layer <= 0.0 || real <= 0.0 || layer - real - biasM <= 0.0 ? 1.0 : 0.0;
}

// (in front, covered, confidence, 1); all but the confidence are 0 beside the layer.
vec4 sidesAt(vec2 uv) {
  float layer = layerM(uv);
  float covered = layer > 0.0 ? 1.0 : 0.0;
  return vec4(covered * inFront(layer, roomM(uv)), covered, IMG_NORM_PIXEL(confidence, uv).r, 1.0);
}

// The weight of a sample of a Gaussian whose standard deviation is half of the reach.
float weightOf(int i) {
  float away = float(i) / float(TAPS);
  return exp(-2.0 * away * away);
}

vec2 offsetOf(int i, vec2 axis, float reachPx) {
  return axis * float(i) * reachPx / (float(TAPS) * RENDERSIZE);
}

// How unsure a border is whose sides have at best these confidences.
float unsureOf(vec2 best) {
  return clamp((1.0 - min(best.x, best.y) - tolerance) / RANGE, 0.0, 1.0) * (tolerance < 1.0 ? 1.0 : 0.0);
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

float randomOf(vec3 at) {
  return permute(permute(permute(wrap(at.x)) + wrap(at.y)) + wrap(at.z)) / PERIOD;
}

// Smooth noise from 0 to 1 in space.
float noiseIn(vec3 at) {
  vec3 first = floor(at);
  vec3 part = at - first;
  part *= part * (3.0 - 2.0 * part);
  vec2 step = vec2(0.0, 1.0);
  vec4 front = vec4(randomOf(first), randomOf(first + step.yxx), randomOf(first + step.xyx), randomOf(first + step.yyx));
  vec4 back = vec4(randomOf(first + step.xxy), randomOf(first + step.yxy), randomOf(first + step.xyy), randomOf(first + step.yyy));
  vec4 across = mix(front, back, part.z);
  vec2 up = mix(across.xz, across.yw, part.x);
  return mix(up.x, up.y, part.y);
}

// Noise at a point of the world whose waves have about the length `waveM`: two lengths that are powers of two fade into each other.
float strayAt(vec3 world, float waveM, float seed) {
  float level = max(log2(max(waveM, FINEST_M) / FINEST_M), 0.0);
  float octave = floor(level);
  vec3 at = world / (FINEST_M * exp2(octave)) + seed;
  return mix(noiseIn(at), noiseIn(0.5 * at + 31.0), level - octave);
}

// The point of the layer at `uv`, world space.
vec3 worldAt(vec2 uv, float meters) {
  mat4 p = projection();
  vec2 ray = (uv * 2.0 - 1.0 + p[2].xy) / vec2(p[0].x, p[1].y);
  return (pose() * vec4(vec3(ray, -1.0) * meters, 1.0)).xyz;
}

// Pixels from the smoothed border, positive in front: the inverse of the integral of the Gaussian along a straight border, as a logistic
// curve approximates it.
float awayPx(float front) {
  float share = clamp(front, 0.002, 0.998);
  return 0.5 * bandPx() * log(share / (1.0 - share)) / 1.702;
}

// Ink of the lines along a border that is `away` pixels away.
float borderInk(vec2 uv, float away, float meters) {
  vec3 world = worldAt(uv, meters);
  float waveM = WAVE * bandPx() * 2.0 * meters / (projection()[1].y * RENDERSIZE.y);
  float ink = 0.0;
  for (int i = 0; i < LINES; i++) {
    float seed = 17.0 * float(i);
    float stray = STRAY * (2.0 * strayAt(world, waveM, seed) - 1.0);
    float center = bandPx() * (APART * (float(i) - 0.5 * float(LINES - 1)) + stray);
    // The middle line is hardly interrupted.
    float pressure = smoothstep(GAP.x, GAP.y, strayAt(world, 1.5 * waveM, seed + 7.0) + (i == LINES / 2 ? 0.2 : 0.0));
    float halfPx = 0.5 * linePx * pressure;
    ink = max(ink, pressure * (1.0 - smoothstep(halfPx - 0.6, halfPx + 0.6, abs(away - center))));
  }
  return ink;
}

// The layer at `uv`, premultiplied. Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha.
vec4 readLayer(vec2 uv) {
  vec4 color = IMG_NORM_PIXEL(inputImage, uv);
#ifndef SCRIM
  color.rgb *= color.a;
#endif
  return color;
}

vec4 occluded(vec2 uv) {
  vec4 color = readLayer(uv);
  // The exact center of the pixel, as “Depth occlusion” reads it.
  vec2 here = (floor(uv * RENDERSIZE) + 0.5) / RENDERSIZE;
  float meters = layerM(here);
  vec4 cut = color * inFront(meters, roomM(here));
  vec4 band = IMG_NORM_PIXEL(bands, uv);
  float unsureHere = band.y > 0.0 ? clamp(band.x / band.y, 0.0, 1.0) : 0.0;
  vec4 sides = IMG_NORM_PIXEL(smoothSides, uv);
  if (unsureHere <= 0.0 || meters <= 0.0 || sides.y <= 0.0) return cut;
  float away = awayPx(sides.x / sides.y);
  vec4 faded = color * smoothstep(-0.2 * bandPx(), 0.8 * bandPx(), away);
  float ink = borderInk(uv, away, meters) * lineColor.a * color.a;
  return mix(cut, faded * (1.0 - ink) + vec4(lineColor.rgb, 1.0) * ink, unsureHere);
}

void main() {
  vec2 uv = isf_FragNormCoord;
  // The passes have half of the size of the layer, so their pixels are twice as wide.
  vec2 rowStep = vec2(0.5, 0.0);
  vec2 columnStep = vec2(0.0, 0.5);
  vec4 sum = vec4(0.0);
  vec2 best = vec2(ABSENT);
  vec2 near = vec2(0.0);
  if (PASSINDEX == 0) {
    gl_FragColor = sidesAt(uv);
  } else if (PASSINDEX == 1) {
    for (int i = -TAPS; i <= TAPS; i++) sum += weightOf(i) * IMG_NORM_PIXEL(sides, uv + offsetOf(i, rowStep, bandPx()));
    gl_FragColor = sum / sum.w;
  } else if (PASSINDEX == 2) {
    for (int i = -TAPS; i <= TAPS; i++) sum += weightOf(i) * IMG_NORM_PIXEL(rows, uv + offsetOf(i, columnStep, bandPx()));
    gl_FragColor = sum / sum.w;
  } else if (PASSINDEX == 3) {
    for (int i = -TAPS; i <= TAPS; i++) {
      vec4 side = IMG_NORM_PIXEL(sides, uv + offsetOf(i, rowStep, nearPx()));
      if (side.y <= 0.5) continue;
      vec2 which = side.x > 0.5 ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
      best = max(best, mix(vec2(ABSENT), vec2(side.z), which));
      if (i >= -NEAR_TAPS && i <= NEAR_TAPS) near = max(near, which);
    }
    gl_FragColor = vec4(best, near);
  } else if (PASSINDEX == 4) {
    for (int i = -TAPS; i <= TAPS; i++) {
      vec4 row = IMG_NORM_PIXEL(sureRows, uv + offsetOf(i, columnStep, nearPx()));
      best = max(best, row.xy);
      if (i >= -NEAR_TAPS && i <= NEAR_TAPS) near = max(near, row.zw);
    }
    float isBorder = min(near.x, near.y) > 0.5 ? 1.0 : 0.0;
    gl_FragColor = vec4(isBorder * unsureOf(best), isBorder, 0.0, 1.0);
  } else if (PASSINDEX == 5) {
    for (int i = -TAPS; i <= TAPS; i++) sum += weightOf(i) * IMG_NORM_PIXEL(unsure, uv + offsetOf(i, rowStep, 1.5 * bandPx()));
    gl_FragColor = sum / sum.w;
  } else if (PASSINDEX == 6) {
    for (int i = -TAPS; i <= TAPS; i++) sum += weightOf(i) * IMG_NORM_PIXEL(unsureRows, uv + offsetOf(i, columnStep, 1.5 * bandPx()));
    gl_FragColor = sum / sum.w;
  } else {
    vec4 result = occluded(uv);
#ifndef SCRIM
    if (result.a > 0.0) result.rgb /= result.a;
#endif
    gl_FragColor = result;
  }
}
