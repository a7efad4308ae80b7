// A whole number modulo PERIOD. The added half keeps a rounded quotient from falling just below the exact one.
float wrap(float whole) {
  return whole - PERIOD * floor((whole + 0.5) / PERIOD);
}
