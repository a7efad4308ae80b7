// How much ink is at a stroke's height, so that the mean over all heights is `dark`. `soft` is the range of heights over which a stroke
// fades. Heights are normally distributed; a logistic curve makes all of them equally frequent.
float inkAt(float height, float dark, float soft) {
  return inkAtRank(1.0 / (1.0 + exp(-1.702 * height)), dark, soft);
}
