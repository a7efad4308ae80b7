/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Reduces red, green and blue to a few levels: flat areas with hard edges, as in a screen print.",
  "CREDIT": "Scrim. Levels: discrete transfer function of W3C Filter Effects Module Level 1",
  "CATEGORIES": ["Color", "Style", "Comic", "Levels"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to posterize." },
    { "NAME": "levels", "TYPE": "float", "LABEL": "Levels", "DOC": "Number of levels per channel, including 0 and full intensity.", "MIN": 2.0, "MAX": 32.0, "DEFAULT": 4.0, "STEP": 1.0 },
    { "NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DOC": "0 leaves the image unchanged, 1 shows only the levels.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 1.0, "IDENTITY": 0.0, "UNIT": "ratio" }
  ]
}*/

// Values on a border belong to the upper level, independent of rounding.
const float ROUNDING = 0.0001;

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  float count = max(floor(levels + 0.5), 2.0);
  vec3 level = min(floor(color.rgb * count + ROUNDING), count - 1.0) / (count - 1.0);
  gl_FragColor = vec4(mix(color.rgb, level, amount), color.a);
}
