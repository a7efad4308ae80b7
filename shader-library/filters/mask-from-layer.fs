/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Makes a mask from the brightness, the alpha or one channel of a layer: white where the value is high, black where it is low. Blur the mask to feather its edge.",
  "CREDIT": "Scrim. Luma: Rec. ITU-R BT.709",
  "CATEGORIES": ["Mask", "Matte", "Luma key", "Alpha", "Channel", "Levels", "Invert"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to make a mask from, such as an image, a shadow or an effect." },
    { "NAME": "source", "TYPE": "long", "LABEL": "By", "DOC": "Which value of the layer to use. Brightness and colors are multiplied by alpha, so transparent areas are black.", "VALUES": [0, 1, 2, 3, 4], "LABELS": ["Brightness", "Alpha", "Red", "Green", "Blue"], "DEFAULT": 0 },
    { "NAME": "low", "TYPE": "float", "LABEL": "Black from", "DOC": "Values up to this are black in the mask.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.0, "UNIT": "ratio" },
    { "NAME": "high", "TYPE": "float", "LABEL": "White from", "DOC": "Values from this on are white in the mask. If it is not above “Black from”, the mask has a hard edge at this value.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 1.0, "UNIT": "ratio" },
    { "NAME": "invert", "TYPE": "bool", "LABEL": "Invert", "DOC": "Swap black and white.", "DEFAULT": false }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

// Below this, a quarter of an 8-bit step, the edge is hard, and values on it are white.
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
