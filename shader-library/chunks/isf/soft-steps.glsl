// A tone moved to the nearest multiple of one step. Between two of them it changes over `soft`, a share of the step, so that the noise of
// a camera moves no border by much. `tone` is in steps.
float softSteps(float tone, float soft) {
  float whole = floor(tone);
  return whole + smoothstep(0.5 - 0.5 * soft, 0.5 + 0.5 * soft, tone - whole);
}
