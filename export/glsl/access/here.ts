import type { CallExpression, Expression, FunctionSymbol, VariableSymbol } from '../syntax/ast.ts';

/** What a position is known to be: the pixel that is being drawn, from 0 to 1 or in pixels, or anything else. */
export type Position = 'here-norm' | 'here-pixel' | 'elsewhere';

const NORM_NAMES: ReadonlySet<string> = new Set(['isf_FragNormCoord', 'vv_FragNormCoord']);
const PIXEL_NAMES: ReadonlySet<string> = new Set(['gl_FragCoord', 'isf_FragCoord', 'vv_FragCoord']);

/** Longer trails of variables than anyone writes; also ends what a broken text may make circular. */
const MAX_STEPS = 50;

/**
 * Follows variables that are set once and parameters that are given the same everywhere. Whatever cannot be followed is
 * elsewhere, which is the safe answer.
 */
export function positionOf(expression: Expression, callsOf: (symbol: FunctionSymbol) => readonly CallExpression[], steps = 0): Position {
  if (steps > MAX_STEPS) return 'elsewhere';
  const follow = (part: Expression) => positionOf(part, callsOf, steps + 1);
  switch (expression.kind) {
    case 'group':
      return follow(expression.inner);
    case 'name':
      return expression.symbol === null ? 'elsewhere' : positionOfVariable(expression.symbol, callsOf, steps);
    case 'member':
      return /^(?:xy|st|rg)$/.test(expression.name.text) ? follow(expression.object) : 'elsewhere';
    case 'call': {
      const [only] = expression.args;
      return expression.token.text === 'vec2' && only !== undefined && expression.args.length === 1 ? follow(only) : 'elsewhere';
    }
    case 'binary':
      if (expression.token.text === '/' && isSize(expression.right) && follow(expression.left) === 'here-pixel') return 'here-norm';
      if (expression.token.text !== '*') return 'elsewhere';
      if (isSize(expression.right) && follow(expression.left) === 'here-norm') return 'here-pixel';
      return isSize(expression.left) && follow(expression.right) === 'here-norm' ? 'here-pixel' : 'elsewhere';
    default:
      return 'elsewhere';
  }
}

function positionOfVariable(
  symbol: VariableSymbol,
  callsOf: (symbol: FunctionSymbol) => readonly CallExpression[],
  steps: number,
): Position {
  if (symbol.role === 'builtin') {
    if (NORM_NAMES.has(symbol.name)) return 'here-norm';
    return PIXEL_NAMES.has(symbol.name) ? 'here-pixel' : 'elsewhere';
  }
  if (symbol.written) return 'elsewhere';
  if (symbol.declaration?.initializer) return positionOf(symbol.declaration.initializer, callsOf, steps + 1);
  if (symbol.parameterOf === null) return 'elsewhere';
  const { owner, index } = symbol.parameterOf;
  const given = new Set(
    callsOf(owner).map((call) => {
      const arg = call.args[index];
      return arg === undefined ? 'elsewhere' : positionOf(arg, callsOf, steps + 1);
    }),
  );
  const [first = 'elsewhere'] = given;
  return given.size === 1 ? first : 'elsewhere';
}

/** A layer that is read and the layer that is made have the same size in pixels, see `PassSampler`. */
function isSize(expression: Expression): boolean {
  if (expression.kind === 'group') return isSize(expression.inner);
  if (expression.kind === 'member') return expression.name.text === 'xy' && isSize(expression.object);
  if (expression.kind === 'call') return expression.symbol === null && expression.token.text === 'IMG_SIZE';
  return expression.kind === 'name' && expression.symbol?.role === 'builtin' && expression.symbol.name === 'RENDERSIZE';
}
