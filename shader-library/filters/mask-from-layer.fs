/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Makes a mask of any layer: white where it is bright, opaque or strong in one channel, black elsewhere. Blur it to feather its edge.",
  "CREDIT": "Scrim. Luma: Rec. ITU-R BT.709",
  "CATEGORIES": ["Mask", "Matte", "Luma key", "Alpha", "Channel", "Levels", "Invert"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to make a mask of: a picture, a shadow, another effect." },
    { "NAME": "source", "TYPE": "long", "LABEL": "By", "DOC": "What of the layer counts. Brightness and the colors count times alpha, so that transparent is black.", "VALUES": [0, 1, 2, 3, 4], "LABELS": ["Brightness", "Alpha", "Red", "Green", "Blue"], "DEFAULT": 0 },
    { "NAME": "low", "TYPE": "float", "LABEL": "Black from", "DOC": "Up to here the mask is black.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.0, "UNIT": "ratio" },
    { "NAME": "high", "TYPE": "float", "LABEL": "White from", "DOC": "From here on the mask is white. At or below the other number the mask has a hard edge there.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 1.0, "UNIT": "ratio" },
    { "NAME": "invert", "TYPE": "bool", "LABEL": "Invert", "DOC": "Swaps black and white.", "DEFAULT": false }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

// Below this, a quarter of a step of 8 bits, the edge is hard, and what lies on it is white.
const float LEAST = 0.001;

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  float value = color.a;
  if (source == 0) value *= dot(color.rgb, LUMA_709);
  else if (source == 2) value *= color.r;
  else if (source == 3) value *= color.g;
  else if (source == 4) value *= color.b;
  float shown = high - low < LEAST ? step(low - LEAST, value) : clamp((value - low) / (high - low), 0.0, 1.0);
  gl_FragColor = vec4(vec3(invert ? 1.0 - shown : shown), 1.0);
}
