import type { CallExpression, Expression, FunctionSymbol, VariableSymbol } from '../syntax/ast.ts';

/** What a position is known to be: the pixel that is being drawn, from 0 to 1 or in pixels, or anything else. */
export type Position = 'here-norm' | 'here-pixel' | 'elsewhere';

const NORM_NAMES: ReadonlySet<string> = new Set(['isf_FragNormCoord', 'vv_FragNormCoord']);
const PIXEL_NAMES: ReadonlySet<string> = new Set(['gl_FragCoord', 'isf_FragCoord', 'vv_FragCoord']);

/** Deeper than any author writes a position. */
const MAX_DEPTH = 50;

/** Variables and parameters that a position is handed on by, one after the other: more would be a matter of the stack. */
const MAX_FOLLOWED = 100;

/**
 * Finds out which positions are this pixel's. Variables that are set once and parameters that are given the same everywhere
 * are followed; what cannot be followed is elsewhere, which is the safe answer.
 */
export function createPositions(calls: ReadonlyMap<FunctionSymbol, readonly CallExpression[]>): (expression: Expression) => Position {
  const known = new Map<VariableSymbol, Position>();
  let followed = 0;

  function find(expression: Expression): Position {
    if (expression.depth > MAX_DEPTH) return 'elsewhere';
    switch (expression.kind) {
      case 'group':
        return find(expression.inner);
      case 'name':
        return expression.symbol === null ? 'elsewhere' : ofVariable(expression.symbol);
      case 'member':
        return /^(?:xy|st|rg)$/.test(expression.name.text) ? find(expression.object) : 'elsewhere';
      case 'call': {
        const [only] = expression.args;
        return expression.token.text === 'vec2' && only !== undefined && expression.args.length === 1 ? find(only) : 'elsewhere';
      }
      case 'binary':
        if (expression.token.text === '/' && isSize(expression.right) && find(expression.left) === 'here-pixel') return 'here-norm';
        if (expression.token.text !== '*') return 'elsewhere';
        if (isSize(expression.right) && find(expression.left) === 'here-norm') return 'here-pixel';
        return isSize(expression.left) && find(expression.right) === 'here-norm' ? 'here-pixel' : 'elsewhere';
      default:
        return 'elsewhere';
    }
  }

  function ofVariable(symbol: VariableSymbol): Position {
    const before = known.get(symbol);
    if (before !== undefined) return before;
    // In place before the search goes on, so that what a broken text makes circular ends.
    known.set(symbol, 'elsewhere');
    if (followed >= MAX_FOLLOWED) return 'elsewhere';
    followed += 1;
    const position = searchVariable(symbol);
    followed -= 1;
    known.set(symbol, position);
    return position;
  }

  function searchVariable(symbol: VariableSymbol): Position {
    if (symbol.role === 'builtin') {
      if (NORM_NAMES.has(symbol.name)) return 'here-norm';
      return PIXEL_NAMES.has(symbol.name) ? 'here-pixel' : 'elsewhere';
    }
    if (symbol.written) return 'elsewhere';
    if (symbol.declaration?.initializer) return find(symbol.declaration.initializer);
    if (symbol.parameterOf === null) return 'elsewhere';
    const { owner, index } = symbol.parameterOf;
    const given = new Set<Position>();
    for (const call of calls.get(owner) ?? []) {
      const arg = call.args[index];
      given.add(arg === undefined ? 'elsewhere' : find(arg));
    }
    const [first = 'elsewhere'] = given;
    return given.size === 1 ? first : 'elsewhere';
  }

  return find;
}

/** A layer that is read and the layer that is made have the same size in pixels, see `PassSampler`. */
function isSize(expression: Expression): boolean {
  if (expression.kind === 'group') return isSize(expression.inner);
  if (expression.kind === 'member') return expression.name.text === 'xy' && isSize(expression.object);
  if (expression.kind === 'call') return expression.symbol === null && expression.token.text === 'IMG_SIZE';
  return expression.kind === 'name' && expression.symbol?.role === 'builtin' && expression.symbol.name === 'RENDERSIZE';
}
