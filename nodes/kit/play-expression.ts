import { ARITHMETIC, type ArithmeticOperation, calculate } from './arithmetic.ts';
import { type ClockWord, EXPRESSION_CLOCK, EXPRESSION_FUNCTIONS, type ExpressionWord } from './expression.ts';

/** The clock that an expression reads: the values of `time` and `frame`. `NodeContext.clock` is such an object. */
export interface ExpressionClock {
  readonly timeS: number;
  readonly frame: number;
}

/** An expression, ready to be evaluated every frame. The editor also evaluates typed expressions that result in a number. */
export interface PlayedExpression {
  /** The results of the last `update`; always the same array. */
  readonly results: Readonly<Float64Array>;
  /** Evaluates the expression; allocates nothing. */
  update(clock: ExpressionClock): void;
}

type Operation = Exclude<ExpressionWord, ClockWord> | ArithmeticOperation;

/** The number of operands of each operation; each has one result. */
const OPERANDS: Readonly<Record<string, number>> = {
  ...Object.fromEntries(Object.entries(EXPRESSION_FUNCTIONS).map(([name, operands]) => [name, operands.length])),
  ...ARITHMETIC,
};

const MOST_OPERANDS = 3;

/**
 * Prepares an expression in postfix notation (`expression.ts`).
 *
 * The stack is an array, not return values: JavaScript engines allocate a heap object for a fraction that a function returns.
 *
 * @param postfix The expression as the compiler prints it.
 * @param numbers Live values of names, such as the params of the node; read at every update.
 * @throws If the text is not valid postfix notation.
 *
 * @example
 * const expression = playExpression('time 2 *');
 * expression.update(ctx.clock);
 * expression.results[0]; // twice the time in seconds
 */
export function playExpression(postfix: string, numbers: Readonly<Record<string, { readonly value: number }>> = {}): PlayedExpression {
  const words = postfix.split(' ');
  /** The value of each word that is a literal or reads the clock; the latter change every frame. */
  const known = Float64Array.from(words, Number);
  const views = words.map((word) => (Object.hasOwn(numbers, word) ? numbers[word] : undefined));
  const places = (name: string) => words.flatMap((word, i) => (word === name ? [i] : []));
  const times = places('time');
  const frames = places('frame');
  const isKnown = words.map((word, i) => !Number.isNaN(known[i]) || EXPRESSION_CLOCK.some((name) => name === word));
  const takes = words.map((word, i) => {
    if (views[i] || isKnown[i]) return 0;
    if (!Object.hasOwn(OPERANDS, word)) throw new Error(`"${word}" is not a word of an expression: ${postfix}`);
    return OPERANDS[word] ?? 0;
  });
  let depth = 0;
  let deepest = 0;
  for (const count of takes) {
    if (count > depth) throw new Error(`An operation has too few operands: ${postfix}`);
    depth += 1 - count;
    deepest = Math.max(deepest, depth);
  }
  // Additional elements, because `operate` reads operands beyond the top of the stack.
  const stack = new Float64Array(deepest + MOST_OPERANDS);
  return {
    results: stack.subarray(0, depth),
    update: (clock) => {
      const { timeS, frame } = clock;
      for (let i = 0; i < times.length; i++) known[times[i] ?? 0] = timeS;
      for (let i = 0; i < frames.length; i++) known[frames[i] ?? 0] = frame;
      let top = -1;
      for (let i = 0; i < words.length; i++) {
        const view = views[i];
        top += 1 - (takes[i] ?? 0);
        if (view) stack[top] = view.value;
        else if (isKnown[i]) stack[top] = known[i] ?? 0;
        else operate(words[i] as Operation, stack, top);
      }
    },
  };
}

/** Applies an operation to the numbers from `at` on, and writes the result to `at`. */
function operate(operation: Operation, stack: Float64Array, at: number): void {
  const a = stack[at] ?? 0;
  const b = stack[at + 1] ?? 0;
  const c = stack[at + 2] ?? 0;
  switch (operation) {
    case 'sin':
      stack[at] = Math.sin(a);
      break;
    case 'cos':
      stack[at] = Math.cos(a);
      break;
    case 'tan':
      stack[at] = Math.tan(a);
      break;
    case 'asin':
      stack[at] = Math.asin(a);
      break;
    case 'acos':
      stack[at] = Math.acos(a);
      break;
    case 'atan':
      stack[at] = Math.atan(a);
      break;
    case 'exp':
      stack[at] = Math.exp(a);
      break;
    case 'log':
      stack[at] = Math.log(a);
      break;
    case 'sign':
      stack[at] = Math.sign(a);
      break;
    case 'fract':
      stack[at] = a - Math.floor(a);
      break;
    case 'atan2':
      stack[at] = Math.atan2(a, b);
      break;
    case 'step':
      stack[at] = b < a ? 0 : 1;
      break;
    case 'clamp':
      stack[at] = Math.min(Math.max(a, b), c);
      break;
    case 'mix':
      stack[at] = a * (1 - c) + b * c;
      break;
    case 'smoothstep': {
      const t = Math.min(Math.max((c - a) / (b - a), 0), 1);
      stack[at] = t * t * (3 - 2 * t);
      break;
    }
    default:
      calculate(operation, stack, at);
  }
}
