// A mean of the pixels along the edges, or straight across them, in which a pixel counts less with its distance (standard deviation
// `sigmaPx`) and with the difference of its color (`range`, summed over red, green, blue and alpha).
vec4 bilateralLine(bool across, float sigmaPx, float range) {
  vec4 middle = readStage(isf_FragNormCoord);
  vec2 first = alongEdge(isf_FragNormCoord, vec2(1.0, 0.0), pullOf(1.0));
  if (across) first = vec2(-first.y, first.x);
  float stepPx = 2.0 * sigmaPx / float(LINE_REACH);
  vec4 sum = middle;
  float total = 1.0;
  for (int side = 0; side < 2; side++) {
    vec2 uv = isf_FragNormCoord;
    vec2 along = side == 0 ? first : -first;
    for (int i = 1; i <= LINE_REACH; i++) {
      uv += stepPx * along / RENDERSIZE;
      if (!across) {
        vec2 next = alongEdge(uv, vec2(1.0, 0.0), pullOf(1.0));
        along = dot(next, along) < 0.0 ? -next : next;
      }
      vec4 color = readStage(uv);
      float difference = dot(abs(color - middle), vec4(1.0)) / range;
      float share = weight(i, 0.5 * float(LINE_REACH)) * exp(-0.5 * difference * difference);
      sum += share * color;
      total += share;
    }
  }
  return sum / total;
}
