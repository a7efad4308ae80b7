/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Watercolor",
  "DESCRIPTION": "Paints an image in watercolor: transparent washes with dark borders, pigment that settles unevenly, and grain of the paper. Paper and pigment keep their place on screen.",
  "CREDIT": "Scrim. Pigment: A. Bousseau, M. Kaplan, J. Thollot and F. X. Sillion 2006, Interactive Watercolor Rendering with Temporal Coherence and Abstraction. Areas and directions: J. E. Kyprianidis and J. Döllner 2008, Image Abstraction by Structure Adaptive Filtering",
  "CATEGORIES": ["Style", "Painterly", "Watercolor", "Aquarelle", "Paint", "Paper", "NPR"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to paint." },
    { "NAME": "simplify", "TYPE": "float", "LABEL": "Simplify", "DOC": "How much areas are evened out.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.35, "UNIT": "ratio" },
    { "NAME": "washes", "TYPE": "float", "LABEL": "Washes", "DOC": "Number of tones that washes over each other have.", "MIN": 2.0, "MAX": 12.0, "DEFAULT": 7.0, "STEP": 1.0 },
    { "NAME": "dilution", "TYPE": "float", "LABEL": "Water", "DOC": "How much the colors are diluted. Light areas become bare paper.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.4, "UNIT": "ratio" },
    { "NAME": "borders", "TYPE": "float", "LABEL": "Dark borders", "DOC": "How much pigment gathers at the borders of washes.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.6, "UNIT": "ratio" },
    { "NAME": "pigment", "TYPE": "float", "LABEL": "Uneven pigment", "DOC": "How unevenly the pigment settles within a wash.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "UNIT": "ratio" },
    { "NAME": "grain", "TYPE": "float", "LABEL": "Paper grain", "DOC": "How much the grain of the paper shows.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "UNIT": "ratio" },
    { "NAME": "wobblePx", "TYPE": "float", "LABEL": "Wobble", "DOC": "How far the borders of washes stray from the shapes, in pixels of the layer.", "MIN": 0.0, "MAX": 12.0, "DEFAULT": 3.0, "UNIT": "px" },
    { "NAME": "paperColor", "TYPE": "color", "LABEL": "Paper", "DOC": "Color of the paper.", "DEFAULT": [0.99, 0.98, 0.95, 1.0] }
  ],
  "PASSES": [
    { "TARGET": "tensor", "FLOAT": true, "SCRIM_HALF": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Structure tensor, at half size." },
    { "TARGET": "tensorAcross", "FLOAT": true, "SCRIM_HALF": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Smooths it along x." },
    { "TARGET": "smoothed", "FLOAT": true, "SCRIM_HALF": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Smooths it along y." },
    { "TARGET": "areas1", "DESCRIPTION": "Evens out areas across edges." },
    { "TARGET": "areas2", "DESCRIPTION": "Evens out areas along edges." },
    { "TARGET": "areas3", "DESCRIPTION": "Evens out areas across edges again." },
    { "TARGET": "areas", "DESCRIPTION": "Evens out areas along edges again." },
    { "TARGET": "paper", "DESCRIPTION": "Grain of the paper, uneven pigment, and two fields for the wobble." },
    { "TARGET": "washed", "DESCRIPTION": "Washes without pigment effects." },
    { "DESCRIPTION": "Borders, pigment and paper." }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

// Standard deviation of the smoothing of directions, at half size, and the radius of its kernel.
const float SMOOTH_PX = 3.0;
const int SMOOTH_REACH = 8;

// Scales squares of small differences above the smallest steps of 16-bit floats.
const float SCALE = 1000.0;

// A prime p for which 3 does not divide p - 1, so that cubes permute the integers below it. Squares of numbers below 2 p are exact.
const float PERIOD = 509.0;

// Steps along a line of the bilateral mean, on either side, to two standard deviations.
const int LINE_REACH = 6;

// The share of a step over which one wash becomes the next: wide enough that noise does not move its border by many pixels.
const float WASH_SOFT = 0.3;

// Sizes of the largest spots of pigment, of the wobble and of the grain, in pixels.
const float PIGMENT_PX = 48.0;
const float WOBBLE_PX = 14.0;
const float GRAIN_PX = 2.5;

// Samples around a pixel that find the dark side of a border, and their distance in pixels.
const int AROUND = 8;
const float AROUND_PX = 2.5;

// The layer at `uv`, premultiplied. Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha.
vec4 readLayer(vec2 uv) {
  vec4 color = IMG_NORM_PIXEL(inputImage, uv);
#ifndef SCRIM
  color.rgb *= color.a;
#endif
  return color;
}

// The weight of a pixel in a Gaussian blur, relative to the center. `sigma` is the standard deviation, in pixels.
float weight(int distancePx, float sigma) {
  float x = float(distancePx) / sigma;
  return exp(-0.5 * x * x);
}

// The structure tensor of the layer from Sobel derivatives of its color, times SCALE: xx, yy and xy.
vec3 structureTensor() {
  vec2 px = 1.0 / RENDERSIZE;
  vec4 leftUp = readLayer(isf_FragNormCoord + px * vec2(-1.0, 1.0));
  vec4 rightUp = readLayer(isf_FragNormCoord + px);
  vec4 leftDown = readLayer(isf_FragNormCoord - px);
  vec4 rightDown = readLayer(isf_FragNormCoord + px * vec2(1.0, -1.0));
  vec4 right = readLayer(isf_FragNormCoord + vec2(px.x, 0.0));
  vec4 left = readLayer(isf_FragNormCoord - vec2(px.x, 0.0));
  vec4 up = readLayer(isf_FragNormCoord + vec2(0.0, px.y));
  vec4 down = readLayer(isf_FragNormCoord - vec2(0.0, px.y));
  vec4 x = (rightUp + 2.0 * right + rightDown - leftUp - 2.0 * left - leftDown) / 4.0;
  vec4 y = (leftUp + 2.0 * up + rightUp - leftDown - 2.0 * down - rightDown) / 4.0;
  return SCALE * vec3(dot(x, x), dot(y, y), dot(x, y));
}

// A Gaussian mean of the tensors along `stepUv`, one pixel apart: the structure tensor is smoothed where its direction could not be averaged.
vec4 smoothTensor(vec2 stepUv) {
  vec4 sum = vec4(0.0);
  float total = 0.0;
  for (int i = -SMOOTH_REACH; i <= SMOOTH_REACH; i++) {
    float share = weight(i, SMOOTH_PX);
    vec2 uv = isf_FragNormCoord + float(i) * stepUv;
    sum += share * (PASSINDEX == 1 ? IMG_NORM_PIXEL(tensor, uv) : IMG_NORM_PIXEL(tensorAcross, uv));
    total += share;
  }
  return sum / total;
}

// The unit vector along the edges at `uv`: the minor eigenvector of the smoothed tensor, which receives `pull` times the tensor of strokes
// in the direction `usual`. Flat areas therefore have that direction, and directions change without a seam.
vec2 alongEdge(vec2 uv, vec2 usual, float pull) {
  vec3 t = IMG_NORM_PIXEL(smoothed, uv).xyz + pull * vec3(usual.y * usual.y, usual.x * usual.x, -usual.x * usual.y);
  float apart = 0.5 * (t.x - t.y);
  float spread = sqrt(apart * apart + t.z * t.z);
  vec2 along = apart > 0.0 ? vec2(-t.z, apart + spread) : vec2(spread - apart, -t.z);
  return along / max(length(along), 0.000001);
}

// The tensor of flat areas for `amount` of following: at 1 below the noise of cameras, at 0 above every edge.
float pullOf(float amount) {
  return 0.3 * exp2(16.0 * (1.0 - amount));
}

// A tone moved to the nearest multiple of one step. Between two of them it changes over `soft`, a share of the step, so that the noise of
// a camera moves no border by much. `tone` is in steps.
float softSteps(float tone, float soft) {
  float whole = floor(tone);
  return whole + smoothstep(0.5 - 0.5 * soft, 0.5 + 0.5 * soft, tone - whole);
}

// A color with the same hue and another brightness. A channel that would exceed white goes to white with the others.
vec3 withTone(vec3 color, float from, float to) {
  vec3 scaled = from > 0.001 ? color * (to / from) : vec3(to);
  float most = max(scaled.r, max(scaled.g, scaled.b));
  if (most <= 1.0) return scaled;
  // Mixing with white keeps the brightness: `most` falls to 1 while the gray stays.
  return mix(scaled, vec3(to), (most - 1.0) / max(most - to, 0.001));
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

// Four random numbers from 0 to 1 for a cell of the grid of strokes, the same in every frame.
vec4 strokeNoise(vec2 cell) {
  // An offset for each period, so that the pattern does not repeat across a wide image.
  float seed = seedOf(cell + floor(cell.yx / PERIOD) * vec2(37.0, 101.0), 0.0);
  vec4 grain;
  grain.x = permute(wrap(seed + 1.0));
  grain.y = permute(wrap(grain.x + cell.x + 2.0));
  grain.z = permute(wrap(grain.y + cell.y + 3.0));
  grain.w = permute(wrap(grain.z + cell.x + 5.0));
  return (grain + 0.5) / PERIOD;
}

// The layer that the current pass evens out.
vec4 readStage(vec2 uv) {
  if (PASSINDEX == 3) return readLayer(uv);
  if (PASSINDEX == 4) return IMG_NORM_PIXEL(areas1, uv);
  if (PASSINDEX == 5) return IMG_NORM_PIXEL(areas2, uv);
  return IMG_NORM_PIXEL(areas3, uv);
}

// A mean of the pixels along the edges, or straight across them, in which a pixel counts less with its distance (standard deviation
// `sigmaPx`) and with the difference of its color (`range`, summed over red, green, blue and alpha).
vec4 bilateralLine(bool across, float sigmaPx, float range) {
  vec4 middle = readStage(isf_FragNormCoord);
  vec2 first = alongEdge(isf_FragNormCoord, vec2(1.0, 0.0), pullOf(1.0));
  if (across) first = vec2(-first.y, first.x);
  float stepPx = 2.0 * sigmaPx / float(LINE_REACH);
  vec4 sum = middle;
  float total = 1.0;
  for (int side = 0; side < 2; side++) {
    vec2 uv = isf_FragNormCoord;
    vec2 along = side == 0 ? first : -first;
    for (int i = 1; i <= LINE_REACH; i++) {
      uv += stepPx * along / RENDERSIZE;
      if (!across) {
        vec2 next = alongEdge(uv, vec2(1.0, 0.0), pullOf(1.0));
        along = dot(next, along) < 0.0 ? -next : next;
      }
      vec4 color = readStage(uv);
      float difference = dot(abs(color - middle), vec4(1.0)) / range;
      float share = weight(i, 0.5 * float(LINE_REACH)) * exp(-0.5 * difference * difference);
      sum += share * color;
      total += share;
    }
  }
  return sum / total;
}

// Four fields of smooth noise from 0 to 1, with one random number per unit of `at`.
vec4 smoothNoise(vec2 at) {
  vec2 cell = floor(at);
  vec2 part = at - cell;
  part *= part * (3.0 - 2.0 * part);
  vec4 low = mix(strokeNoise(cell), strokeNoise(cell + vec2(1.0, 0.0)), part.x);
  vec4 high = mix(strokeNoise(cell + vec2(0.0, 1.0)), strokeNoise(cell + vec2(1.0, 1.0)), part.x);
  return mix(low, high, part.y);
}

// Grain, pigment and wobble at a pixel; each has a mean of one half.
vec4 paperFields(vec2 px) {
  vec4 large = smoothNoise(px / PIGMENT_PX);
  vec4 middle = smoothNoise(px / WOBBLE_PX + 31.0);
  vec4 small = smoothNoise(px / (0.4 * WOBBLE_PX) + 77.0);
  vec4 fine = smoothNoise(px / GRAIN_PX + 113.0);
  float settled = 0.45 * large.x + 0.3 * middle.x + 0.25 * small.x;
  vec2 stray = 0.65 * middle.zw + 0.35 * small.zw;
  return vec4(0.7 * fine.x + 0.3 * small.y, settled, stray);
}

// The washes at a pixel on white paper, premultiplied.
vec4 wash() {
  vec2 stray = (IMG_NORM_PIXEL(paper, isf_FragNormCoord).zw - 0.5) * 2.0 * wobblePx / RENDERSIZE;
  vec4 area = IMG_NORM_PIXEL(areas, isf_FragNormCoord + stray);
  float alpha = readLayer(isf_FragNormCoord).a;
  vec3 straight = area.rgb / max(area.a, 0.0001);
  // Diluted paint is more transparent: its absorbance is less, and the lightest tones are bare paper.
  vec3 thin = 1.0 - (1.0 - 0.2 * dilution) * (1.0 - pow(max(straight, 0.002), vec3(1.0 - 0.5 * dilution)));
  float from = dot(thin, LUMA_709);
  float open = from / (1.0 - 0.12 * dilution);
  float steps = floor(washes + 0.5);
  float tone = mix(open, softSteps(open * steps, WASH_SOFT) / steps, 0.75);
  return vec4(withTone(thin, from, min(tone, 1.0)), 1.0) * alpha;
}

// How much darker this pixel is than those around it, which are on the other side of a border: brightness from 0 to 1.
float darkSide(float bright) {
  float sum = 0.0;
  for (int i = 0; i < AROUND; i++) {
    float turn = 6.2831853 * (float(i) + 0.5) / float(AROUND);
    vec2 offset = AROUND_PX * (1.0 + mod(float(i), 2.0)) * vec2(cos(turn), sin(turn)) / RENDERSIZE;
    vec4 other = IMG_NORM_PIXEL(washed, isf_FragNormCoord + offset);
    sum += max(dot(other.rgb, LUMA_709) + 1.0 - other.a - bright, 0.0);
  }
  return sum / float(AROUND);
}

void main() {
  if (PASSINDEX == 0) {
    gl_FragColor = vec4(structureTensor(), 1.0);
  } else if (PASSINDEX == 1) {
    gl_FragColor = smoothTensor(vec2(1.0 / RENDERSIZE.x, 0.0));
  } else if (PASSINDEX == 2) {
    gl_FragColor = smoothTensor(vec2(0.0, 1.0 / RENDERSIZE.y));
  } else if (PASSINDEX < 7) {
    gl_FragColor = bilateralLine(PASSINDEX == 3 || PASSINDEX == 5, 1.0 + 6.0 * simplify, 0.1 + 0.6 * simplify);
  } else if (PASSINDEX == 7) {
    gl_FragColor = paperFields(floor(gl_FragCoord.xy));
  } else if (PASSINDEX == 8) {
    gl_FragColor = wash();
  } else {
    vec4 painted = IMG_NORM_PIXEL(washed, isf_FragNormCoord);
    vec4 fields = IMG_NORM_PIXEL(paper, isf_FragNormCoord);
    vec3 straight = painted.rgb / max(painted.a, 0.0001);
    float bright = dot(painted.rgb, LUMA_709) + 1.0 - painted.a;
    // The density of pigment is an exponent, as the thickness of a filter is. White stays the color of the paper.
    float density = 1.0 + 7.0 * borders * darkSide(bright) + 1.6 * pigment * (fields.y - 0.5) + 1.2 * grain * (fields.x - 0.5);
    vec3 pigmented = pow(clamp(straight, 0.002, 1.0), vec3(max(density, 0.1)));
    // Light from the left shows the relief of the paper.
    float relief = fields.x - IMG_NORM_PIXEL(paper, isf_FragNormCoord + vec2(1.0, -1.0) / RENDERSIZE).x;
    vec3 lit = pigmented * paperColor.rgb * (1.0 + 0.12 * grain * relief);
    vec4 result = vec4(clamp(lit, 0.0, 1.0), 1.0) * paperColor.a * painted.a;
#ifndef SCRIM
    if (result.a > 0.0) result.rgb /= result.a;
#endif
    gl_FragColor = result;
  }
}
