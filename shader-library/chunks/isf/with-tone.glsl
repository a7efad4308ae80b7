// A color with the same hue and another brightness. A channel that would exceed white goes to white with the others.
vec3 withTone(vec3 color, float from, float to) {
  vec3 scaled = from > 0.001 ? color * (to / from) : vec3(to);
  float most = max(scaled.r, max(scaled.g, scaled.b));
  if (most <= 1.0) return scaled;
  // Mixing with white keeps the brightness: `most` falls to 1 while the gray stays.
  return mix(scaled, vec3(to), (most - 1.0) / max(most - to, 0.001));
}
