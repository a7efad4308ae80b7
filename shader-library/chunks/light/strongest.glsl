#include <light/strength>

// The strongest light at a surface, ignoring shadows; the environment counts as one light.
Light strongestLight(const in Surface s) {
  Light best = ENVIRONMENT();
  float strength = lightStrength(best);
  for (int i = 0; i < LIGHT_COUNT; i++) {
    Light light = LIGHT(i);
    if (lightStrength(light) <= strength) continue;
    strength = lightStrength(light);
    best = light;
  }
  return best;
}
