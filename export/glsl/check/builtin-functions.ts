import type { GlslType } from '../syntax/ast.ts';
import { canonicalType, converts, matrixType, numericOf, vectorType } from './glsl-type.ts';

/**
 * Functions of GLSL ES 3.00 §8 by signature. `G I U B` are float, int, uint and bool of any size, `V J W L` vectors of them;
 * all letters of one signature have the same size. `M` is a square matrix.
 */
const SIGNATURES = `
radians degrees sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh: G G
exp log exp2 log2 sqrt inversesqrt sign abs floor trunc round roundEven ceil fract normalize dFdx dFdy fwidth: G G
sign abs: I I
atan pow mod min max step reflect: G G G
mod min max: G G float
min max: I I I | I I int | U U U | U U uint
step: G float G
modf: G G G
clamp: G G G G | G G float float | I I I I | I I int int | U U U U | U U uint uint
mix: G G G G | G G G float | G G G B
smoothstep: G G G G | G float float G
isnan isinf: B G
floatBitsToInt: I G
floatBitsToUint: U G
intBitsToFloat: G I
uintBitsToFloat: G U
packSnorm2x16 packUnorm2x16 packHalf2x16: uint vec2
unpackSnorm2x16 unpackUnorm2x16 unpackHalf2x16: vec2 uint
length: float G
distance dot: float G G
cross: vec3 vec3 vec3
faceforward: G G G G
refract: G G G float
matrixCompMult: M M M
determinant: float M
inverse transpose: M M
lessThan lessThanEqual greaterThan greaterThanEqual equal notEqual: L V V | L J J | L W W
equal notEqual: L L L
any all: bool L
not: L L
`;

interface Signature {
  readonly returns: string;
  readonly parameters: readonly string[];
}

const TABLE: ReadonlyMap<string, readonly Signature[]> = readSignatures();

const GENERIC_BASE = { G: 'float', I: 'int', U: 'uint', B: 'bool', V: 'float', J: 'int', W: 'uint', L: 'bool' } as const;

/** Texture functions of all versions. They are not constant, and the printer handles them. */
export const TEXTURE_FUNCTIONS: ReadonlySet<string> = new Set(
  (
    'texture textureProj textureLod textureOffset texelFetch texelFetchOffset textureProjOffset textureLodOffset textureProjLod textureProjLodOffset ' +
    'textureGrad textureGradOffset textureProjGrad textureProjGradOffset textureSize texture2D texture2DProj texture2DLod texture2DProjLod texture2DLodEXT ' +
    'texture2DProjLodEXT texture2DGradEXT texture2DProjGradEXT texture2DRect texture2DRectProj textureCube textureCubeLod textureCubeLodEXT textureCubeGradEXT ' +
    'texture1D texture3D shadow2D'
  ).split(' '),
);

/** Whether GLSL ES 3.00 defines a function of this name. `outerProduct` has no signature here, because its type depends on both sizes. */
export function isBuiltinFunction(name: string): boolean {
  return TABLE.has(name) || TEXTURE_FUNCTIONS.has(name) || name === 'outerProduct';
}

export interface BuiltinMatch {
  readonly returns: GlslType;
  readonly parameters: readonly GlslType[];
  /** Whether no argument needs a conversion. */
  readonly exact: boolean;
}

/** Finds the overload for the arguments, first without conversions, then with. An argument of unknown type matches any parameter. */
export function matchBuiltin(name: string, args: readonly GlslType[]): BuiltinMatch | null {
  if (name === 'outerProduct') return matchOuterProduct(args);
  const signatures = (TABLE.get(name) ?? []).filter((signature) => signature.parameters.length === args.length);
  for (const exact of [true, false]) {
    for (const signature of signatures) {
      const match = matchSignature(signature, args, exact);
      if (match !== null) return match;
    }
  }
  return null;
}

function matchSignature(signature: Signature, args: readonly GlslType[], exact: boolean): BuiltinMatch | null {
  // The first argument of known type determines the size.
  const sized = signature.parameters.findIndex((parameter, i) => /^[A-Z]$/.test(parameter) && args[i] !== '');
  const rows = sized < 0 ? 0 : (numericOf(args[sized] ?? '')?.rows ?? 0);
  if (sized >= 0 && rows === 0) return null;
  const parameters = signature.parameters.map((parameter) => instantiate(parameter, rows));
  const fits = parameters.every((parameter, i) => {
    const arg = args[i] ?? '';
    return arg === '' || parameter === '' || arg === parameter || (!exact && converts(arg, parameter));
  });
  if (!fits || (exact && args.every((arg) => arg === '') && parameters.length > 0)) return null;
  return { returns: instantiate(signature.returns, rows), parameters, exact };
}

/**
 * The type that a type or letter of a signature stands for in a call with `rows` components. Empty, which matches any type, if `rows` is 0;
 * `none`, which matches no known type, for a vector or matrix letter with one component.
 */
function instantiate(type: string, rows: number): GlslType {
  if (type.length > 1) return canonicalType(type);
  if (rows === 0) return '';
  if (type === 'M') return rows > 1 ? `mat${rows}` : 'none';
  if ('VJWL'.includes(type) && rows === 1) return 'none';
  return vectorType(GENERIC_BASE[type as keyof typeof GENERIC_BASE], rows);
}

function matchOuterProduct(args: readonly GlslType[]): BuiltinMatch | null {
  const [column = '', row = ''] = args;
  const rows = numericOf(column)?.rows;
  const columns = numericOf(row)?.rows;
  if (rows === undefined || columns === undefined) return null;
  return { returns: matrixType(columns, rows), parameters: [column, row], exact: true };
}

function readSignatures(): Map<string, Signature[]> {
  const table = new Map<string, Signature[]>();
  for (const line of SIGNATURES.trim().split('\n')) {
    const [names = '', forms = ''] = line.split(': ');
    const signatures = forms.split(' | ').map((form) => {
      const [returns = '', ...parameters] = form.split(' ');
      return { returns, parameters };
    });
    for (const name of names.split(' ')) table.set(name, [...(table.get(name) ?? []), ...signatures]);
  }
  return table;
}
