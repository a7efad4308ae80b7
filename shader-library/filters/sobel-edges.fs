/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Draws the edges of an image as lines: the magnitude of the brightness gradient from 3 × 3 Sobel kernels.",
  "CREDIT": "Scrim. Kernels: I. Sobel and G. Feldman, 1968. Luma: Rec. ITU-R BT.709",
  "CATEGORIES": ["Edges", "Outline", "Style", "Lines"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to find edges in. Transparent areas count as black." },
    { "NAME": "strength", "TYPE": "float", "LABEL": "Strength", "DOC": "Factor on the gradient: with 1, a straight edge between black and white has full strength.", "MIN": 0.0, "MAX": 8.0, "DEFAULT": 1.0, "UNIT": "ratio" },
    { "NAME": "lineColor", "TYPE": "color", "LABEL": "Lines", "DOC": "Color of the edges.", "DEFAULT": [1.0, 1.0, 1.0, 1.0] },
    { "NAME": "paperColor", "TYPE": "color", "LABEL": "Paper", "DOC": "Color between the edges.", "DEFAULT": [0.0, 0.0, 0.0, 1.0] },
    { "NAME": "overPicture", "TYPE": "bool", "LABEL": "Over the image", "DOC": "Draw the edges over the image instead of over the paper.", "DEFAULT": false }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

// The sum of the weights of one side of a Sobel kernel: 1 + 2 + 1.
const float FULL_EDGE = 4.0;

// The layer at `uv`, premultiplied. Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha.
vec4 readLayer(vec2 uv) {
  vec4 color = IMG_NORM_PIXEL(inputImage, uv);
#ifndef SCRIM
  color.rgb *= color.a;
#endif
  return color;
}

// Premultiplied from straight alpha.
vec4 premultiplied(vec4 color) {
  return vec4(color.rgb * color.a, color.a);
}

// Luma and alpha.
vec2 tap(float x, float y) {
  vec4 color = readLayer(isf_FragNormCoord + vec2(x, y) / RENDERSIZE);
  return vec2(dot(color.rgb, LUMA_709), color.a);
}

void main() {
  vec2 topLeft = tap(-1.0, 1.0);
  vec2 top = tap(0.0, 1.0);
  vec2 topRight = tap(1.0, 1.0);
  vec2 left = tap(-1.0, 0.0);
  vec4 center = readLayer(isf_FragNormCoord);
  vec2 right = tap(1.0, 0.0);
  vec2 bottomLeft = tap(-1.0, -1.0);
  vec2 bottom = tap(0.0, -1.0);
  vec2 bottomRight = tap(1.0, -1.0);

  float gradientX = topRight.x + 2.0 * right.x + bottomRight.x - topLeft.x - 2.0 * left.x - bottomLeft.x;
  float gradientY = topLeft.x + 2.0 * top.x + topRight.x - bottomLeft.x - 2.0 * bottom.x - bottomRight.x;
  float edge = clamp(strength * length(vec2(gradientX, gradientY)) / FULL_EDGE, 0.0, 1.0);

  // Paper and lines extend one pixel beyond the edge of the layer, where half of the outline is.
  float reach = max(center.a, max(max(max(topLeft.y, topRight.y), max(bottomLeft.y, bottomRight.y)), max(max(top.y, bottom.y), max(left.y, right.y))));
  vec4 line = premultiplied(lineColor) * reach;
  vec4 paper = overPicture ? center : premultiplied(paperColor) * reach;
  vec4 result = mix(paper, line, edge);
#ifndef SCRIM
  if (result.a > 0.0) result.rgb /= result.a;
#endif
  gl_FragColor = result;
}
