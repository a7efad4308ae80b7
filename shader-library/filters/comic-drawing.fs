/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Comic drawing",
  "DESCRIPTION": "Draws an image as a printed comic: even areas in a few tones, dots in the shadows and ink lines along edges. The dots keep their place on screen.",
  "CREDIT": "Scrim. Tones: H. Winnemöller, S. C. Olsen and B. Gooch 2006, Real-Time Video Abstraction. Areas and directions: J. E. Kyprianidis and J. Döllner 2008, Image Abstraction by Structure Adaptive Filtering. Lines: H. Kang et al. 2007, Coherent Line Drawing. Dots: cosine spot function of PostScript (PLRM 3, section 7.4.3)",
  "CATEGORIES": ["Style", "Drawing", "Comic", "Cartoon", "Print", "Halftone", "Pop art", "NPR"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to draw." },
    { "NAME": "levels", "TYPE": "float", "LABEL": "Tones", "DOC": "Number of steps from black to white. Brightness is a multiple of one step.", "MIN": 2.0, "MAX": 12.0, "DEFAULT": 4.0, "STEP": 1.0 },
    { "NAME": "simplify", "TYPE": "float", "LABEL": "Simplify", "DOC": "How much areas are evened out. At 0 only the noise of cameras is removed.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.3, "UNIT": "ratio" },
    { "NAME": "colors", "TYPE": "float", "LABEL": "Saturation", "DOC": "Saturation of the colors: 0 is gray, 1 that of the image.", "MIN": 0.0, "MAX": 2.5, "DEFAULT": 1.4, "UNIT": "ratio" },
    { "NAME": "shadows", "TYPE": "float", "LABEL": "Dots", "DOC": "Brightness below which dots of the next darker tone give the tones between two steps. 0 draws no dots.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.55, "UNIT": "ratio" },
    { "NAME": "sizePx", "TYPE": "float", "LABEL": "Dot distance", "DOC": "Distance from one dot to the next, in pixels of the layer.", "MIN": 3.0, "MAX": 32.0, "DEFAULT": 6.0, "UNIT": "px" },
    { "NAME": "lines", "TYPE": "float", "LABEL": "Outlines", "DOC": "Strength of lines along edges. 0 draws none.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.9, "UNIT": "ratio" },
    { "NAME": "linePx", "TYPE": "float", "LABEL": "Line width", "DOC": "Width of lines, in pixels of the layer.", "MIN": 1.0, "MAX": 6.0, "DEFAULT": 2.0, "UNIT": "px" },
    { "NAME": "inkColor", "TYPE": "color", "LABEL": "Ink", "DOC": "Color of the lines.", "DEFAULT": [0.04, 0.04, 0.07, 1.0] }
  ],
  "PASSES": [
    { "TARGET": "tensor", "FLOAT": true, "SCRIM_HALF": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Structure tensor, at half size." },
    { "TARGET": "tensorAcross", "FLOAT": true, "SCRIM_HALF": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Smooths it along x." },
    { "TARGET": "smoothed", "FLOAT": true, "SCRIM_HALF": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Smooths it along y." },
    { "TARGET": "areas1", "DESCRIPTION": "Evens out areas across edges." },
    { "TARGET": "areas2", "DESCRIPTION": "Evens out areas along edges." },
    { "TARGET": "areas3", "DESCRIPTION": "Evens out areas across edges again." },
    { "TARGET": "areas", "DESCRIPTION": "Evens out areas along edges again." },
    { "TARGET": "edges", "FLOAT": true, "SCRIM_HALF": true, "DESCRIPTION": "Difference of Gaussians across the edges." },
    { "DESCRIPTION": "Draws tones, dots and lines." }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);
const float PI = 3.14159265;

// Standard deviation of the smoothing of directions, at half size, and the radius of its kernel.
const float SMOOTH_PX = 3.0;
const int SMOOTH_REACH = 8;

// Scales squares of small differences above the smallest steps of 16-bit floats.
const float SCALE = 1000.0;

// Steps along a line of the bilateral mean, on either side, to two standard deviations.
const int LINE_REACH = 6;

// The ratio of standard deviations at which a difference of Gaussians approximates the Laplacian of a Gaussian (Marr and Hildreth 1980).
const float WIDER = 1.6;

// Samples across an edge: steps of 0.8 standard deviations to three of the wider Gaussian.
const float EDGE_STEP = 0.8;
const int EDGE_REACH = 6;

// Standard deviation of the smoothing of lines along the edge, in widths of a line, and the steps of one pixel on either side.
const float ALONG = 1.5;
const int ALONG_REACH = 8;

// A difference of 0.02 is a full line at strength 1; one of 0.01 is none.
const float LINE_GAIN = 100.0;
const float LINE_LEAST = 1.0;

// The share of a step over which two tones meet: at least this much, so that noise does not move their border by many pixels.
const float LEAST_SOFT = 0.12;

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

// A difference of Gaussians of the brightness across the edge (x), and the brightness under the wider one (y), with `sigma` as the
// standard deviation of the narrower one in pixels of the layer. Transparent areas count as white.
vec2 edgeResponse(vec2 along, float sigma) {
  vec2 stepUv = EDGE_STEP * sigma * vec2(-along.y, along.x) / RENDERSIZE;
  vec2 sum = vec2(0.0);
  vec2 total = vec2(0.0);
  for (int i = -EDGE_REACH; i <= EDGE_REACH; i++) {
    vec4 color = readLayer(isf_FragNormCoord + float(i) * stepUv);
    vec2 share = vec2(weight(i, 1.0 / EDGE_STEP), weight(i, WIDER / EDGE_STEP));
    sum += share * (dot(color.rgb, LUMA_709) + 1.0 - color.a);
    total += share;
  }
  vec2 mean = sum / total;
  return vec2(mean.x - mean.y, mean.y);
}

// Ink of a line from 0 to 1 by the soft threshold of XDoG; dark sides of edges have a negative difference.
float lineInk(float difference, float strength) {
  float e = exp(-2.0 * max(-LINE_GAIN * strength * difference - LINE_LEAST, 0.0));
  return 1.0 - 2.0 * e / (1.0 + e);
}

// Premultiplied from straight alpha.
vec4 premultiplied(vec4 color) {
  return vec4(color.rgb * color.a, color.a);
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

// Straight color of the evened layer with the saturation of the parameter.
vec3 inkedColor(vec4 area) {
  vec3 straight = area.rgb / max(area.a, 0.0001);
  float gray = dot(straight, LUMA_709);
  return clamp(mix(vec3(gray), straight, colors), 0.0, 1.0);
}

float brightness(vec2 uv) {
  vec4 area = IMG_NORM_PIXEL(areas, uv);
  return dot(area.rgb, LUMA_709) + 1.0 - area.a;
}

// The share of a dot's cell that ink covers here: from 0 at the center of a gap to 1 at the center of a dot, against `cover`.
float dotInk(float cover) {
  vec2 px = isf_FragNormCoord * RENDERSIZE;
  // Rows of dots at 45 degrees.
  vec2 screen = 0.70710678 * vec2(px.x + px.y, px.y - px.x) / sizePx;
  float spot = 0.5 + 0.25 * (cos(2.0 * PI * screen.x) + cos(2.0 * PI * screen.y));
  float perPixel = 0.5 * PI / sizePx;
  return clamp((mix(-0.5 * perPixel, 1.0 + 0.5 * perPixel, cover) - spot) / perPixel + 0.5, 0.0, 1.0);
}

// The difference of Gaussians, averaged along the edge.
float flowLine() {
  float sum = IMG_NORM_PIXEL(edges, isf_FragNormCoord).x;
  float total = 1.0;
  vec2 first = alongEdge(isf_FragNormCoord, vec2(1.0, 0.0), pullOf(1.0));
  for (int side = 0; side < 2; side++) {
    vec2 uv = isf_FragNormCoord;
    vec2 along = side == 0 ? first : -first;
    for (int i = 1; i <= ALONG_REACH; i++) {
      uv += along / RENDERSIZE;
      vec2 next = alongEdge(uv, vec2(1.0, 0.0), pullOf(1.0));
      along = dot(next, along) < 0.0 ? -next : next;
      float share = weight(i, ALONG * linePx);
      sum += share * IMG_NORM_PIXEL(edges, uv).x;
      total += share;
    }
  }
  return sum / total;
}

void main() {
  if (PASSINDEX == 0) {
    gl_FragColor = vec4(structureTensor(), 1.0);
  } else if (PASSINDEX == 1) {
    gl_FragColor = smoothTensor(vec2(1.0 / RENDERSIZE.x, 0.0));
  } else if (PASSINDEX == 2) {
    gl_FragColor = smoothTensor(vec2(0.0, 1.0 / RENDERSIZE.y));
  } else if (PASSINDEX < 7) {
    gl_FragColor = bilateralLine(PASSINDEX == 3 || PASSINDEX == 5, 1.0 + 4.0 * simplify, 0.1 + 0.5 * simplify);
  } else if (PASSINDEX == 7) {
    gl_FragColor = vec4(edgeResponse(alongEdge(isf_FragNormCoord, vec2(1.0, 0.0), pullOf(1.0)), 0.5 * linePx), 0.0, 1.0);
  } else {
    vec4 area = IMG_NORM_PIXEL(areas, isf_FragNormCoord);
    vec3 color = inkedColor(area);
    float steps = floor(levels + 0.5);
    float from = dot(color, LUMA_709);
    float tone = from * steps;
    // Steep borders are one pixel wide.
    vec2 px = 1.0 / RENDERSIZE;
    float slope = length(vec2(brightness(isf_FragNormCoord + vec2(px.x, 0.0)) - brightness(isf_FragNormCoord - vec2(px.x, 0.0)),
      brightness(isf_FragNormCoord + vec2(0.0, px.y)) - brightness(isf_FragNormCoord - vec2(0.0, px.y))));
    float soft = clamp(slope * steps, LEAST_SOFT, 1.0);
    float plain = softSteps(tone, soft);
    float dotted = floor(tone) + 1.0 - dotInk(floor(tone) + 1.0 - tone);
    float shaded = mix(dotted, plain, smoothstep(shadows - 0.1, shadows, from + 0.1 * step(shadows, 0.0)));
    vec3 drawn = withTone(color, from, clamp(shaded / steps, 0.0, 1.0));
    float line = lines * lineInk(flowLine(), 1.0);
    vec4 result = mix(vec4(drawn, 1.0), premultiplied(inkColor), line) * area.a;
#ifndef SCRIM
    if (result.a > 0.0) result.rgb /= result.a;
#endif
    gl_FragColor = result;
  }
}
