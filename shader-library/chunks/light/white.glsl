#include <light/strength>

// The luminance of a white matte surface that would face all lights and the brightest side of the environment, ignoring shadows.
float lightOnWhite() {
  float sum = luminance(IRRADIANCE(ENVIRONMENT().towards));
  for (int i = 0; i < LIGHT_COUNT; i++) sum += lightStrength(LIGHT(i));
  return sum / 3.14159265;
}
