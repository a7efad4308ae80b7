// How much ink is at a stroke's height, so that the mean over all heights is `dark`. `soft` is the range of heights over which a stroke
// fades. Heights are normally distributed; a logistic curve makes all of them equally frequent.
float inkAt(float height, float dark, float soft) {
  float rank = 1.0 / (1.0 + exp(-1.702 * height));
  float least = min(dark, 1.0 - dark);
  // Near white and black the range is cut off, and the mean is a square.
  float from = least < 0.5 * soft ? 2.0 * sqrt(0.5 * least * soft) - 0.5 * soft : least;
  float above = dark < 0.5 ? 1.0 - from : from;
  return clamp((rank - above) / soft + 0.5, 0.0, 1.0);
}
