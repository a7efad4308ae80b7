// Straight color of the ink that gives `color` on this paper, and the share of the paper that it covers (alpha).
vec4 pigment(vec3 color, vec3 paper) {
  vec3 missing = 1.0 - color / max(paper, 0.05);
  float dark = clamp(max(missing.r, max(missing.g, missing.b)), 0.0, 1.0);
  return vec4(clamp(paper * (1.0 - missing / max(dark, 0.05)), 0.0, 1.0), dark);
}
