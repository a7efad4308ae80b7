// The unit vector along the edges at `uv`: the minor eigenvector of the smoothed tensor, which receives `pull` times the tensor of strokes
// in the direction `usual`. Flat areas therefore have that direction, and directions change without a seam.
vec2 alongEdge(vec2 uv, vec2 usual, float pull) {
  vec3 t = IMG_NORM_PIXEL(smoothed, uv).xyz + pull * vec3(usual.y * usual.y, usual.x * usual.x, -usual.x * usual.y);
  float apart = 0.5 * (t.x - t.y);
  float spread = sqrt(apart * apart + t.z * t.z);
  vec2 along = apart > 0.0 ? vec2(-t.z, apart + spread) : vec2(spread - apart, -t.z);
  return along / max(length(along), 0.000001);
}
