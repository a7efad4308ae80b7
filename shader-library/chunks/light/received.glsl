#include <light/diffuse>
#include <light/luminance>

// The tone that the light asks for: the luminance of a white matte surface here, from 0 (no light) to 1 (white).
float lightReceived(const in Surface s) {
  return clamp(luminance(diffuseLight(s.normal)), 0.0, 1.0);
}
