/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Depth occlusion",
  "DESCRIPTION": "Hides the parts of a layer that are behind real surfaces.",
  "CREDIT": "Scrim",
  "CATEGORIES": ["Composite", "Depth"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_DEPTH": "same",
  "SCRIM_ENCODING": "either",
  "INPUTS": [
    { "NAME": "layer", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to occlude." },
    { "NAME": "depth", "TYPE": "depth", "LABEL": "Room depth", "DOC": "Distance to real surfaces." },
    { "NAME": "biasM", "TYPE": "float", "MIN": 0.0, "MAX": 0.5, "DEFAULT": 0.0, "UNIT": "m" },
    { "NAME": "softnessM", "TYPE": "float", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.0, "UNIT": "m" },
    { "NAME": "borderPx", "TYPE": "float", "MIN": 0.0, "MAX": 32.0, "DEFAULT": 0.0, "UNIT": "px" }
  ]
}*/

// The visible fraction of a layer at layerM meters with real surfaces at roomM meters, both along the view
// axis, 0 where unknown. Unknown depth hides nothing. Materials that discard early use the same formula: scenes/materials.
float visibility(float layerM, float roomM) {
  if (layerM <= 0.0 || roomM <= 0.0) return 1.0;
  float behindM = layerM - roomM - biasM;
  if (softnessM <= 0.0) return behindM > 0.0 ? 0.0 : 1.0;
  return 1.0 - clamp(behindM / softnessM, 0.0, 1.0);
}

const int PLACES = 16;
// The golden angle, radians: a spiral with it distributes samples evenly over a disk (Vogel 1979).
const float GOLDEN_ANGLE = 2.399963;

// The visible fraction with a soft edge: the mean over samples in a disk.
float shownAt(vec2 here) {
  float layerM = LAYER_DEPTH(layer, here);
  if (borderPx <= 0.0) return visibility(layerM, ROOM_DEPTH(depth, here));
  float seen = 0.0;
  for (int i = 0; i < PLACES; i++) {
    float angle = GOLDEN_ANGLE * float(i);
    float away = 0.5 * borderPx * sqrt((float(i) + 0.5) / float(PLACES));
    seen += visibility(layerM, ROOM_DEPTH(depth, here + away * vec2(cos(angle), sin(angle)) / RENDERSIZE));
  }
  return seen / float(PLACES);
}

void main() {
  // The exact center of the pixel, so that materials that discard early get the same result.
  vec2 here = (floor(isf_FragNormCoord * RENDERSIZE) + 0.5) / RENDERSIZE;
  gl_FragColor = IMG_THIS_PIXEL(layer) * shownAt(here);
}
