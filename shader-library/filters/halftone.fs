/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Draws an image as halftone dots, as in a newspaper: small dots in light areas, large merging dots in dark areas.",
  "CREDIT": "Scrim. Dots: cosine spot function of PostScript (PLRM 3, section 7.4.3). Luma: Rec. ITU-R BT.709",
  "CATEGORIES": ["Style", "Dots", "Print", "Newspaper", "Comic"],
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to draw." },
    { "NAME": "size", "TYPE": "float", "LABEL": "Dot distance", "DOC": "Distance from one dot to the next, in pixels of the layer.", "MIN": 3.0, "MAX": 64.0, "DEFAULT": 8.0, "UNIT": "px" },
    { "NAME": "angle", "TYPE": "float", "LABEL": "Angle", "DOC": "Rotation of the rows of dots, counter-clockwise.", "MIN": 0.0, "MAX": 1.5707963, "DEFAULT": 0.78539816, "UNIT": "rad" },
    { "NAME": "inkColor", "TYPE": "color", "LABEL": "Ink", "DOC": "Color of the dots.", "DEFAULT": [0.0, 0.0, 0.0, 1.0] },
    { "NAME": "paperColor", "TYPE": "color", "LABEL": "Paper", "DOC": "Color between the dots.", "DEFAULT": [1.0, 1.0, 1.0, 1.0] },
    { "NAME": "pictureColors", "TYPE": "bool", "LABEL": "Colors of the image", "DOC": "Draw the dots in the colors of the image instead of the ink color.", "DEFAULT": false }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);
const float PI = 3.14159265;

// (cosine, sine) for 0 to a quarter turn. The built-in functions of a GPU may have an error of 1 / 2000, which moves the dots of a wide
// image; the series for half of the angle is accurate to 8 digits.
vec2 direction(float turn) {
  float x = 0.5 * turn;
  float square = x * x;
  float s = x * (1.0 - square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0 * (1.0 - square / 72.0))));
  return vec2(1.0 - 2.0 * s * s, 2.0 * s * sqrt(1.0 - s * s));
}

void main() {
  vec4 picture = IMG_THIS_PIXEL(inputImage);
  vec2 px = isf_FragNormCoord * RENDERSIZE;
  float spacing = max(size, 3.0);
  vec2 along = direction(angle);
  vec2 screen = vec2(dot(along, px), along.x * px.y - along.y * px.x) / spacing;
  vec2 angles = 2.0 * PI * (fract(screen) - 0.5);

  // From 0 at the center of a dot to 1 at the center of a gap. The slope is at most `perPixel`, so an edge that is one
  // pixel wide is antialiased and not blurred.
  float spot = 0.5 + 0.25 * (cos(angles.x) + cos(angles.y));
  float perPixel = 0.5 * PI / spacing;
  float darkness = mix(-0.5 * perPixel, 1.0 + 0.5 * perPixel, 1.0 - dot(picture.rgb, LUMA_709));
  float ink = clamp((darkness - spot) / perPixel + 0.5, 0.0, 1.0);

  vec4 dots = pictureColors ? vec4(picture.rgb, 1.0) : inkColor;
  vec4 paper = paperColor;
  float alpha = mix(paper.a, dots.a, ink);
  vec3 color = mix(paper.rgb * paper.a, dots.rgb * dots.a, ink) / max(alpha, 0.0001);
  gl_FragColor = vec4(color, alpha * picture.a);
}
