/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Oil painting",
  "DESCRIPTION": "Paints an image in oil: thick strokes that follow its shapes, large in even areas and small at details, lit from the top left. The strokes keep their place on screen, so they flicker while the camera moves; those of Room drawing stay on real surfaces.",
  "CREDIT": "Scrim. Strokes of several sizes: A. Hertzmann 1998, Painterly Rendering with Curved Brush Strokes of Multiple Sizes. Relief: A. Hertzmann 2002, Fast Paint Texture. Colors: J. E. Kyprianidis, H. Kang and J. Döllner 2009, Image and Video Abstraction by Anisotropic Kuwahara Filtering",
  "CATEGORIES": ["Style", "Painterly", "Oil", "Brush", "Impasto", "Paint", "NPR"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to paint." },
    { "NAME": "brushPx", "TYPE": "float", "LABEL": "Brush width", "DOC": "Width of the largest strokes, in pixels of the layer.", "MIN": 4.0, "MAX": 40.0, "DEFAULT": 11.0, "UNIT": "px" },
    { "NAME": "stretch", "TYPE": "float", "LABEL": "Stroke length", "DOC": "Length of a stroke, in widths of the stroke.", "MIN": 1.0, "MAX": 4.0, "DEFAULT": 3.0 },
    { "NAME": "detail", "TYPE": "float", "LABEL": "Detail", "DOC": "How much small strokes are painted over edges and details. 0 paints large strokes alone.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.7, "UNIT": "ratio" },
    { "NAME": "follow", "TYPE": "float", "LABEL": "Follow shapes", "DOC": "How much strokes follow the shapes of the image. At 0 all have the direction of the angle.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.9, "UNIT": "ratio" },
    { "NAME": "angle", "TYPE": "float", "LABEL": "Angle", "DOC": "Direction of strokes in flat areas, counter-clockwise from the right.", "MIN": 0.0, "MAX": 3.1415927, "DEFAULT": 0.6, "UNIT": "rad" },
    { "NAME": "variety", "TYPE": "float", "LABEL": "Variety", "DOC": "How much the color differs from stroke to stroke and between bristles.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.4, "UNIT": "ratio" },
    { "NAME": "relief", "TYPE": "float", "LABEL": "Relief", "DOC": "How thick the paint is. 0 is flat.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.35, "UNIT": "ratio" }
  ],
  "PASSES": [
    { "TARGET": "tensor", "FLOAT": true, "SCRIM_HALF": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Structure tensor, at half size." },
    { "TARGET": "tensorAcross", "FLOAT": true, "SCRIM_HALF": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Smooths it along x." },
    { "TARGET": "smoothed", "FLOAT": true, "SCRIM_HALF": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Smooths it along y." },
    { "TARGET": "colors", "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Colors of strokes: anisotropic Kuwahara filter, at half size." },
    { "TARGET": "painted", "DESCRIPTION": "Color of the upmost stroke, and its height as alpha." },
    { "DESCRIPTION": "Lights the relief." }
  ]
}*/

// Standard deviation of the smoothing of directions, at half size, and the radius of its kernel.
const float SMOOTH_PX = 3.0;
const int SMOOTH_REACH = 8;

// Scales squares of small differences above the smallest steps of 16-bit floats.
const float SCALE = 1000.0;

// A prime p for which 3 does not divide p - 1, so that cubes permute the integers below it. Squares of numbers below 2 p are exact.
const float PERIOD = 509.0;

// The Kuwahara filter: eight sectors, three rings of an ellipse, three directions per sector.
const int SECTORS = 8;
const int RINGS = 3;

// Half of the longest axis of the ellipse, in pixels at half size.
const float KUWAHARA_PX = 3.0;

// The power of a sector's variance, on a scale from 0 to 255: the larger, the harder the borders.
const float SHARPNESS = 4.0;

// Cells around a pixel in which strokes that cover it may begin. A cell is 1.3 widths of a stroke, and a stroke at most four widths long.
const int CELLS = 2;
const float CELL = 1.3;

// How strongly a stroke with a higher place hides one below.
const float HIDING = 24.0;

// Small strokes are this share of the width of large ones.
const float SMALLER = 0.35;

// Bristles of a brush.
const float BRISTLES = 7.0;

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

// The unit vector along the edges at `uv`, and the strength of the edge as a change of color per pixel.
vec3 strokeAt(vec2 uv) {
  vec2 along = alongEdge(uv, vec2(cos(angle), sin(angle)), pullOf(follow));
  vec3 t = IMG_NORM_PIXEL(smoothed, uv).xyz;
  return vec3(along, sqrt(max(t.x + t.y, 0.0) / SCALE));
}

// An anisotropic Kuwahara filter: of eight sectors of an ellipse along the edge, the evenest gives the color.
vec4 kuwahara() {
  vec3 t = IMG_NORM_PIXEL(smoothed, isf_FragNormCoord).xyz;
  float spread = length(vec2(t.x - t.y, 2.0 * t.z));
  float anisotropy = spread / (t.x + t.y + 0.5);
  vec2 along = alongEdge(isf_FragNormCoord, vec2(1.0, 0.0), pullOf(1.0));
  vec2 longer = KUWAHARA_PX * (1.0 + anisotropy) * along;
  vec2 shorter = KUWAHARA_PX / (1.0 + anisotropy) * vec2(-along.y, along.x);
  vec4 middle = readLayer(isf_FragNormCoord);
  vec4 sum = vec4(0.0);
  float whole = 0.0;
  for (int sector = 0; sector < SECTORS; sector++) {
    vec4 mean = middle;
    vec4 square = middle * middle;
    float total = 1.0;
    for (int ring = 1; ring <= RINGS; ring++) {
      for (int side = -1; side <= 1; side++) {
        float turn = 0.78539816 * (float(sector) + 0.5 * float(side));
        vec2 offset = float(ring) / float(RINGS) * (cos(turn) * longer + sin(turn) * shorter);
        float share = (side == 0 ? 1.0 : 0.5) * weight(ring, float(RINGS));
        vec4 color = readLayer(isf_FragNormCoord + offset / RENDERSIZE);
        mean += share * color;
        square += share * color * color;
        total += share;
      }
    }
    mean /= total;
    float variance = dot(max(square / total - mean * mean, 0.0), vec4(1.0));
    float share = 1.0 / (1.0 + pow(255.0 * sqrt(variance), SHARPNESS));
    sum += share * mean;
    whole += share;
  }
  return sum / whole;
}

// Noise from 0 to 1 across a brush: one number per bristle, the same along a stroke.
float bristle(float across, float seed) {
  float at = (0.5 * across + 0.5) * BRISTLES;
  float cell = floor(at);
  float part = at - cell;
  part *= part * (3.0 - 2.0 * part);
  return mix(strokeNoise(vec2(cell, seed)).x, strokeNoise(vec2(cell + 1.0, seed)).x, part);
}

// Adds the strokes of one size that cover this pixel: straight color and height, times the weight of the stroke (`sum`), and weights.
// `above` is the place of these strokes among those of other sizes.
void addStrokes(float widthPx, float above, bool small, inout vec4 sum, inout float total) {
  vec2 px = isf_FragNormCoord * RENDERSIZE;
  float cellPx = CELL * widthPx;
  vec2 home = floor(px / cellPx);
  for (int y = -CELLS; y <= CELLS; y++) {
    for (int x = -CELLS; x <= CELLS; x++) {
      vec2 cell = home + vec2(float(x), float(y));
      vec4 chance = strokeNoise(cell + (small ? 131.0 : 0.0));
      vec2 anchor = (cell + 0.15 + 0.7 * chance.xy) * cellPx;
      vec2 uv = anchor / RENDERSIZE;
      vec3 found = strokeAt(uv);
      float shown = small ? smoothstep(0.16, 0.04, 0.25 * (1.0 - detail) + 0.16 - found.z * detail) : 1.0;
      if (shown <= 0.0) continue;
      vec2 offset = px - anchor;
      vec2 local = vec2(dot(offset, found.xy) / (0.5 * stretch * widthPx), dot(offset, vec2(-found.y, found.x)) / (0.5 * widthPx));
      if (abs(local.x) > 1.0 || abs(local.y) > 1.0) continue;
      float hair = bristle(local.y, floor(chance.z * 288.0));
      // Bristles end at different places, and the sides of a stroke are round.
      float end = 1.0 - 0.45 * hair - 0.35 * local.y * local.y;
      float cover = smoothstep(0.0, 0.12, end - abs(local.x)) * smoothstep(0.0, 0.3, 1.0 - abs(local.y)) * shown;
      float share = cover * exp2(HIDING * (chance.w - 1.0) + above);
      vec4 color = IMG_NORM_PIXEL(colors, uv);
      float lighter = variety * (0.16 * (chance.z - 0.5) + 0.16 * (hair - 0.5));
      vec3 straight = clamp(color.rgb / max(color.a, 0.0001) + lighter, 0.0, 1.0);
      // Paint is thicker at the end of a stroke and at its sides.
      float height = 0.4 + (small ? 0.25 : 0.45) * hair + 0.15 * local.y * local.y;
      sum += share * vec4(straight, height * (small ? 0.8 : 1.0));
      total += share;
    }
  }
}

void main() {
  if (PASSINDEX == 0) {
    gl_FragColor = vec4(structureTensor(), 1.0);
  } else if (PASSINDEX == 1) {
    gl_FragColor = smoothTensor(vec2(1.0 / RENDERSIZE.x, 0.0));
  } else if (PASSINDEX == 2) {
    gl_FragColor = smoothTensor(vec2(0.0, 1.0 / RENDERSIZE.y));
  } else if (PASSINDEX == 3) {
    gl_FragColor = kuwahara();
  } else if (PASSINDEX == 4) {
    // Where no stroke is, the ground has the color of the image.
    vec4 ground = IMG_NORM_PIXEL(colors, isf_FragNormCoord);
    float total = exp2(-HIDING - 2.0);
    vec4 sum = total * vec4(ground.rgb / max(ground.a, 0.0001), 0.2);
    addStrokes(brushPx, 0.0, false, sum, total);
    if (detail > 0.0) addStrokes(max(SMALLER * brushPx, 2.0), HIDING, true, sum, total);
    gl_FragColor = sum / total;
  } else {
    vec4 paint = IMG_NORM_PIXEL(painted, isf_FragNormCoord);
    vec2 px = 1.0 / RENDERSIZE;
    // Light from the top left.
    float slope = IMG_NORM_PIXEL(painted, isf_FragNormCoord + vec2(px.x, -px.y)).a - IMG_NORM_PIXEL(painted, isf_FragNormCoord + vec2(-px.x, px.y)).a;
    float lit = clamp(relief * slope, -0.3, 0.3);
    vec3 color = paint.rgb * (1.0 + lit) + max(lit, 0.0) * 0.25;
    vec4 result = vec4(clamp(color, 0.0, 1.0), 1.0) * readLayer(isf_FragNormCoord).a;
#ifndef SCRIM
    if (result.a > 0.0) result.rgb /= result.a;
#endif
    gl_FragColor = result;
  }
}
