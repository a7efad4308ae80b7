// Cone responses (LMS) to white light of luminance 1 with this color temperature, in kelvin.
vec3 conesOfWhite(float kelvin) {
  vec2 xy = planckianLocus(kelvin);
  return CONES_FROM_XYZ * vec3(xy.x / xy.y, 1.0, (1.0 - xy.x - xy.y) / xy.y);
}
