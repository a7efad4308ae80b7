/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Keeps a layer for the next frame.",
  "CREDIT": "Scrim",
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_DEPTH": "none",
  "INPUTS": [
    { "NAME": "layer", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to output in the next frame." }
  ]
}*/

void main() {
  gl_FragColor = IMG_THIS_PIXEL(layer);
}
