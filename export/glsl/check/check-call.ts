import type { CallExpression, Expression, FunctionSymbol, GlslType } from '../syntax/ast.ts';
import { TYPES } from '../syntax/words.ts';
import { matchBuiltin, TEXTURE_FUNCTIONS } from './builtin-functions.ts';
import { convert, markWritten } from './convert.ts';
import { canonicalType, converts } from './glsl-type.ts';
import { type CheckContext, findStruct } from './scope.ts';

/** Functions of ISF and Scrim, which the printer replaces: result type, and types of the arguments after the image. */
const IMAGE_FUNCTIONS: ReadonlyMap<string, readonly [returns: GlslType, ...args: GlslType[]]> = new Map([
  ['IMG_PIXEL', ['vec4', 'vec2']],
  ['IMG_NORM_PIXEL', ['vec4', 'vec2']],
  ['IMG_THIS_PIXEL', ['vec4']],
  ['IMG_THIS_NORM_PIXEL', ['vec4']],
  // The spelling of docs.isf.video.
  ['IMG_NORM_THIS_PIXEL', ['vec4']],
  ['IMG_SIZE', ['vec2']],
  ['IMG_SAMPLES', ['vec2']],
  ['LAYER_DEPTH', ['float', 'vec2']],
  ['ROOM_DEPTH', ['float', 'vec2']],
  ['CURVE', ['float', 'float']],
  ['GRADIENT', ['vec4', 'float']],
]);

export function isImageFunction(name: string): boolean {
  return IMAGE_FUNCTIONS.has(name);
}

/** Resolves a call to an author's function, a struct or a built-in function. The arguments have been checked. */
export function checkCall(call: CallExpression, context: CheckContext): GlslType {
  const name = call.token.text;
  if (TYPES.has(name)) return canonicalType(name);
  const struct = findStruct(context.scope, name);
  if (struct !== null) {
    call.symbol = struct;
    const memberTypes = [...struct.members.values()];
    call.args.forEach((arg, i) => {
      convert(arg, memberTypes[i] ?? '');
    });
    return struct.type;
  }
  const candidates = context.functions.get(name) ?? [];
  const types = call.args.map((arg) => arg.type);
  const builtin = matchBuiltin(name, types);
  const chosen = choose(candidates, types, builtin?.exact ?? false, builtin !== null);
  if (chosen !== null) {
    call.symbol = chosen;
    return applyFunction(chosen, call.args);
  }
  if (builtin !== null) {
    call.args.forEach((arg, i) => {
      convert(arg, builtin.parameters[i] ?? '');
    });
    if (name === 'modf' && call.args[1] !== undefined) markWritten(call.args[1]);
    return builtin.returns;
  }
  return checkImageCall(name, call.args);
}

/**
 * Chooses the author's function that a call refers to; null for a built-in function or for none. Precedence: an exact match, the author's
 * before the built-in; then the author's with conversions, then the built-in. So an author can add `round(float, float)` beside the
 * built-in `round(float)`, or replace it, as older GLSL allows.
 */
function choose(
  candidates: readonly FunctionSymbol[],
  types: readonly GlslType[],
  builtinExact: boolean,
  builtinFits: boolean,
): FunctionSymbol | null {
  const sameCount = candidates.filter((candidate) => candidate.parameterTypes.length === types.length);
  const exact = sameCount.find((candidate) => fits(candidate, types, false));
  if (exact !== undefined) return exact;
  if (builtinExact) return null;
  const converted = sameCount.find((candidate) => fits(candidate, types, true));
  if (converted !== undefined) return converted;
  // Without a match, the driver reports the mistake at the author's function.
  return builtinFits ? null : (sameCount[0] ?? candidates[0] ?? null);
}

function fits(candidate: FunctionSymbol, types: readonly GlslType[], converting: boolean): boolean {
  return candidate.parameterTypes.every((wanted, i) => {
    const given = types[i] ?? '';
    if (given === '' || wanted === '' || given === wanted) return true;
    return converting && !candidate.parameterOut[i] && converts(given, wanted);
  });
}

function applyFunction(chosen: FunctionSymbol, args: readonly Expression[]): GlslType {
  args.forEach((arg, i) => {
    if (chosen.parameterOut[i]) markWritten(arg);
    else convert(arg, chosen.parameterTypes[i] ?? '');
  });
  return chosen.returnType;
}

function checkImageCall(name: string, args: readonly Expression[]): GlslType {
  const image = IMAGE_FUNCTIONS.get(name);
  if (image !== undefined) {
    const [returns, ...wanted] = image;
    args.slice(1).forEach((arg, i) => {
      convert(arg, wanted[i] ?? '');
    });
    return returns;
  }
  if (name === 'textureSize') return 'ivec2';
  if (!TEXTURE_FUNCTIONS.has(name)) return '';
  if (!name.startsWith('texelFetch') && args[1] !== undefined) convert(args[1], args[0]?.type === 'samplerCube' ? 'vec3' : 'vec2');
  if (args[2] !== undefined) convert(args[2], name.startsWith('texelFetch') ? 'int' : 'float');
  return 'vec4';
}
