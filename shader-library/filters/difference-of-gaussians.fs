/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Difference of Gaussians",
  "DESCRIPTION": "Draws an image as ink lines, with solid black in dark areas: the difference of two Gaussian blurs with a soft threshold (XDoG).",
  "CREDIT": "Scrim. H. Winnemöller et al. 2012, XDoG: An eXtended Difference-of-Gaussians Compendium, Computers & Graphics 36, 740, equations 5 and 7",
  "CATEGORIES": ["Edges", "Lines", "Style", "Ink", "Comic", "Drawing", "XDoG"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to draw. Transparent areas count as white." },
    { "NAME": "radius", "TYPE": "float", "LABEL": "Line width", "DOC": "Standard deviation of the narrower blur, in pixels of the layer: about half the width of the lines.", "MIN": 0.4, "MAX": 8.0, "DEFAULT": 1.0, "UNIT": "px" },
    { "NAME": "strength", "TYPE": "float", "LABEL": "Line strength", "DOC": "How much edges are emphasized before the threshold: 0 applies only the threshold, 20 draws fine lines.", "MIN": 0.0, "MAX": 60.0, "DEFAULT": 20.0 },
    { "NAME": "level", "TYPE": "float", "LABEL": "Level", "DOC": "Areas lighter than this stay paper: brightness from 0 to 1.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.6, "UNIT": "ratio" },
    { "NAME": "hardness", "TYPE": "float", "LABEL": "Hardness", "DOC": "How hard the transition from paper to ink is below the level: 1 gives shades, as a pencil does; 20 gives black and white, as ink does.", "MIN": 0.2, "MAX": 40.0, "DEFAULT": 4.0 },
    { "NAME": "lineColor", "TYPE": "color", "LABEL": "Ink", "DOC": "Color of the lines.", "DEFAULT": [0.0, 0.0, 0.0, 1.0] },
    { "NAME": "paperColor", "TYPE": "color", "LABEL": "Paper", "DOC": "Color between the lines.", "DEFAULT": [1.0, 1.0, 1.0, 1.0] },
    { "NAME": "overPicture", "TYPE": "bool", "LABEL": "Over the image", "DOC": "Draw the lines over the image instead of over the paper.", "DEFAULT": false }
  ],
  "PASSES": [{ "TARGET": "across", "FLOAT": true, "SCRIM_HALF": true, "DESCRIPTION": "Blurs along x, with both standard deviations." }, { "DESCRIPTION": "Blurs along y, with both standard deviations, and draws the result." }]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

// The ratio of the standard deviations at which the difference approximates the Laplacian of a Gaussian (Marr and Hildreth 1980).
const float WIDER = 1.6;

// Three standard deviations of the wider blur: 8 px x 1.6 x 3.
const float REACH = 3.0;
const int MAX_REACH = 39;

// 16-bit floats have 11 bits, whose rounding `strength` would make visible. Storing steps of 1/256 and the rest separately gives 19 bits.
const float STEPS = 256.0;

// The layer at `uv`, premultiplied. Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha.
vec4 readLayer(vec2 uv) {
  vec4 color = IMG_NORM_PIXEL(inputImage, uv);
#ifndef SCRIM
  color.rgb *= color.a;
#endif
  return color;
}

// The intermediate results of the two blurs at `uv`: the narrower in x, the wider in y.
vec2 tap(vec2 uv) {
  if (PASSINDEX == 1) {
    vec4 parts = IMG_NORM_PIXEL(across, uv);
    return parts.xz + parts.yw;
  }
  vec4 color = readLayer(uv);
  return vec2(dot(color.rgb, LUMA_709) + 1.0 - color.a);
}

vec2 blurred(vec2 stepUv) {
  vec2 sigma = max(radius, 0.4) * vec2(1.0, WIDER);
  float reach = ceil(REACH * sigma.y);
  vec2 sum = tap(isf_FragNormCoord);
  vec2 total = vec2(1.0);
  for (int i = 1; i <= MAX_REACH; i++) {
    float px = float(i);
    if (px > reach) break;
    vec2 weight = exp(-0.5 * px * px / (sigma * sigma));
    sum += weight * (tap(isf_FragNormCoord + px * stepUv) + tap(isf_FragNormCoord - px * stepUv));
    total += 2.0 * weight;
  }
  return sum / total;
}

// Premultiplied from straight alpha.
vec4 premultiplied(vec4 color) {
  return vec4(color.rgb * color.a, color.a);
}

void main() {
  if (PASSINDEX == 0) {
    vec2 found = blurred(vec2(1.0 / RENDERSIZE.x, 0.0));
    vec2 whole = floor(found * STEPS) / STEPS;
    gl_FragColor = vec4(whole.x, found.x - whole.x, whole.y, found.y - whole.y);
  } else {
    vec2 found = blurred(vec2(0.0, 1.0 / RENDERSIZE.y));
    float sharpened = (1.0 + strength) * found.x - strength * found.y;
    // 1 - tanh(x) of the paper, for x >= 0.
    float e = exp(-2.0 * hardness * max(level - sharpened, 0.0));
    float light = 2.0 * e / (1.0 + e);
    vec4 picture = readLayer(isf_FragNormCoord);
    vec4 paper = overPicture ? picture : premultiplied(paperColor) * picture.a;
    vec4 result = mix(premultiplied(lineColor) * picture.a, paper, light);
#ifndef SCRIM
    if (result.a > 0.0) result.rgb /= result.a;
#endif
    gl_FragColor = result;
  }
}
