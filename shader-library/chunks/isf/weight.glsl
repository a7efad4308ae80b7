// The weight of a pixel in a Gaussian blur, relative to the center. `sigma` is the standard deviation, in pixels.
float weight(int distancePx, float sigma) {
  float x = float(distancePx) / sigma;
  return exp(-0.5 * x * x);
}
