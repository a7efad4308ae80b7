#include <light/strength>

// The strongest light at a surface, ignoring shadows. Without lights, the light comes from the camera.
Light strongestLight(const in Surface s) {
  Light best = Light(s.towardsEye, vec3(1.0), 1.0);
  float strength = 0.0;
  for (int i = 0; i < LIGHT_COUNT; i++) {
    Light light = LIGHT(i);
    if (i > 0 && lightStrength(light) <= strength) continue;
    strength = lightStrength(light);
    best = light;
  }
  return best;
}
