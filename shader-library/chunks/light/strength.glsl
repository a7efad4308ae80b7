#include <light/luminance>

// The strength of a light compared with others: the luminance of its radiance.
float lightStrength(const in Light light) {
  return luminance(light.radiance);
}
