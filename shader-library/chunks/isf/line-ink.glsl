// Ink of a line from 0 to 1 by the soft threshold of XDoG; dark sides of edges have a negative difference.
float lineInk(float difference, float strength) {
  float e = exp(-2.0 * max(-LINE_GAIN * strength * difference - LINE_LEAST, 0.0));
  return 1.0 - 2.0 * e / (1.0 + e);
}
