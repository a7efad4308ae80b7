#include <light/strength>

// The fraction of all light that the surface receives, from 0 to 1. Without lights, the light comes from the camera.
float lightReceived(const in Surface s) {
  if (LIGHT_COUNT == 0) return max(dot(s.normal, s.towardsEye), 0.0);
  float sum = 0.0;
  float most = 0.0;
  for (int i = 0; i < LIGHT_COUNT; i++) {
    Light light = LIGHT(i);
    float strength = lightStrength(light);
    sum += strength * max(dot(s.normal, light.towards), 0.0) * light.lit;
    most += strength;
  }
  return most > 0.0 ? sum / most : 0.0;
}
