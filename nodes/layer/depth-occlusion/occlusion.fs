/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Depth occlusion",
  "DESCRIPTION": "Hides what of a layer lies behind the real room.",
  "CREDIT": "Scrim",
  "CATEGORIES": ["Composite", "Depth"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_DEPTH": "same",
  "INPUTS": [
    { "NAME": "layer", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to hide parts of." },
    { "NAME": "depth", "TYPE": "depth", "LABEL": "Room depth", "DOC": "How far away the real room is." },
    { "NAME": "biasM", "TYPE": "float", "MIN": 0.0, "MAX": 0.5, "DEFAULT": 0.0, "UNIT": "m" },
    { "NAME": "softnessM", "TYPE": "float", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.0, "UNIT": "m" }
  ]
}*/

// How much shows of something at layerM metres, before or behind a room that is roomM metres away; both along the view's
// axis, 0 where unknown. What is unknown hides nothing. Materials that discard early use the same formula: scenes/materials.
float visibility(float layerM, float roomM) {
  if (layerM <= 0.0 || roomM <= 0.0) return 1.0;
  float behindM = layerM - roomM - biasM;
  if (softnessM <= 0.0) return behindM > 0.0 ? 0.0 : 1.0;
  return 1.0 - clamp(behindM / softnessM, 0.0, 1.0);
}

void main() {
  vec2 here = isf_FragNormCoord;
  gl_FragColor = IMG_THIS_PIXEL(layer) * visibility(LAYER_DEPTH(layer, here), ROOM_DEPTH(depth, here));
}
