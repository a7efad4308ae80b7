/** The named interpolations of a keyframe, as project files store them: the curves of CSS; `step` holds until the next keyframe. */
export const NAMED_EASINGS = ['linear', 'step', 'ease-in', 'ease-out', 'ease-in-out'] as const;

/**
 * The control points of a cubic Bézier easing from (0, 0) to (1, 1), `[x1, y1, x2, y2]` as in CSS `cubic-bezier()` (css-easing-1,
 * section 2.2). x is time, in [0, 1]; y is progress, in [-OVERSHOOT, 1 + OVERSHOOT].
 */
export type Handles = readonly [x1: number, y1: number, x2: number, y2: number];

/** The interpolation from a keyframe to the next. */
export type Easing = (typeof NAMED_EASINGS)[number] | Handles;

/** How far the y of a control point may be outside [0, 1]. The “back” easings of other programs need 0.56. */
export const OVERSHOOT = 0.6;

const HANDLES: Readonly<Record<Exclude<(typeof NAMED_EASINGS)[number], 'step'>, Handles>> = {
  linear: [1 / 3, 1 / 3, 2 / 3, 2 / 3],
  'ease-in': [0.42, 0, 1, 1],
  'ease-out': [0, 0, 0.58, 1],
  'ease-in-out': [0.42, 0, 0.58, 1],
};

/**
 * The control points of an easing.
 *
 * @returns Null for `step`, which is not a Bézier curve.
 *
 * @example
 * handlesOf('ease-in'); // [0.42, 0, 1, 1]
 */
export function handlesOf(easing: Easing): Handles | null {
  if (typeof easing !== 'string') return easing;
  return easing === 'step' ? null : HANDLES[easing];
}

/**
 * Whether a value is an easing.
 *
 * @param value Any value, such as one from a project file.
 *
 * @example
 * isEasing([0.3, 1.5, 0.7, 1]); // true: y may overshoot
 * isEasing([1.2, 0, 1, 1]); // false: x is outside [0, 1]
 */
export function isEasing(value: unknown): value is Easing {
  if (!Array.isArray(value)) return NAMED_EASINGS.some((name) => name === value);
  const isIn = (number: unknown, beyond: number) => typeof number === 'number' && number >= -beyond && number <= 1 + beyond;
  return value.length === 4 && value.every((number, i) => isIn(number, i % 2 === 0 ? 0 : OVERSHOOT));
}

/**
 * Whether an easing may leave the range between the values of its two keyframes.
 *
 * @example
 * overshoots([0.3, 1.5, 0.7, 1]); // true
 */
export function overshoots(easing: Easing): boolean {
  return typeof easing !== 'string' && [easing[1], easing[3]].some((y) => y < 0 || y > 1);
}

/**
 * The interpolation factor between two keyframes.
 *
 * @param x Elapsed part of the time between them, in [0, 1].
 * @returns 0 at `x` 0 and 1 at `x` 1; Bézier curves may leave [0, 1] in between, by at most `OVERSHOOT`.
 *
 * @example
 * ease('linear', 0.5); // 0.5
 */
export function ease(easing: Easing, x: number): number {
  if (x >= 1) return 1;
  if (easing === 'step' || x <= 0) return 0;
  if (easing === 'linear') return x;
  const handles = typeof easing === 'string' ? HANDLES[easing] : easing;
  const t = parameterAt(x, handles[0], handles[2]);
  return bezier(t, handles[1], handles[3]);
}

/** One coordinate of a cubic Bézier curve from 0 to 1 with two control points. */
function bezier(t: number, first: number, second: number): number {
  const rest = 1 - t;
  return 3 * rest * rest * t * first + 3 * rest * t * t * second + t * t * t;
}

/** The most iterations: as many bisections as reach full precision if Newton's method leaves the range. */
const MOST_STEPS = 60;
const CLOSE = 1e-9;

/** The curve parameter at which the curve has the given x. x is monotone, so there is exactly one. */
function parameterAt(x: number, x1: number, x2: number): number {
  let low = 0;
  let high = 1;
  let t = x;
  for (let i = 0; i < MOST_STEPS; i++) {
    const rest = 1 - t;
    const error = bezier(t, x1, x2) - x;
    if (Math.abs(error) < CLOSE) break;
    if (error > 0) high = t;
    else low = t;
    const slope = 3 * rest * rest * x1 + 6 * rest * t * (x2 - x1) + 3 * t * t * (1 - x2);
    const newton = t - error / slope;
    t = newton > low && newton < high ? newton : (low + high) / 2;
  }
  return t;
}
