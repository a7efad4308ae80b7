/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Hatched drawing",
  "DESCRIPTION": "Draws an image as a pen drawing: hatching that follows its shapes, crossed where it is dark, and lines along edges. The strokes keep their place on screen, so they flicker while the camera moves; those of Room drawing stay on real surfaces.",
  "CREDIT": "Scrim. Directions: J. E. Kyprianidis and J. Döllner 2008, Image Abstraction by Structure Adaptive Filtering. Lines: H. Kang et al. 2007, Coherent Line Drawing. Strokes: X. Mao et al. 2001, Automatic Generation of Pencil Drawing Using Line Integral Convolution",
  "CATEGORIES": ["Style", "Drawing", "Hatching", "Cross-hatching", "Pen", "Ink", "Engraving", "NPR"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to draw." },
    { "NAME": "strokePx", "TYPE": "float", "LABEL": "Stroke width", "DOC": "Width of a stroke, in pixels of the layer.", "MIN": 1.0, "MAX": 6.0, "DEFAULT": 1.5, "UNIT": "px" },
    { "NAME": "lengthPx", "TYPE": "float", "LABEL": "Stroke length", "DOC": "Length of a stroke, in pixels of the layer, up to twenty times its width.", "MIN": 4.0, "MAX": 80.0, "DEFAULT": 30.0, "UNIT": "px" },
    { "NAME": "follow", "TYPE": "float", "LABEL": "Follow shapes", "DOC": "How much strokes follow the shapes of the image. At 0 all have the direction of the angle.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.75, "UNIT": "ratio" },
    { "NAME": "angle", "TYPE": "float", "LABEL": "Angle", "DOC": "Direction of strokes in flat areas, counter-clockwise from the right.", "MIN": 0.0, "MAX": 3.1415927, "DEFAULT": 0.78539816, "UNIT": "rad" },
    { "NAME": "crossing", "TYPE": "float", "LABEL": "Crossing", "DOC": "Share of the tone of dark areas that strokes across the others draw. 0 draws no second direction.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.8, "UNIT": "ratio" },
    { "NAME": "pressure", "TYPE": "float", "LABEL": "Pressure", "DOC": "Amount of ink: the middle tones become darker above 0.5 and lighter below.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "UNIT": "ratio" },
    { "NAME": "lines", "TYPE": "float", "LABEL": "Outlines", "DOC": "Strength of lines along edges. 0 draws none.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.8, "UNIT": "ratio" },
    { "NAME": "inkColor", "TYPE": "color", "LABEL": "Ink", "DOC": "Color of the strokes.", "DEFAULT": [0.08, 0.08, 0.12, 1.0] },
    { "NAME": "paperColor", "TYPE": "color", "LABEL": "Paper", "DOC": "Color between the strokes.", "DEFAULT": [0.98, 0.96, 0.91, 1.0] },
    { "NAME": "pictureColors", "TYPE": "bool", "LABEL": "Colors of the image", "DOC": "Draw the strokes in the colors of the image.", "DEFAULT": false }
  ],
  "PASSES": [
    { "TARGET": "tensor", "FLOAT": true, "SCRIM_HALF": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Structure tensor, at half size." },
    { "TARGET": "tensorAcross", "FLOAT": true, "SCRIM_HALF": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Smooths it along x." },
    { "TARGET": "smoothed", "FLOAT": true, "SCRIM_HALF": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Smooths it along y." },
    { "TARGET": "grain", "WIDTH": "ceil($WIDTH / max($strokePx, 1))", "HEIGHT": "ceil($HEIGHT / max($strokePx, 1))", "DESCRIPTION": "Noise with one number per width of a stroke." },
    { "TARGET": "edges", "FLOAT": true, "SCRIM_HALF": true, "DESCRIPTION": "Difference of Gaussians across the edges, and brightness." },
    { "DESCRIPTION": "Draws strokes and lines on paper." }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

// Standard deviation of the smoothing of directions, at half size, and the radius of its kernel.
const float SMOOTH_PX = 3.0;
const int SMOOTH_REACH = 8;

// Scales squares of small differences above the smallest steps of 16-bit floats.
const float SCALE = 1000.0;

// The ratio of standard deviations at which a difference of Gaussians approximates the Laplacian of a Gaussian (Marr and Hildreth 1980).
const float WIDER = 1.6;

// Samples across an edge: steps of 0.8 standard deviations to three of the wider Gaussian.
const float EDGE_STEP = 0.8;
const int EDGE_REACH = 6;

// Steps along a stroke, on either side.
const int STROKE_REACH = 10;

// Standard deviation of the smoothing of lines along the edge (sigma m of Kang et al.).
const float LINE_PX = 3.0;

// A difference of 0.02 is a full line at strength 1; one of 0.005, the noise of cameras, is none.
const float LINE_GAIN = 100.0;
const float LINE_LEAST = 0.5;

// A prime p for which 3 does not divide p - 1, so that cubes permute the integers below it. Squares of numbers below 2 p are exact.
const float PERIOD = 509.0;

// The range of heights over which a stroke fades: a pixel at its edge, as ink is even.
const float SOFT = 0.5;

// Strokes cross from this tone on.
const float CROSSED_FROM = 0.45;

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

// Follows the edges from this pixel both ways, turned by a quarter if `crossed`. Gives the heights of two fields of strokes, each with a
// mean of 0 and a standard deviation of 1 (xy), and the difference of Gaussians along the edge (z): line integral convolution of noise.
vec3 stroke(vec2 usual, float pull, bool crossed, float widthPx, float lengthPx) {
  // A step of at most the width of a stroke leaves no gaps.
  float stepPx = min(widthPx, lengthPx / float(STROKE_REACH));
  vec2 first = alongEdge(isf_FragNormCoord, usual, pull);
  vec2 cells = RENDERSIZE / (widthPx * IMG_SIZE(grain));
  float sigma = 0.5 * float(STROKE_REACH);
  vec2 heights = IMG_NORM_PIXEL(grain, isf_FragNormCoord * cells).xy - 0.5;
  float line = IMG_NORM_PIXEL(edges, isf_FragNormCoord).x;
  float lines = 1.0;
  float total = 1.0;
  float squares = 1.0;
  for (int side = 0; side < 2; side++) {
    vec2 uv = isf_FragNormCoord;
    vec2 along = side == 0 ? first : -first;
    for (int i = 1; i <= STROKE_REACH; i++) {
      uv += stepPx * (crossed ? vec2(-along.y, along.x) : along) / RENDERSIZE;
      vec2 next = alongEdge(uv, usual, pull);
      along = dot(next, along) < 0.0 ? -next : next;
      float share = weight(i, sigma);
      heights += share * (IMG_NORM_PIXEL(grain, uv * cells).xy - 0.5);
      total += share;
      squares += share * share;
      float near = float(i) * stepPx / LINE_PX;
      float lineShare = exp(-0.5 * near * near);
      line += lineShare * IMG_NORM_PIXEL(edges, uv).x;
      lines += lineShare;
    }
  }
  // Bilinear noise has a variance of 1/27, and neighbors one cell apart a correlation of 1/4, on either side.
  float variance = min(squares * 1.5 * widthPx / (stepPx * total * total), 1.0) / 27.0;
  return vec3(heights / (total * sqrt(variance)), line / lines);
}

// How much ink is at a place of this rank, so that the mean over all ranks from 0 to 1 is `dark`: the highest ranks get ink first. `soft`
// is the range of ranks over which the ink fades.
float inkAtRank(float rank, float dark, float soft) {
  float least = min(dark, 1.0 - dark);
  // Near white and black the range is cut off, and the mean is a square.
  float from = least < 0.5 * soft ? 2.0 * sqrt(0.5 * least * soft) - 0.5 * soft : least;
  float above = dark < 0.5 ? 1.0 - from : from;
  return clamp((rank - above) / soft + 0.5, 0.0, 1.0);
}

// How much ink is at a stroke's height, so that the mean over all heights is `dark`. `soft` is the range of heights over which a stroke
// fades. Heights are normally distributed; a logistic curve makes all of them equally frequent.
float inkAt(float height, float dark, float soft) {
  return inkAtRank(1.0 / (1.0 + exp(-1.702 * height)), dark, soft);
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

// The tensor of flat areas for `amount` of following: at 1 below the noise of cameras, at 0 above every edge.
float pullOf(float amount) {
  return 0.3 * exp2(16.0 * (1.0 - amount));
}

// Straight color of the ink that gives `color` on this paper, and the share of the paper that it covers (alpha).
vec4 pigment(vec3 color, vec3 paper) {
  vec3 missing = 1.0 - color / max(paper, 0.05);
  float dark = clamp(max(missing.r, max(missing.g, missing.b)), 0.0, 1.0);
  return vec4(clamp(paper * (1.0 - missing / max(dark, 0.05)), 0.0, 1.0), dark);
}

void main() {
  vec2 usual = vec2(cos(angle), sin(angle));
  if (PASSINDEX == 0) {
    gl_FragColor = vec4(structureTensor(), 1.0);
  } else if (PASSINDEX == 1) {
    gl_FragColor = smoothTensor(vec2(1.0 / RENDERSIZE.x, 0.0));
  } else if (PASSINDEX == 2) {
    gl_FragColor = smoothTensor(vec2(0.0, 1.0 / RENDERSIZE.y));
  } else if (PASSINDEX == 3) {
    gl_FragColor = strokeNoise(floor(gl_FragCoord.xy));
  } else if (PASSINDEX == 4) {
    gl_FragColor = vec4(edgeResponse(alongEdge(isf_FragNormCoord, usual, pullOf(1.0)), 1.0), 0.0, 1.0);
  } else {
    vec3 drawn = stroke(usual, pullOf(follow), false, strokePx, lengthPx);
    vec3 over = stroke(usual, pullOf(follow), true, strokePx, lengthPx);
    vec4 picture = readLayer(isf_FragNormCoord);
    vec3 straight = picture.rgb / max(picture.a, 0.0001);
    vec4 found = pigment(straight, paperColor.rgb);
    float asked = pictureColors ? found.a : 1.0 - IMG_NORM_PIXEL(edges, isf_FragNormCoord).y;
    float dark = pow(asked, exp2(1.4 - 2.0 * pressure));
    // Two layers of independent strokes leave the product of what each leaves white.
    float crossed = crossing * smoothstep(CROSSED_FROM, 1.0, dark);
    float first = 1.0 - (1.0 - dark) / max(1.0 - crossed, 0.0001);
    float white = (1.0 - inkAt(drawn.x, max(first, 0.0), SOFT)) * (1.0 - inkAt(over.y, crossed, SOFT));
    float cover = max(1.0 - white, lines * lineInk(drawn.z, 1.0));
    vec4 ink = pictureColors ? vec4(found.rgb, 1.0) : inkColor;
    vec4 result = mix(premultiplied(paperColor), premultiplied(ink), min(cover, 1.0)) * picture.a;
#ifndef SCRIM
    if (result.a > 0.0) result.rgb /= result.a;
#endif
    gl_FragColor = result;
  }
}
