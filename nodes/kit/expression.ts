/**
 * The constants that expressions can use. Users type an expression into a param or an Expression node instead of a number. All values are
 * numbers: a comparison results in 1 or 0, and every number except 0 is true.
 *
 * The compiler translates an expression to postfix notation, words and numbers separated by spaces, which the runtime evaluates:
 * `1 + sin(time * tau)` becomes `1 time 6.283185307179586 * sin +`. A list, `[time, 0, 1]`, results in several numbers: `time 0 1`.
 */
export const EXPRESSION_CONSTANTS = { pi: Math.PI, tau: 2 * Math.PI } as const;

/** Names that every expression can read: `time`, seconds since the session began, and `frame`, the number of frames. */
export const EXPRESSION_CLOCK = ['time', 'frame'] as const;

/** A name that reads the clock. */
export type ClockWord = (typeof EXPRESSION_CLOCK)[number];

/** The functions with the names of their arguments, as in GLSL: angles are in radians, `log` is the natural logarithm. */
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

/** The binary operators. `%` is `mod`, whose result has the sign of the divisor; `^` is `pow`. */
export const EXPRESSION_OPERATORS = ['+', '-', '*', '/', '%', '^', '<', '<=', '>', '>=', '==', '!=', '&&', '||'] as const;

/** A binary operator. */
export type ExpressionOperator = (typeof EXPRESSION_OPERATORS)[number];

/** A word of the postfix notation that is neither a number nor a name of the node's own. */
export type ExpressionWord =
  | ClockWord
  | ExpressionOperator
  | Exclude<keyof typeof EXPRESSION_FUNCTIONS, 'mod' | 'pow'>
  | 'negate'
  | '!'
  /** The conditional: the second of three numbers if the first is not 0, otherwise the third. */
  | '?:';

/**
 * How a node computes its outputs from its params, by port. A formula is an expression over the number and toggle params and the components
 * of vectors and colors (`position.x`, `tint.r`), or a list of expressions for a vector. The name of a param alone is its value, of any
 * type; for a param that is itself an expression, the value of that. With `by`, the structure choice of this name selects the formula. A
 * number that is not finite becomes 0. Conversions of colors are functions of `color-math.ts`, called with the values of params.
 */
export type ComputedOutputs = Readonly<
  Record<
    string,
    | string
    | { readonly by: string; readonly of: Readonly<Record<string, string>> }
    | { readonly call: ColorFunction; readonly params: readonly string[] }
  >
>;

/** A function of `color-math.ts` that the compiler can call. */
export type ColorFunction = 'writeHsvColor' | 'writeAdjustedColor' | 'writeMixedColor';
