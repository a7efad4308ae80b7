// The tensor of flat areas for `amount` of following: at 1 below the noise of cameras, at 0 above every edge.
float pullOf(float amount) {
  return 0.3 * exp2(16.0 * (1.0 - amount));
}
