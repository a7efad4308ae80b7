/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Repeats an image in columns and rows; each copy is the whole image, scaled down.",
  "CREDIT": "Scrim. Effect named in the mixed-reality rendering framework with osgART, figure 10",
  "CATEGORIES": ["Distort", "Repeat", "Kaleidoscope", "Mirror", "Grid"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to repeat." },
    { "NAME": "columns", "TYPE": "float", "LABEL": "Columns", "DOC": "Number of copies side by side.", "MIN": 1.0, "MAX": 16.0, "DEFAULT": 3.0, "IDENTITY": 1.0, "STEP": 1.0 },
    { "NAME": "rows", "TYPE": "float", "LABEL": "Rows", "DOC": "Number of copies above each other.", "MIN": 1.0, "MAX": 16.0, "DEFAULT": 3.0, "IDENTITY": 1.0, "STEP": 1.0 },
    { "NAME": "mirror", "TYPE": "bool", "LABEL": "Mirror", "DOC": "Mirror every second copy, so that their edges meet.", "DEFAULT": false }
  ]
}*/

// A pixel of a copy covers as many pixels of the image as there are copies; up to 8 in each direction are averaged:
// 64 samples at most.
const int MAX_SAMPLES = 8;

// The layer at `uv`, premultiplied. Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha.
vec4 readLayer(vec2 uv) {
  vec4 color = IMG_NORM_PIXEL(inputImage, uv);
#ifndef SCRIM
  color.rgb *= color.a;
#endif
  return color;
}

void main() {
  vec2 count = max(floor(vec2(columns, rows) + 0.5), 1.0);
  vec2 samples = min(count, float(MAX_SAMPLES));
  vec2 tile = floor(isf_FragNormCoord * count);
  bvec2 turned = bvec2(mirror && mod(tile.x, 2.0) > 0.5, mirror && mod(tile.y, 2.0) > 0.5);
  vec2 edge = 0.5 / RENDERSIZE;
  vec4 sum = vec4(0.0);
  for (int j = 0; j < MAX_SAMPLES; j++) {
    if (float(j) >= samples.y) break;
    for (int i = 0; i < MAX_SAMPLES; i++) {
      if (float(i) >= samples.x) break;
      vec2 inPixel = (vec2(float(i), float(j)) + 0.5) / samples - 0.5;
      vec2 uv = (isf_FragNormCoord + inPixel / RENDERSIZE) * count - tile;
      if (turned.x) uv.x = 1.0 - uv.x;
      if (turned.y) uv.y = 1.0 - uv.y;
      sum += readLayer(clamp(uv, edge, 1.0 - edge));
    }
  }
  vec4 result = sum / (samples.x * samples.y);
#ifndef SCRIM
  if (result.a > 0.0) result.rgb /= result.a;
#endif
  gl_FragColor = result;
}
