/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Makes a mask from one color: white where the layer has this color, black elsewhere. Light and shadow change the brightness of an object more than its color, so brightness can count less.",
  "CREDIT": "Scrim. Color differences: Rec. ITU-R BT.709",
  "CATEGORIES": ["Mask", "Key", "Color range", "Matte", "Select"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to read, such as the camera video." },
    { "NAME": "keyColor", "TYPE": "color", "LABEL": "Color", "DOC": "The color to find.", "DEFAULT": [0.8, 0.15, 0.1, 1.0] },
    { "NAME": "tolerance", "TYPE": "float", "LABEL": "Tolerance", "DOC": "How much a color may differ from “Color” and still be white in the mask. 0.5 is the difference between pure blue and gray.", "MIN": 0.0, "MAX": 0.7, "DEFAULT": 0.12, "UNIT": "ratio" },
    { "NAME": "softness", "TYPE": "float", "LABEL": "Softness", "DOC": "Color difference beyond the tolerance over which the mask becomes black. Smooths the edge.", "MIN": 0.0, "MAX": 0.5, "DEFAULT": 0.08, "UNIT": "ratio" },
    { "NAME": "brightness", "TYPE": "float", "LABEL": "Brightness weight", "DOC": "Weight of brightness differences: 0 ignores them, 1 counts them as much as color differences.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.1, "UNIT": "ratio" },
    { "NAME": "invert", "TYPE": "bool", "LABEL": "Invert", "DOC": "Swap black and white.", "DEFAULT": false }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

// Cb = (B - Y) / 2 (1 - kb) and Cr = (R - Y) / 2 (1 - kr), both in [-0.5, 0.5].
const vec2 RANGE = vec2(1.8556, 1.5748);

// A quarter of an 8-bit step: a hard edge.
const float LEAST = 0.001;

// Cb, Cr and the weighted luma.
vec3 placeOf(vec3 color) {
  float luma = dot(color, LUMA_709);
  return vec3((color.br - luma) / RANGE, luma * brightness);
}

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  float apart = distance(placeOf(color.rgb), placeOf(keyColor.rgb));
  float shown = color.a * (1.0 - clamp((apart - tolerance) / max(softness, LEAST), 0.0, 1.0));
  gl_FragColor = vec4(vec3(invert ? 1.0 - shown : shown), 1.0);
}
