/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Makes one color transparent at any brightness, such as a green screen, and removes its color spill from the rest.",
  "CREDIT": "Scrim. Color differences: Rec. ITU-R BT.709",
  "CATEGORIES": ["Key", "Green screen", "Greenscreen", "Blue screen", "Matte", "Cut out"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer whose background becomes transparent." },
    { "NAME": "keyColor", "TYPE": "color", "LABEL": "Key color", "DOC": "Color of the background.", "DEFAULT": [0.0, 0.7, 0.2, 1.0] },
    { "NAME": "tolerance", "TYPE": "float", "LABEL": "Tolerance", "DOC": "How much a color may differ from the key color and still be fully transparent. 0.5 is the difference between pure blue and gray.", "MIN": 0.0, "MAX": 0.7, "DEFAULT": 0.15, "UNIT": "ratio" },
    { "NAME": "softness", "TYPE": "float", "LABEL": "Softness", "DOC": "Color difference beyond the tolerance over which the layer becomes opaque. Smooths the edge.", "MIN": 0.0, "MAX": 0.5, "DEFAULT": 0.1, "UNIT": "ratio" },
    { "NAME": "spill", "TYPE": "float", "LABEL": "Spill removal", "DOC": "How much of the key color is removed from the remaining pixels.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "UNIT": "ratio" }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

// Cb = (B - Y) / 2 (1 - kb) and Cr = (R - Y) / 2 (1 - kr), both in [-0.5, 0.5].
const vec2 RANGE = vec2(1.8556, 1.5748);

// A quarter of an 8-bit step: a hard edge. A key with less chroma than this is gray and has no spill.
const float LEAST = 0.001;

vec2 chromaOf(vec3 color) {
  return (color.br - dot(color, LUMA_709)) / RANGE;
}

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  float luma = dot(color.rgb, LUMA_709);
  vec2 chroma = chromaOf(color.rgb);
  vec2 key = chromaOf(keyColor.rgb);
  float opaque = clamp((distance(chroma, key) - tolerance) / max(softness, LEAST), 0.0, 1.0);

  float strength = length(key);
  vec2 towardsKey = strength > LEAST ? key / strength : vec2(0.0);
  chroma -= spill * max(dot(chroma, towardsKey), 0.0) * towardsKey;
  vec2 blueRed = luma + chroma * RANGE;
  float green = (luma - LUMA_709.b * blueRed.x - LUMA_709.r * blueRed.y) / LUMA_709.g;
  gl_FragColor = vec4(blueRed.y, green, blueRed.x, color.a * opaque);
}
