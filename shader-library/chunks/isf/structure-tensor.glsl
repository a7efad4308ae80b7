// The structure tensor of the layer from Sobel derivatives of its color, times SCALE: xx, yy and xy.
vec3 structureTensor() {
  vec2 px = 1.0 / RENDERSIZE;
  vec4 leftUp = readLayer(isf_FragNormCoord + px * vec2(-1.0, 1.0));
  vec4 rightUp = readLayer(isf_FragNormCoord + px);
  vec4 leftDown = readLayer(isf_FragNormCoord - px);
  vec4 rightDown = readLayer(isf_FragNormCoord + px * vec2(1.0, -1.0));
  vec4 right = readLayer(isf_FragNormCoord + vec2(px.x, 0.0));
  vec4 left = readLayer(isf_FragNormCoord - vec2(px.x, 0.0));
  vec4 up = readLayer(isf_FragNormCoord + vec2(0.0, px.y));
  vec4 down = readLayer(isf_FragNormCoord - vec2(0.0, px.y));
  vec4 x = (rightUp + 2.0 * right + rightDown - leftUp - 2.0 * left - leftDown) / 4.0;
  vec4 y = (leftUp + 2.0 * up + rightUp - leftDown - 2.0 * down - rightDown) / 4.0;
  return SCALE * vec3(dot(x, x), dot(y, y), dot(x, y));
}
