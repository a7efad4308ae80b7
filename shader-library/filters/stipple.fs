/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Draws an image as a pen drawing of dots of nearly equal size: few in light areas, many in dark ones. The dots keep their place on screen, so they flicker while the camera moves.",
  "CREDIT": "Scrim. Order of the dots: M. Roberts 2018, The Unreasonable Effectiveness of Quasirandom Sequences. Luma: Rec. ITU-R BT.709",
  "CATEGORIES": ["Style", "Drawing", "Dots", "Pointillism", "Pen", "Ink", "NPR"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to draw." },
    { "NAME": "dotPx", "TYPE": "float", "LABEL": "Dot size", "DOC": "Diameter of a dot, in pixels of the layer.", "MIN": 1.5, "MAX": 16.0, "DEFAULT": 2.5, "UNIT": "px" },
    { "NAME": "variety", "TYPE": "float", "LABEL": "Variety", "DOC": "How much the size and the order of the dots vary. At 0 all have the same size and even distances.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "UNIT": "ratio" },
    { "NAME": "pressure", "TYPE": "float", "LABEL": "Pressure", "DOC": "Amount of ink: the middle tones become darker above 0.5 and lighter below.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "UNIT": "ratio" },
    { "NAME": "inkColor", "TYPE": "color", "LABEL": "Ink", "DOC": "Color of the dots.", "DEFAULT": [0.08, 0.08, 0.1, 1.0] },
    { "NAME": "paperColor", "TYPE": "color", "LABEL": "Paper", "DOC": "Color between the dots.", "DEFAULT": [0.97, 0.96, 0.93, 1.0] },
    { "NAME": "pictureColors", "TYPE": "bool", "LABEL": "Colors of the image", "DOC": "Draw the dots in the colors of the image.", "DEFAULT": false }
  ],
  "PASSES": [
    { "TARGET": "dots", "WIDTH": "ceil($WIDTH / (0.45 * max($dotPx, 1.5)))", "HEIGHT": "ceil($HEIGHT / (0.45 * max($dotPx, 1.5)))", "DESCRIPTION": "One dot per cell: its place in the cell, and its size." },
    { "DESCRIPTION": "Draws the dots on paper." }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

// A prime p for which 3 does not divide p - 1, so that cubes permute the integers below it. Squares of numbers below 2 p are exact.
const float PERIOD = 509.0;

// The R2 sequence: steps of the order of the dots from cell to cell. Dots whose order is below any number have even distances.
const vec2 ORDER = vec2(0.75487767, 0.56984029);

// Cells around a pixel that may hold a dot which covers it. A cell has 0.9 radii of a dot.
const int CELLS = 2;

// The share of the order over which a dot grows to its size, so that the noise of a camera does not make dots blink.
const float GROWTH = 0.25;

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

// Straight color of the ink that gives `color` on this paper, and the share of the paper that it covers (alpha).
vec4 pigment(vec3 color, vec3 paper) {
  vec3 missing = 1.0 - color / max(paper, 0.05);
  float dark = clamp(max(missing.r, max(missing.g, missing.b)), 0.0, 1.0);
  return vec4(clamp(paper * (1.0 - missing / max(dark, 0.05)), 0.0, 1.0), dark);
}

// The share of all dots that covers `dark` of the paper. Found by simulation: few dots do not overlap, so each covers its area, and the
// last gaps take most of the dots. The error of the tone is at most 0.03.
float dotsFor(float dark) {
  return 0.285 * dark + 0.24 * pow(dark, 6.0) + 0.5 * pow(dark, 24.0);
}

// Share of the paper that the layer asks to be covered. Transparent areas count as white.
float darkness(vec4 color) {
  float dark = pictureColors ? pigment(color.rgb / max(color.a, 0.0001), paperColor.rgb).w * color.a : color.a - dot(color.rgb, LUMA_709);
  return pow(clamp(dark, 0.0, 1.0), exp2(1.0 - 2.0 * pressure));
}

// The dot of this cell: its place in the cell (xy), and its radius relative to 1.2 radii of `dotPx` (z).
vec3 dotOfCell() {
  vec2 cell = floor(gl_FragCoord.xy);
  vec4 chance = strokeNoise(cell);
  vec2 place = 0.05 + 0.9 * chance.xy;
  float order = fract(dot(cell, ORDER)) * (1.0 + 0.6 * variety * (chance.z - 0.5));
  float share = dotsFor(darkness(readLayer((cell + place) / RENDERSIZE)));
  float grown = clamp((share - order) / max(GROWTH * share, 0.0001), 0.0, 1.0);
  return vec3(place, sqrt(grown) * (1.0 + 0.4 * variety * (chance.w - 0.5)) / 1.2);
}

// How much of this pixel a dot covers (x), and where its center is (yz), of the dot that covers most of it.
vec3 covered() {
  vec2 cells = IMG_SIZE(dots);
  vec2 cellPx = RENDERSIZE / cells;
  vec2 here = isf_FragNormCoord * cells;
  vec2 home = floor(here);
  vec3 found = vec3(0.0);
  for (int y = -CELLS; y <= CELLS; y++) {
    for (int x = -CELLS; x <= CELLS; x++) {
      vec2 cell = home + vec2(float(x), float(y));
      if (any(lessThan(cell, vec2(0.0))) || any(greaterThanEqual(cell, cells))) continue;
      vec4 drop = IMG_NORM_PIXEL(dots, (cell + 0.5) / cells);
      if (drop.z <= 0.0) continue;
      vec2 center = cell + drop.xy;
      float cover = clamp(0.6 * drop.z * dotPx + 0.5 - length((here - center) * cellPx), 0.0, 1.0);
      if (cover > found.x) found = vec3(cover, center / cells);
    }
  }
  return found;
}

void main() {
  if (PASSINDEX == 0) {
    gl_FragColor = vec4(dotOfCell(), 1.0);
  } else {
    vec3 found = covered();
    vec4 source = readLayer(found.yz);
    vec4 ink = pictureColors ? vec4(pigment(source.rgb / max(source.a, 0.0001), paperColor.rgb).rgb, 1.0) : inkColor;
    vec4 result = mix(premultiplied(paperColor), premultiplied(ink), found.x) * readLayer(isf_FragNormCoord).a;
#ifndef SCRIM
    if (result.a > 0.0) result.rgb /= result.a;
#endif
    gl_FragColor = result;
  }
}
