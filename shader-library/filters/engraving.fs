/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Draws an image as a copper engraving: lines that swell where it is darker, bow over its shapes, and are crossed in the shadows. The lines keep their place on screen but for the bow, so they flicker while the camera moves.",
  "CREDIT": "Scrim. After V. Ostromoukhov 1999, Digital Facial Engraving. Luma: Rec. ITU-R BT.709",
  "CATEGORIES": ["Style", "Drawing", "Engraving", "Banknote", "Lines", "Print", "Ink", "NPR"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to draw." },
    { "NAME": "spacing", "TYPE": "float", "LABEL": "Line distance", "DOC": "Distance from one line to the next, in pixels of the layer.", "MIN": 3.0, "MAX": 32.0, "DEFAULT": 6.0, "UNIT": "px" },
    { "NAME": "angle", "TYPE": "float", "LABEL": "Angle", "DOC": "Direction of the lines, counter-clockwise from the right.", "MIN": 0.0, "MAX": 3.1415927, "DEFAULT": 0.43633231, "UNIT": "rad" },
    { "NAME": "bow", "TYPE": "float", "LABEL": "Bow", "DOC": "How far brighter areas push the lines aside, as if they were raised. At 0 the lines are straight.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "UNIT": "ratio" },
    { "NAME": "crossing", "TYPE": "float", "LABEL": "Crossing lines", "DOC": "How much of the dark tones a second set of lines draws. At 0 there is one set.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.6, "UNIT": "ratio" },
    { "NAME": "pressure", "TYPE": "float", "LABEL": "Pressure", "DOC": "Amount of ink: the middle tones become darker above 0.5 and lighter below.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "UNIT": "ratio" },
    { "NAME": "inkColor", "TYPE": "color", "LABEL": "Ink", "DOC": "Color of the lines.", "DEFAULT": [0.08, 0.08, 0.1, 1.0] },
    { "NAME": "paperColor", "TYPE": "color", "LABEL": "Paper", "DOC": "Color between the lines.", "DEFAULT": [0.97, 0.96, 0.93, 1.0] },
    { "NAME": "pictureColors", "TYPE": "bool", "LABEL": "Colors of the image", "DOC": "Draw the lines in the colors of the image.", "DEFAULT": false }
  ],
  "PASSES": [
    { "TARGET": "reliefAcross", "FLOAT": true, "SCRIM_HALF": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Brightness at half size, smoothed along x." },
    { "TARGET": "relief", "FLOAT": true, "SCRIM_HALF": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Smooths it along y." },
    { "DESCRIPTION": "Draws the lines on paper." }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

// Standard deviation of the smoothing of the relief, at half size, and the radius of its kernel.
const float RELIEF_PX = 5.0;
const int RELIEF_REACH = 13;

// The lines of a white area are pushed aside by so many pixels, against those of a black one.
const float BOW_PX = 40.0;

// Cosine and sine of the angle between the lines and those that cross them, 60°: right angles look like a net.
const vec2 CROSSED = vec2(0.5, 0.8660254);

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

// How much ink is at a place of this rank, so that the mean over all ranks from 0 to 1 is `dark`: the highest ranks get ink first. `soft`
// is the range of ranks over which the ink fades.
float inkAtRank(float rank, float dark, float soft) {
  float least = min(dark, 1.0 - dark);
  // Near white and black the range is cut off, and the mean is a square.
  float from = least < 0.5 * soft ? 2.0 * sqrt(0.5 * least * soft) - 0.5 * soft : least;
  float above = dark < 0.5 ? 1.0 - from : from;
  return clamp((rank - above) / soft + 0.5, 0.0, 1.0);
}

// Brightness of a premultiplied color. Transparent areas count as white.
float brightness(vec4 color) {
  return dot(color.rgb, LUMA_709) + 1.0 - color.a;
}

// A Gaussian mean along `stepUv`, one pixel apart: of the brightness in the first pass, of its mean in the second.
float smoothRelief(vec2 stepUv) {
  float sum = 0.0;
  float total = 0.0;
  for (int i = -RELIEF_REACH; i <= RELIEF_REACH; i++) {
    float share = weight(i, RELIEF_PX);
    vec2 uv = isf_FragNormCoord + float(i) * stepUv;
    sum += share * (PASSINDEX == 0 ? brightness(readLayer(uv)) : IMG_NORM_PIXEL(reliefAcross, uv).x);
    total += share;
  }
  return sum / total;
}

// Ink of one set of lines, whose mean is `dark`. `across` is the unit vector from line to line, `height` the relief, and `slope` its
// gradient per pixel.
float engraved(vec2 across, float height, vec2 slope, float dark) {
  float push = bow * BOW_PX;
  float phase = (dot(across, isf_FragNormCoord * RENDERSIZE) + push * height) / spacing;
  // 0 in the middle between two lines and 1 on a line; edges are antialiased over its change per pixel.
  float rank = 1.0 - abs(2.0 * fract(phase) - 1.0);
  float perPixel = 2.0 * length(across + push * slope) / spacing;
  return inkAtRank(rank, dark, clamp(perPixel, 0.02, 1.0));
}

void main() {
  if (PASSINDEX == 0) {
    gl_FragColor = vec4(vec3(smoothRelief(vec2(1.0 / RENDERSIZE.x, 0.0))), 1.0);
  } else if (PASSINDEX == 1) {
    gl_FragColor = vec4(vec3(smoothRelief(vec2(0.0, 1.0 / RENDERSIZE.y))), 1.0);
  } else {
    vec4 picture = readLayer(isf_FragNormCoord);
    vec4 found = pigment(picture.rgb / max(picture.a, 0.0001), paperColor.rgb);
    float asked = pictureColors ? found.a : 1.0 - brightness(picture);
    float dark = pow(clamp(asked, 0.0, 1.0), exp2(1.0 - 2.0 * pressure));

    float height = IMG_NORM_PIXEL(relief, isf_FragNormCoord).x;
    vec2 right = vec2(2.0 / RENDERSIZE.x, 0.0);
    vec2 up = vec2(0.0, 2.0 / RENDERSIZE.y);
    vec2 slope = 0.25 * vec2(
      IMG_NORM_PIXEL(relief, isf_FragNormCoord + right).x - IMG_NORM_PIXEL(relief, isf_FragNormCoord - right).x,
      IMG_NORM_PIXEL(relief, isf_FragNormCoord + up).x - IMG_NORM_PIXEL(relief, isf_FragNormCoord - up).x
    );

    // Of what is darker than one half, the crossing lines draw a share. Both sets are independent, so their gaps multiply.
    float first = dark - crossing * max(dark - 0.5, 0.0);
    float second = 1.0 - (1.0 - dark) / max(1.0 - first, 0.0001);
    vec2 across = vec2(-sin(angle), cos(angle));
    vec2 turned = vec2(CROSSED.x * across.x - CROSSED.y * across.y, CROSSED.y * across.x + CROSSED.x * across.y);
    float gaps = 1.0 - engraved(across, height, slope, first);
    if (crossing > 0.0) gaps *= 1.0 - engraved(turned, height, slope, second);

    vec4 ink = pictureColors ? vec4(found.rgb, 1.0) : inkColor;
    vec4 result = mix(premultiplied(ink), premultiplied(paperColor), gaps) * picture.a;
#ifndef SCRIM
    if (result.a > 0.0) result.rgb /= result.a;
#endif
    gl_FragColor = result;
  }
}
