export type Easing = 'linear' | 'step' | 'ease-in' | 'ease-out' | 'ease-in-out';

/** Horizontal places of the two inner control points; the vertical ones are 0 and 1. css-easing-1, section 2.2. */
const CURVES = { 'ease-in': [0.42, 1], 'ease-out': [0, 0.58], 'ease-in-out': [0.42, 0.58] } as const;

/** How far from one key to the next, for `x` from 0 to 1 of the time between them: from 0 to 1. `step` stays until the next key. */
export function ease(easing: Easing, x: number): number {
  if (x >= 1) return 1;
  if (easing === 'step' || x <= 0) return 0;
  if (easing === 'linear') return x;
  const [x1, x2] = CURVES[easing];
  const t = parameterAt(x, x1, x2);
  // A cubic Bézier curve from 0 over 0 and 1 to 1.
  return t * t * (3 - 2 * t);
}

/** Enough halvings for every bit of the answer, should Newton's steps ever lead out of the range. */
const MOST_STEPS = 60;
const CLOSE = 1e-9;

/** The parameter at which the curve has gone `x` to the right. It never goes back, so there is one. */
function parameterAt(x: number, x1: number, x2: number): number {
  let low = 0;
  let high = 1;
  let t = x;
  for (let i = 0; i < MOST_STEPS; i++) {
    const rest = 1 - t;
    const error = 3 * rest * rest * t * x1 + 3 * rest * t * t * x2 + t * t * t - x;
    if (Math.abs(error) < CLOSE) break;
    if (error > 0) high = t;
    else low = t;
    const slope = 3 * rest * rest * x1 + 6 * rest * t * (x2 - x1) + 3 * t * t * (1 - x2);
    const newton = t - error / slope;
    t = newton > low && newton < high ? newton : (low + high) / 2;
  }
  return t;
}
