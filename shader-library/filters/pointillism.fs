/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Paints an image in dabs of pure color that mix in the eye: each dab differs in hue, and their mean is the color of the image. The dabs keep their place on screen, so they flicker while the camera moves.",
  "CREDIT": "Scrim. After G. Seurat and P. Signac; dabs of random order: P. Haeberli 1990, Paint By Numbers",
  "CATEGORIES": ["Style", "Painterly", "Dots", "Seurat", "Impressionism", "Paint", "NPR"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to paint." },
    { "NAME": "dabPx", "TYPE": "float", "LABEL": "Dab size", "DOC": "Diameter of a dab, in pixels of the layer.", "MIN": 3.0, "MAX": 40.0, "DEFAULT": 7.0, "UNIT": "px" },
    { "NAME": "hues", "TYPE": "float", "LABEL": "Hues", "DOC": "How much the hue differs from dab to dab. The mean of the colors stays the same.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.4, "UNIT": "ratio" },
    { "NAME": "tones", "TYPE": "float", "LABEL": "Tones", "DOC": "How much the brightness differs from dab to dab.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.4, "UNIT": "ratio" },
    { "NAME": "density", "TYPE": "float", "LABEL": "Density", "DOC": "Share of the dabs that are painted. The canvas is seen between them.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.9, "UNIT": "ratio" },
    { "NAME": "canvasColor", "TYPE": "color", "LABEL": "Canvas", "DOC": "Color between the dabs.", "DEFAULT": [0.9, 0.86, 0.76, 1.0] }
  ],
  "PASSES": [
    { "TARGET": "colors", "WIDTH": "ceil($WIDTH / (0.5 * max($dabPx, 3)))", "HEIGHT": "ceil($HEIGHT / (0.5 * max($dabPx, 3)))", "DESCRIPTION": "Mean colors, with two pixels per dab." },
    { "DESCRIPTION": "Paints the dabs." }
  ]
}*/

// A prime p for which 3 does not divide p - 1, so that cubes permute the integers below it. Squares of numbers below 2 p are exact.
const float PERIOD = 509.0;

// Cells around a pixel that may hold a dab which covers it. A cell is 0.55 dabs wide.
const int CELLS = 2;
const float CELL = 0.55;

// How strongly a dab with a higher place hides one below.
const float HIDING = 40.0;

// Samples of the mean color along each side of a pixel of the first pass.
const int SAMPLES = 4;

// The largest turn of a hue, in radians, and the largest change of the brightness relative to the range that is left.
const float MOST_TURN = 1.8;
const float MOST_TONE = 0.6;

// The layer at `uv`, premultiplied. Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha.
vec4 readLayer(vec2 uv) {
  vec4 color = IMG_NORM_PIXEL(inputImage, uv);
#ifndef SCRIM
  color.rgb *= color.a;
#endif
  return color;
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

// Premultiplied from straight alpha.
vec4 premultiplied(vec4 color) {
  return vec4(color.rgb * color.a, color.a);
}

// The mean of the layer over this pixel, which is larger than one of the layer.
vec4 meanColor() {
  vec4 sum = vec4(0.0);
  for (int y = 0; y < SAMPLES; y++) {
    for (int x = 0; x < SAMPLES; x++) {
      vec2 place = (vec2(float(x), float(y)) + 0.5) / float(SAMPLES) - 0.5;
      sum += readLayer(isf_FragNormCoord + place / RENDERSIZE);
    }
  }
  return sum / float(SAMPLES * SAMPLES);
}

// The color of a dab: `color` with its hue turned about gray, and lighter or darker, by random numbers from 0 to 1. Turns by up to x
// shorten the mean of the colors by sin(x) / x, which a higher saturation makes up for.
vec3 dabColor(vec3 color, vec2 chance) {
  float gray = (color.r + color.g + color.b) / 3.0;
  float room = min(gray, 1.0 - gray);
  vec3 pure = color - gray;
  // Strong colors turn less, because few other hues are as strong.
  float most = max(MOST_TURN * hues * min(room / max(length(pure), 0.0001), 1.0), 0.001);
  float turn = (2.0 * chance.x - 1.0) * most;
  vec3 turned = cos(turn) * pure + sin(turn) * (pure.brg - pure.gbr) / sqrt(3.0);
  float tone = MOST_TONE * tones * room * (2.0 * chance.y - 1.0);
  return clamp(gray + tone + most / sin(most) * turned, 0.0, 1.0);
}

// The color of the dabs at this pixel, premultiplied, over the canvas.
vec4 painted() {
  vec2 px = isf_FragNormCoord * RENDERSIZE;
  float cellPx = CELL * dabPx;
  vec2 home = floor(px / cellPx);
  float total = exp2(-HIDING);
  vec4 sum = total * premultiplied(canvasColor);
  for (int y = -CELLS; y <= CELLS; y++) {
    for (int x = -CELLS; x <= CELLS; x++) {
      vec2 cell = home + vec2(float(x), float(y));
      vec4 chance = strokeNoise(cell);
      vec4 more = strokeNoise(cell + 151.0);
      if (more.z >= density) continue;
      vec2 center = (cell + 0.05 + 0.9 * chance.xy) * cellPx;
      float radiusPx = 0.5 * dabPx * (0.8 + 0.4 * more.w);
      float cover = clamp(radiusPx + 0.5 - distance(px, center), 0.0, 1.0);
      if (cover <= 0.0) continue;
      vec4 color = IMG_NORM_PIXEL(colors, center / RENDERSIZE);
      float share = cover * exp2(HIDING * (chance.w - 1.0) + 4.0);
      sum += share * vec4(dabColor(color.rgb / max(color.a, 0.0001), vec2(chance.z, more.x)), 1.0);
      total += share;
    }
  }
  return sum / total;
}

void main() {
  if (PASSINDEX == 0) {
    gl_FragColor = meanColor();
  } else {
    vec4 result = painted() * readLayer(isf_FragNormCoord).a;
#ifndef SCRIM
    if (result.a > 0.0) result.rgb /= result.a;
#endif
    gl_FragColor = result;
  }
}
