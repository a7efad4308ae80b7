/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Shows an image as large square blocks. Each block has the mean color of its pixels, so moving images do not flicker.",
  "CREDIT": "Scrim",
  "CATEGORIES": ["Style", "Mosaic", "Blocks", "Censor"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to pixelate." },
    { "NAME": "size", "TYPE": "float", "LABEL": "Block size", "DOC": "Size of a block, in whole pixels of the layer. 1 changes nothing.", "MIN": 1.0, "MAX": 128.0, "DEFAULT": 12.0, "IDENTITY": 1.0, "STEP": 1.0, "UNIT": "px" }
  ],
  "PASSES": [
    { "TARGET": "columns", "WIDTH": "ceil($WIDTH / max(round($size), 1))", "DESCRIPTION": "Computes the means of the rows of each block." },
    { "TARGET": "blocks", "WIDTH": "ceil($WIDTH / max(round($size), 1))", "HEIGHT": "ceil($HEIGHT / max(round($size), 1))", "DESCRIPTION": "Computes the mean of each block." },
    { "DESCRIPTION": "Draws the blocks." }
  ]
}*/

const int MAX_SIZE = 128;

// The layer at `uv`, premultiplied. Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha.
vec4 readLayer(vec2 uv) {
  vec4 color = IMG_NORM_PIXEL(inputImage, uv);
#ifndef SCRIM
  color.rgb *= color.a;
#endif
  return color;
}

// The mean of `count` pixels from `first` on, in an image that is `whole` pixels long; the last block may be smaller.
vec4 meanAlong(bool alongX, float first, float count, float whole) {
  vec4 sum = vec4(0.0);
  float found = 0.0;
  for (int i = 0; i < MAX_SIZE; i++) {
    float px = first + float(i);
    if (float(i) >= count || px >= whole) break;
    float at = (px + 0.5) / whole;
    sum += alongX ? readLayer(vec2(at, isf_FragNormCoord.y)) : IMG_NORM_PIXEL(columns, vec2(isf_FragNormCoord.x, at));
    found += 1.0;
  }
  return sum / found;
}

void main() {
  float side = max(floor(size + 0.5), 1.0);
  if (PASSINDEX == 0) {
    gl_FragColor = meanAlong(true, floor(gl_FragCoord.x) * side, side, IMG_SIZE(inputImage).x);
  } else if (PASSINDEX == 1) {
    gl_FragColor = meanAlong(false, floor(gl_FragCoord.y) * side, side, IMG_SIZE(columns).y);
  } else {
    vec2 block = floor(isf_FragNormCoord * RENDERSIZE / side);
    vec4 result = IMG_NORM_PIXEL(blocks, (block + 0.5) / ceil(RENDERSIZE / side));
#ifndef SCRIM
    if (result.a > 0.0) result.rgb /= result.a;
#endif
    gl_FragColor = result;
  }
}
