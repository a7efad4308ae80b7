import type { CallExpression, Expression, ForStatement, FunctionSymbol, Statement, VariableSymbol } from '../syntax/ast.ts';
import { ASSIGNMENTS } from '../syntax/parse-expression.ts';
import { partsOf, walkExpression, walkStatement } from '../syntax/walk-tree.ts';
import { calleesFirst, functionsOf } from './call-graph.ts';
import type { CheckedShader } from './check-shader.ts';

/**
 * Computes an upper bound of the number of iterations of all loops of a shader together, for one pixel; infinite if the text does not limit
 * it. Counted are loops of the form `for (int i = 0; i < 8; i++)` with constant bounds and step whose body does not set `i`. Most shaders
 * have no other loops, so they need no probe on the GPU.
 */
export function countRounds({ main, declarations }: CheckedShader): number {
  const known = new Map<FunctionSymbol, number>();

  function ofPart(part: Statement | Expression): number {
    if (part.kind === 'while' || part.kind === 'do') return Number.POSITIVE_INFINITY;
    // A function that is not known yet calls itself.
    const called = part.kind === 'call' && part.symbol?.kind === 'function' ? (known.get(part.symbol) ?? Number.POSITIVE_INFINITY) : 0;
    const inside = partsOf(part).reduce((sum, inner) => sum + ofPart(inner), called);
    return part.kind === 'for' ? roundsOf(part) * (1 + inside) : inside;
  }

  for (const symbol of calleesFirst(functionsOf(declarations))) {
    const { body } = symbol.declaration;
    known.set(symbol, body === null ? 0 : ofPart(body));
  }
  const globals = declarations.flatMap((declaration) => (declaration.kind === 'variables' ? declaration.declarators : []));
  const initial = globals.reduce((sum, { initializer }) => sum + (initializer === null ? 0 : ofPart(initializer)), 0);
  return initial + (main.symbol === null ? Number.POSITIVE_INFINITY : (known.get(main.symbol) ?? Number.POSITIVE_INFINITY));
}

/** A step smaller than this fraction of the counter may be lost in single precision. */
const LEAST_STEP = 1e-5;

function roundsOf(loop: ForStatement): number {
  const unknown = Number.POSITIVE_INFINITY;
  const { initial, condition, step } = loop;
  if (initial?.kind !== 'variables' || initial.declarators.length !== 1) return unknown;
  const [counter] = initial.declarators;
  const symbol = counter?.symbol;
  if (!symbol || !counter.initializer || condition === null || condition.kind === 'variables' || step === null) return unknown;
  const start = numberIn(counter.initializer);
  const by = stepOf(step, symbol);
  if (start === null || by === null || by === 0 || writes(loop.body, symbol)) return unknown;
  const ends = limitsOf(condition, symbol, by > 0);
  const rounds = ends.map((end) => {
    if (Math.abs(by) < LEAST_STEP * Math.max(Math.abs(start), Math.abs(end))) return unknown;
    return Math.max(0, Math.floor((end - start) / by) + 1);
  });
  return Math.min(unknown, ...rounds);
}

/**
 * Constant limits that the condition of a loop sets to its counter, from both operands of each `&&`: upper limits if the counter increases
 * (`upwards`), else lower limits.
 */
function limitsOf(condition: Expression, symbol: VariableSymbol, upwards: boolean): number[] {
  if (condition.kind === 'group') return limitsOf(condition.inner, symbol, upwards);
  if (condition.kind !== 'binary') return [];
  const { left, right, token } = condition;
  if (token.text === '&&') return [...limitsOf(left, symbol, upwards), ...limitsOf(right, symbol, upwards)];
  const isBound = (upwards ? ['<', '<='] : ['>', '>=']).includes(token.text);
  const end = isBound && isName(left, symbol) ? numberIn(right) : null;
  return end === null ? [] : [end];
}

/** The increment of a step expression; null if it is not a constant. */
function stepOf(step: Expression, symbol: VariableSymbol): number | null {
  if (step.kind === 'group') return stepOf(step.inner, symbol);
  if ((step.kind === 'prefix' || step.kind === 'postfix') && isName(step.operand, symbol)) {
    return step.token.text === '++' ? 1 : step.token.text === '--' ? -1 : null;
  }
  if (step.kind !== 'binary' || !isName(step.left, symbol)) return null;
  const by = numberIn(step.right);
  if (by === null) return null;
  return step.token.text === '+=' ? by : step.token.text === '-=' ? -by : null;
}

/** Maximum number of constants to follow, to protect the stack. */
const MAX_FOLLOWED = 100;

/** The constant value of an expression; null if it has none. */
function numberIn(expression: Expression, left = MAX_FOLLOWED): number | null {
  switch (expression.kind) {
    case 'literal':
      return literalValue(expression.token.text);
    case 'group':
      return numberIn(expression.inner, left);
    case 'name': {
      const { symbol } = expression;
      const value = symbol?.constant ? symbol.declaration?.initializer : undefined;
      return value && left > 0 ? numberIn(value, left - 1) : null;
    }
    case 'prefix': {
      const value = numberIn(expression.operand, left);
      if (value === null) return null;
      return expression.token.text === '-' ? -value : expression.token.text === '+' ? value : null;
    }
    case 'call': {
      const [only, ...more] = expression.args;
      const converts = expression.symbol === null && more.length === 0 && only !== undefined;
      const value = converts ? numberIn(only, left) : null;
      if (value === null) return null;
      return expression.token.text === 'int' ? Math.trunc(value) : expression.token.text === 'float' ? value : null;
    }
    default:
      return null;
  }
}

/** The value of a number in the text; null for octal numbers. */
function literalValue(text: string): number | null {
  if (/^0[0-9]/.test(text)) return null;
  const number = Number(/^0x/i.test(text) ? text.replace(/u$/i, '') : text.replace(/(?:lf|[fu])$/i, ''));
  return Number.isFinite(number) ? number : null;
}

function isName(expression: Expression, symbol: VariableSymbol): boolean {
  if (expression.kind === 'group') return isName(expression.inner, symbol);
  return expression.kind === 'name' && expression.symbol === symbol;
}

/** Whether a statement may write the variable. */
function writes(statement: Statement, symbol: VariableSymbol): boolean {
  let found = false;
  walkStatement(statement, {
    expression: (expression) => {
      found ||= changes(expression, symbol);
      return undefined;
    },
  });
  return found;
}

function changes(expression: Expression, symbol: VariableSymbol): boolean {
  if (expression.kind === 'binary') return ASSIGNMENTS.has(expression.token.text) && names(expression.left, symbol);
  if (expression.kind === 'prefix' || expression.kind === 'postfix') {
    return ['++', '--'].includes(expression.token.text) && names(expression.operand, symbol);
  }
  return expression.kind === 'call' && isHandedOut(expression, symbol);
}

/** Built-in functions that write to an argument. */
const WRITING = new Set(['modf', 'frexp']);

function isHandedOut({ args, token, symbol: callee }: CallExpression, symbol: VariableSymbol): boolean {
  if (callee?.kind === 'struct') return false;
  return args.some((arg, i) => (callee === null ? WRITING.has(token.text) : callee.parameterOut[i] === true) && names(arg, symbol));
}

function names(expression: Expression, symbol: VariableSymbol): boolean {
  let found = false;
  walkExpression(expression, {
    expression: (inner) => {
      found ||= inner.kind === 'name' && inner.symbol === symbol;
      return undefined;
    },
  });
  return found;
}
