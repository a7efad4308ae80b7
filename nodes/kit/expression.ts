/**
 * The words of expressions: what designers write into a param, or into an expression node, instead of a number. Numbers are the
 * only values; a comparison gives 1 or 0, and whatever is not 0 counts as true.
 *
 * The compiler turns an expression into postfix, words and numbers with spaces between, and the runtime plays that:
 * `1 + sin(time * tau)` becomes `1 time 6.283185307179586 * sin +`. Names stand for their values, everything else for an
 * operation on what the words before it have left. A list of three, `[time, 0, 1]`, leaves three numbers: `time 0 1`.
 */
export const EXPRESSION_CONSTANTS = { pi: Math.PI, tau: 2 * Math.PI } as const;

/** What every expression may read, besides the numbers of its node: seconds since the session began, and the count of frames. */
export const EXPRESSION_CLOCK = ['time', 'frame'] as const;

export type ClockWord = (typeof EXPRESSION_CLOCK)[number];

/** Functions, with what they take. As in GLSL, angles in radians; `log` is the natural one. */
export const EXPRESSION_FUNCTIONS = {
  sin: ['angle'],
  cos: ['angle'],
  tan: ['angle'],
  asin: ['x'],
  acos: ['x'],
  atan: ['x'],
  atan2: ['y', 'x'],
  sqrt: ['x'],
  pow: ['x', 'exponent'],
  exp: ['x'],
  log: ['x'],
  abs: ['x'],
  sign: ['x'],
  floor: ['x'],
  ceil: ['x'],
  round: ['x'],
  fract: ['x'],
  mod: ['x', 'divisor'],
  min: ['a', 'b'],
  max: ['a', 'b'],
  clamp: ['x', 'low', 'high'],
  mix: ['from', 'to', 'amount'],
  step: ['edge', 'x'],
  smoothstep: ['edge0', 'edge1', 'x'],
} as const satisfies Record<string, readonly string[]>;

/** Operations of two numbers, the signs as they are written. `%` is `mod`: it has the sign of the divisor. `^` is `pow`. */
export const EXPRESSION_OPERATORS = ['+', '-', '*', '/', '%', '^', '<', '<=', '>', '>=', '==', '!=', '&&', '||'] as const;

export type ExpressionOperator = (typeof EXPRESSION_OPERATORS)[number];

/** What the postfix is made of, besides numbers and the names of the node's own. */
export type ExpressionWord =
  | ClockWord
  | ExpressionOperator
  | Exclude<keyof typeof EXPRESSION_FUNCTIONS, 'mod' | 'pow'>
  | 'negate'
  | '!'
  /** The second or the third of three numbers, as the first says. */
  | '?:';
