/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Darkens an image towards its corners, as old lenses do, or tints the corners with another color.",
  "CREDIT": "Scrim",
  "CATEGORIES": ["Style", "Light", "Lens", "Corners"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to darken." },
    { "NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DOC": "Strength of the color at the corners. 0 changes nothing.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.7, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "start", "TYPE": "float", "LABEL": "Start", "DOC": "Where the vignette begins: 0 is the center of the image, 1 its corners.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.35, "UNIT": "ratio" },
    { "NAME": "softness", "TYPE": "float", "LABEL": "Softness", "DOC": "Distance from the start to full strength, on the same scale.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.65, "UNIT": "ratio" },
    { "NAME": "roundness", "TYPE": "float", "LABEL": "Roundness", "DOC": "0 is an ellipse with the aspect ratio of the image, 1 is a circle.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.0, "UNIT": "ratio" },
    { "NAME": "tint", "TYPE": "color", "LABEL": "Color", "DOC": "Color of the corners, with alpha.", "DEFAULT": [0.0, 0.0, 0.0, 1.0] }
  ]
}*/

// The smallest softness: a hard edge, and safe to divide by.
const float MIN_SOFTNESS = 0.0001;

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  vec2 fromCenter = 2.0 * isf_FragNormCoord - 1.0;
  vec2 shape = mix(vec2(1.0), RENDERSIZE / max(RENDERSIZE.x, RENDERSIZE.y), roundness);
  float distanceToCorner = length(fromCenter * shape) / length(shape);
  float t = clamp((distanceToCorner - start) / max(softness, MIN_SOFTNESS), 0.0, 1.0);
  float cover = amount * tint.a * t * t * (3.0 - 2.0 * t);
  gl_FragColor = vec4(mix(color.rgb, tint.rgb, cover), color.a);
}
