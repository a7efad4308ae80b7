// A permutation of the integers below PERIOD, for noise (McEwan et al., “Efficient computational noise in GLSL”).
float permute(float x) {
  return wrap((34.0 * x + 1.0) * x);
}
