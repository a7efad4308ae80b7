// Follows the edges from this pixel both ways, turned by a quarter if `crossed`. Gives the heights of two fields of strokes, each with a
// mean of 0 and a standard deviation of 1 (xy), and the difference of Gaussians along the edge (z): line integral convolution of noise.
vec3 stroke(vec2 usual, float pull, bool crossed, float widthPx, float lengthPx) {
  // A step of at most the width of a stroke leaves no gaps.
  float stepPx = min(widthPx, lengthPx / float(STROKE_REACH));
  vec2 first = alongEdge(isf_FragNormCoord, usual, pull);
  vec2 cells = RENDERSIZE / (widthPx * IMG_SIZE(grain));
  float sigma = 0.5 * float(STROKE_REACH);
  vec2 heights = IMG_NORM_PIXEL(grain, isf_FragNormCoord * cells).xy - 0.5;
  float line = IMG_NORM_PIXEL(edges, isf_FragNormCoord).x;
  float lines = 1.0;
  float total = 1.0;
  float squares = 1.0;
  for (int side = 0; side < 2; side++) {
    vec2 uv = isf_FragNormCoord;
    vec2 along = side == 0 ? first : -first;
    for (int i = 1; i <= STROKE_REACH; i++) {
      uv += stepPx * (crossed ? vec2(-along.y, along.x) : along) / RENDERSIZE;
      vec2 next = alongEdge(uv, usual, pull);
      along = dot(next, along) < 0.0 ? -next : next;
      float share = weight(i, sigma);
      heights += share * (IMG_NORM_PIXEL(grain, uv * cells).xy - 0.5);
      total += share;
      squares += share * share;
      float near = float(i) * stepPx / LINE_PX;
      float lineShare = exp(-0.5 * near * near);
      line += lineShare * IMG_NORM_PIXEL(edges, uv).x;
      lines += lineShare;
    }
  }
  // Bilinear noise has a variance of 1/27, and neighbors one cell apart a correlation of 1/4, on either side.
  float variance = min(squares * 1.5 * widthPx / (stepPx * total * total), 1.0) / 27.0;
  return vec3(heights / (total * sqrt(variance)), line / lines);
}
