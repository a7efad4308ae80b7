// A difference of Gaussians of the brightness across the edge (x), and the brightness under the wider one (y), with `sigma` as the
// standard deviation of the narrower one in pixels of the layer. Transparent areas count as white.
vec2 edgeResponse(vec2 along, float sigma) {
  vec2 stepUv = EDGE_STEP * sigma * vec2(-along.y, along.x) / RENDERSIZE;
  vec2 sum = vec2(0.0);
  vec2 total = vec2(0.0);
  for (int i = -EDGE_REACH; i <= EDGE_REACH; i++) {
    vec4 color = readLayer(isf_FragNormCoord + float(i) * stepUv);
    vec2 share = vec2(weight(i, 1.0 / EDGE_STEP), weight(i, WIDER / EDGE_STEP));
    sum += share * (dot(color.rgb, LUMA_709) + 1.0 - color.a);
    total += share;
  }
  vec2 mean = sum / total;
  return vec2(mean.x - mean.y, mean.y);
}
