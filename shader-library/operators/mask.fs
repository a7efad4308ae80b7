/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Shows a layer only where a mask is bright or opaque; the rest becomes transparent.",
  "CREDIT": "Scrim. Mask values: W3C CSS Masking Module Level 1, section 6.10",
  "CATEGORIES": ["Composite", "Matte", "Cut out", "Stencil"],
  "SCRIM_ALPHA": "premultiplied",
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to mask." },
    { "NAME": "mask", "TYPE": "image", "LABEL": "Mask", "DOC": "The mask: where the layer is visible, and how much." },
    { "NAME": "source", "TYPE": "long", "LABEL": "Mask by", "DOC": "Brightness: white shows and black hides the layer (Rec. 709 luma times alpha). Alpha: opaque shows and transparent hides it.", "VALUES": [0, 1], "LABELS": ["Brightness", "Alpha"], "DEFAULT": 0 },
    { "NAME": "invert", "TYPE": "bool", "LABEL": "Invert", "DOC": "Swap the visible and the hidden parts.", "DEFAULT": false },
    { "NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DOC": "Strength of the mask: 0 shows the whole layer.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 1.0, "IDENTITY": 0.0, "UNIT": "ratio" }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

void main() {
  vec4 layer = IMG_THIS_PIXEL(inputImage);
  vec4 stencil = IMG_THIS_PIXEL(mask);
  // Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha.
#ifndef SCRIM
  stencil.rgb *= stencil.a;
#endif
  float shown = source == 1 ? stencil.a : dot(stencil.rgb, LUMA_709);
  if (invert) shown = 1.0 - shown;
  shown = mix(1.0, shown, amount);
#ifdef SCRIM
  gl_FragColor = layer * shown;
#else
  gl_FragColor = vec4(layer.rgb, layer.a * shown);
#endif
}
