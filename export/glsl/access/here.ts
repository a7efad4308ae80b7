import type { CallExpression, Expression, FunctionSymbol, VariableSymbol } from '../syntax/ast.ts';

/** A position at which a shader reads an image: the current pixel, in normalized coordinates or in pixels, or any other position. */
export type Position = 'here-norm' | 'here-pixel' | 'elsewhere';

const NORM_NAMES: ReadonlySet<string> = new Set(['isf_FragNormCoord', 'vv_FragNormCoord']);
const PIXEL_NAMES: ReadonlySet<string> = new Set(['gl_FragCoord', 'isf_FragCoord', 'vv_FragCoord']);

/** Maximum nesting of an expression that is analyzed. */
const MAX_DEPTH = 50;

/** Maximum number of variables and parameters to follow, to protect the stack. */
const MAX_FOLLOWED = 100;

/**
 * Returns a function that finds out whether an expression is the position of the current pixel in an image. The function follows variables
 * that are set once and parameters with the same argument in all calls; any other position is `elsewhere`, which is always safe.
 */
export function createPositions(calls: Calls): FindPosition {
  const finders = new Map<string, (expression: Expression) => Position>();
  return (expression, image) => {
    const find = finders.get(image) ?? createFinder(calls, image);
    finders.set(image, find);
    return find(expression);
  };
}

/** @param image The name of the image that is read at the position. */
export type FindPosition = (expression: Expression, image: string) => Position;

type Calls = ReadonlyMap<FunctionSymbol, readonly CallExpression[]>;

function createFinder(calls: Calls, image: string): (expression: Expression) => Position {
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
    // Set before the recursion, so that circular definitions end.
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

  /** Whether an expression is the size in pixels of what is drawn or of the image. Another image may have another size. */
  function isSize(expression: Expression): boolean {
    if (expression.kind === 'group') return isSize(expression.inner);
    if (expression.kind === 'member') return expression.name.text === 'xy' && isSize(expression.object);
    if (expression.kind !== 'call')
      return expression.kind === 'name' && expression.symbol?.role === 'builtin' && expression.symbol.name === 'RENDERSIZE';
    const [of] = expression.args;
    return expression.symbol === null && expression.token.text === 'IMG_SIZE' && of?.kind === 'name' && of.token.text === image;
  }

  return find;
}
