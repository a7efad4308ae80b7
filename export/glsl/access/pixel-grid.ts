import { numericOf } from '../check/glsl-type.ts';
import { classifyImageCall } from '../link/image-call.ts';
import type { CallExpression, Expression, FunctionSymbol, VariableSymbol } from '../syntax/ast.ts';

/**
 * What is known of a number, whatever its value: `whole` and `half` are whole numbers and those plus 0.5; `width` and `height` are the size
 * of the image in pixels; `x step` is a multiple of the width of a pixel in normalized coordinates, and `x center` the center of a pixel
 * there. Whole numbers are multiples of both steps. Null: nothing is known.
 */
type Grid = 'whole' | 'half' | 'width' | 'height' | `${Axis} step` | `${Axis} center` | null;

type Axis = 'x' | 'y';

/** The grids of the components of a value. */
type Grids = readonly Grid[];

/** Maximum nesting of an expression that is analyzed. */
const MAX_DEPTH = 50;

/** Maximum number of variables and parameters to follow, to protect the stack. */
const MAX_FOLLOWED = 100;

/**
 * Returns a function that finds out whether a call reads the color of an image exactly at the center of a pixel, so that filtering returns
 * that pixel: `texelFetch`; `IMG_PIXEL` at `gl_FragCoord` plus whole numbers or at `floor(…) + 0.5`; `IMG_NORM_PIXEL` at the current
 * position plus pixels by the size, or mirrored (`1.0 - …`). Positions beyond the edges count, because they are clamped to pixels.
 *
 * The function computes with the fractions of numbers and follows variables that are set once and the arguments of all calls. An unclear
 * position is none, which is always safe.
 *
 * @param calls The calls of each function.
 */
export function createTexelReads(calls: Calls): (call: CallExpression) => boolean {
  const finders = new Map<string, (expression: Expression) => Grids>();
  return (call) => {
    const read = classifyImageCall(call);
    const [image, at] = call.args;
    if (read?.use !== 'color' || image === undefined) return false;
    if (read.position === 'here' || read.position === 'texel') return true;
    if (at === undefined) return false;
    const name = image.token.text;
    const find = finders.get(name) ?? createFinder(calls, name);
    finders.set(name, find);
    const [x = null, y = null] = find(at);
    if (read.position === 'pixel') return x === 'half' && y === 'half';
    return (read.position === 'norm' || read.position === 'offset') && x === 'x center' && y === 'y center';
  };
}

type Calls = ReadonlyMap<FunctionSymbol, readonly CallExpression[]>;

/** Built-in functions of one argument whose result is whole. */
const WHOLE_RESULTS: ReadonlySet<string> = new Set(['floor', 'ceil', 'round', 'roundEven', 'trunc', 'sign']);

const BUILTINS: Readonly<Record<string, Grids>> = {
  gl_FragCoord: ['half', 'half', 'half', 'whole'],
  isf_FragCoord: ['half', 'half', 'half', 'whole'],
  vv_FragCoord: ['half', 'half', 'half', 'whole'],
  isf_FragNormCoord: ['x center', 'y center'],
  vv_FragNormCoord: ['x center', 'y center'],
  RENDERSIZE: ['width', 'height'],
};

function createFinder(calls: Calls, image: string): (expression: Expression) => Grids {
  const known = new Map<VariableSymbol, Grids>();
  let followed = 0;

  function find(expression: Expression): Grids {
    const numeric = numericOf(expression.type);
    if (expression.depth > MAX_DEPTH || numeric === null) return [];
    if (numeric.columns > 1) return filled(numeric.rows * numeric.columns, null);
    const unknown = numeric.base === 'float' ? null : 'whole';
    const grids = search(expression);
    return Array.from({ length: numeric.rows }, (_, i) => (grids.length === numeric.rows ? (grids[i] ?? unknown) : unknown));
  }

  function search(expression: Expression): Grids {
    switch (expression.kind) {
      case 'group':
        return find(expression.inner);
      case 'literal':
        return [ofNumber(Number.parseFloat(expression.token.text))];
      case 'name':
        return expression.symbol === null ? [] : ofVariable(expression.symbol);
      case 'member':
        return ofComponents(find(expression.object), expression.name.text);
      case 'prefix':
        return expression.token.text === '-' || expression.token.text === '+' ? find(expression.operand).map(plain) : [];
      case 'conditional':
        return joined(find(expression.then), find(expression.otherwise));
      case 'binary':
        return combined(expression.token.text, find(expression.left), find(expression.right));
      case 'call':
        return ofCall(expression);
      default:
        return [];
    }
  }

  function ofCall(call: CallExpression): Grids {
    const name = call.token.text;
    if (call.symbol !== null) return [];
    if (name === 'IMG_SIZE' || name === 'textureSize') return call.args[0]?.token.text === image ? ['width', 'height'] : ['whole', 'whole'];
    const args = call.args.map(find);
    const [first = [], second = [], third = []] = args;
    const type = numericOf(name);
    if (type !== null) return ofConstructor(args, type.columns === 1 ? type.rows : 0, type.base === 'float');
    if (WHOLE_RESULTS.has(name)) return filled(first.length, 'whole');
    if (name === 'step') return filled(second.length, 'whole');
    if (name === 'min' || name === 'max') return joined(first, second);
    if (name === 'clamp') return joined(first, joined(second, third));
    if (name === 'abs' || name === 'fract') return first.map(plain);
    return name === 'mod' ? combined('-', first, combined('*', second, ['whole'])) : [];
  }

  function ofVariable(symbol: VariableSymbol): Grids {
    const before = known.get(symbol);
    if (before !== undefined) return before;
    // Set before the recursion, so that circular definitions end.
    known.set(symbol, []);
    if (followed >= MAX_FOLLOWED) return [];
    followed += 1;
    const grids = searchVariable(symbol);
    followed -= 1;
    known.set(symbol, grids);
    return grids;
  }

  function searchVariable(symbol: VariableSymbol): Grids {
    if (symbol.role === 'builtin') return BUILTINS[symbol.name] ?? [];
    if (symbol.written) return [];
    if (symbol.declaration?.initializer) return find(symbol.declaration.initializer);
    if (symbol.parameterOf === null) return [];
    const { owner, index } = symbol.parameterOf;
    const given = (calls.get(owner) ?? []).map(({ args }) => (args[index] === undefined ? [] : find(args[index])));
    return given.length === 0 ? [] : given.reduce(joined);
  }

  return find;
}

function filled(length: number, grid: Grid): Grids {
  return Array.from({ length }, () => grid);
}

function ofNumber(value: number): Grid {
  if (Number.isInteger(value)) return 'whole';
  return Number.isInteger(value + 0.5) ? 'half' : null;
}

function ofConstructor(args: readonly Grids[], rows: number, isFloat: boolean): Grids {
  if (!isFloat) return filled(rows, 'whole');
  const parts = args.flat();
  const [only = null] = parts;
  return parts.length === 1 ? filled(rows, only) : parts.slice(0, rows);
}

function ofComponents(grids: Grids, letters: string): Grids {
  return [...letters].map((letter) => grids[['xrs', 'ygt', 'zbp', 'waq'].findIndex((names) => names.includes(letter))] ?? null);
}

/** Applies an operator to each component; one number applies to all. */
function combined(operator: string, left: Grids, right: Grids): Grids {
  const length = Math.max(left.length, right.length);
  const at = (grids: Grids, i: number) => (grids.length === 1 ? grids[0] : grids[i]) ?? null;
  return Array.from({ length }, (_, i) => combine(operator, at(left, i), at(right, i)));
}

function combine(operator: string, left: Grid, right: Grid): Grid {
  if (operator === '/') return divided(left, right);
  if (operator === '*') return multiplied(left, right) ?? multiplied(right, left);
  return operator === '+' || operator === '-' ? (added(plain(left), plain(right)) ?? added(plain(right), plain(left))) : null;
}

/** A size is a whole number. */
function plain(grid: Grid): Grid {
  return grid === 'width' || grid === 'height' ? 'whole' : grid;
}

function added(a: Grid, b: Grid): Grid {
  if (a === null || b === null) return null;
  if (a === 'half' && b === 'half') return 'whole';
  if (b === 'whole') return a;
  const [axis, kind] = a.split(' ') as [Axis, string | undefined];
  const [other, otherKind] = b.split(' ');
  if (kind === undefined || axis !== other) return null;
  if (otherKind === 'step') return a;
  return kind === 'center' && otherKind === 'center' ? `${axis} step` : null;
}

function multiplied(a: Grid, b: Grid): Grid {
  if (plain(a) === 'whole' && plain(b) === 'whole') return 'whole';
  if ((a === 'width' && b === 'x step') || (a === 'height' && b === 'y step')) return 'whole';
  if ((a === 'width' && b === 'x center') || (a === 'height' && b === 'y center')) return 'half';
  return plain(a) === 'whole' && (b === 'x step' || b === 'y step') ? b : null;
}

function divided(a: Grid, b: Grid): Grid {
  const axis = b === 'width' ? 'x' : b === 'height' ? 'y' : null;
  if (axis === null || (plain(a) !== 'whole' && a !== 'half')) return null;
  return a === 'half' ? `${axis} center` : `${axis} step`;
}

/** What is known of a number that is one of two. */
function joined(a: Grids, b: Grids): Grids {
  const length = Math.max(a.length, b.length);
  const at = (grids: Grids, i: number) => plain((grids.length === 1 ? grids[0] : grids[i]) ?? null);
  return Array.from({ length }, (_, i) => either(at(a, i), at(b, i)));
}

function either(a: Grid, b: Grid): Grid {
  if (a === b) return a;
  const isStep = (grid: Grid) => grid === 'x step' || grid === 'y step';
  if (a === 'whole' && isStep(b)) return b;
  return b === 'whole' && isStep(a) ? a : null;
}
