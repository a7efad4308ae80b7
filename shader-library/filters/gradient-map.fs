/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Replaces each color by the color of a gradient at its brightness, or at another channel: duotones, heat maps, tinted masks.",
  "CREDIT": "Scrim",
  "CATEGORIES": ["Color", "Color ramp", "Gradient map", "Duotone", "Tint", "Heat map", "False color", "Lookup", "Ramp"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to color." },
    { "NAME": "gradient", "TYPE": "gradient", "LABEL": "Gradient", "DOC": "The colors, from 0 at the left to 1 at the right. Transparent stops make the layer transparent.", "DEFAULT": [[0, 0.05, 0.04, 0.17, 1, 0], [0.4, 0.55, 0.16, 0.51, 1, 0], [0.75, 1, 0.62, 0.43, 1, 0], [1, 0.99, 0.99, 0.75, 1, 0]] },
    { "NAME": "channel", "TYPE": "long", "LABEL": "Position from", "DOC": "What of the layer is the position on the gradient. From alpha, the gradient alone sets the new alpha.", "VALUES": [0, 1, 2, 3, 4], "LABELS": ["Brightness", "Red", "Green", "Blue", "Alpha"], "DEFAULT": 0 },
    { "NAME": "shift", "TYPE": "float", "LABEL": "Shift", "DOC": "Added to the position.", "MIN": -1.0, "MAX": 1.0, "DEFAULT": 0.0, "UNIT": "ratio" },
    { "NAME": "beyond", "TYPE": "long", "LABEL": "Beyond the ends", "DOC": "The colors of positions that are shifted below 0 or above 1.", "VALUES": [0, 1, 2], "LABELS": ["End colors", "Repeat", "Mirror"], "DEFAULT": 0 },
    { "NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DOC": "Strength of the effect: 0 leaves the image unchanged.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 1.0, "IDENTITY": 0.0, "UNIT": "ratio" }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

float positionOf(vec4 color) {
  if (channel == 1) return color.r;
  if (channel == 2) return color.g;
  if (channel == 3) return color.b;
  return channel == 4 ? color.a : dot(color.rgb, LUMA_709);
}

// Whole positions stay as they are, so that white keeps the last color where nothing is shifted.
float inGradient(float at) {
  if (beyond == 0 || (at >= 0.0 && at <= 1.0)) return at;
  return beyond == 1 ? fract(at) : 1.0 - abs(1.0 - mod(at, 2.0));
}

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  vec4 mapped = color;
  // Other hosts do not support gradients and show the layer unchanged.
#ifdef SCRIM
  mapped = GRADIENT(gradient, inGradient(positionOf(color) + shift));
  if (channel != 4) mapped.a *= color.a;
#endif
  float alpha = mix(color.a, mapped.a, amount);
  vec3 premultiplied = mix(color.rgb * color.a, mapped.rgb * mapped.a, amount);
  gl_FragColor = vec4(premultiplied / max(alpha, 0.00001), alpha);
}
