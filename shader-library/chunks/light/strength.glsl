// The strength of a light compared with others: the luminance of its radiance (Rec. 709, linear-sRGB).
float lightStrength(const in Light light) {
  return dot(light.radiance, vec3(0.2126, 0.7152, 0.0722));
}
