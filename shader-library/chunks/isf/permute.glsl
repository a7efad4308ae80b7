// A permutation of the whole numbers below PERIOD, the base of the noise (McEwan et al., “Efficient computational noise in GLSL”).
float permute(float x) {
  return wrap((34.0 * x + 1.0) * x);
}
