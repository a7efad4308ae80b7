/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Alpha over",
  "DESCRIPTION": "Puts one layer over another. Where the top layer is transparent, the bottom layer shows.",
  "CREDIT": "Scrim. Source-over: W3C Compositing and Blending Level 1, section 9.1.4",
  "CATEGORIES": ["Composite", "Merge", "Blend", "Layer"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_DEPTH": "over",
  "SCRIM_ENCODING": "either",
  "SCRIM_OPAQUE": ["bottom"],
  "INPUTS": [
    { "NAME": "top", "TYPE": "image", "LABEL": "Top", "DOC": "The layer in front." },
    { "NAME": "bottom", "TYPE": "image", "LABEL": "Bottom", "DOC": "The layer behind." },
    { "NAME": "opacity", "TYPE": "float", "LABEL": "Opacity", "DOC": "Opacity of the top layer: 0 hides it, 1 shows it fully.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 1.0, "IDENTITY": 0.0, "UNIT": "ratio" }
  ]
}*/

void main() {
  vec4 source = IMG_THIS_PIXEL(top);
  vec4 backdrop = IMG_THIS_PIXEL(bottom);
  // Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha.
#ifndef SCRIM
  source.rgb *= source.a;
  backdrop.rgb *= backdrop.a;
#endif
  source *= opacity;
  vec4 result = source + backdrop * (1.0 - source.a);
#ifndef SCRIM
  if (result.a > 0.0) result.rgb /= result.a;
#endif
  gl_FragColor = result;
}
