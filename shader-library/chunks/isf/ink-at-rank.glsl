// How much ink is at a place of this rank, so that the mean over all ranks from 0 to 1 is `dark`: the highest ranks get ink first. `soft`
// is the range of ranks over which the ink fades.
float inkAtRank(float rank, float dark, float soft) {
  float least = min(dark, 1.0 - dark);
  // Near white and black the range is cut off, and the mean is a square.
  float from = least < 0.5 * soft ? 2.0 * sqrt(0.5 * least * soft) - 0.5 * soft : least;
  float above = dark < 0.5 ? 1.0 - from : from;
  return clamp((rank - above) / soft + 0.5, 0.0, 1.0);
}
