import type { GlslType } from '../syntax/ast.ts';

/** The parts of a numeric type: `vec3` has three float rows in one column, `mat2x3` two columns of three rows. */
export interface Numeric {
  readonly base: 'float' | 'int' | 'uint' | 'bool';
  readonly rows: number;
  readonly columns: number;
}

const PREFIXES = { float: 'vec', int: 'ivec', uint: 'uvec', bool: 'bvec' } as const;
const BASES = { vec: 'float', ivec: 'int', uvec: 'uint', bvec: 'bool' } as const;

const NUMERICS: ReadonlyMap<GlslType, Numeric> = new Map(allNumerics());

/** The parts of a numeric type; null for structs, samplers, arrays, `void` and unknown types. */
export function numericOf(type: GlslType): Numeric | null {
  return NUMERICS.get(type) ?? null;
}

export function vectorType(base: Numeric['base'], rows: number): GlslType {
  return rows === 1 ? base : `${PREFIXES[base]}${rows}`;
}

/** Type of an element of an array, of a column of a matrix, or of a component of a vector. */
export function elementType(type: GlslType): GlslType {
  if (type.endsWith('[]')) return type.slice(0, -2);
  const numeric = numericOf(type);
  if (numeric === null || (numeric.rows === 1 && numeric.columns === 1)) return '';
  return numeric.columns > 1 ? vectorType('float', numeric.rows) : numeric.base;
}

/** Type of a swizzle such as `v.xzy`; empty if the letters are invalid. */
export function swizzleType(type: GlslType, letters: string): GlslType {
  const numeric = numericOf(type);
  if (numeric === null || numeric.columns > 1 || !/^(?:[xyzw]{1,4}|[rgba]{1,4}|[stpq]{1,4})$/.test(letters)) return '';
  return vectorType(numeric.base, letters.length);
}

/** Whether desktop GLSL converts implicitly (GLSL 4.60 §4.1.10): integers to floats, signed to unsigned. */
export function converts(from: GlslType, to: GlslType): boolean {
  const a = numericOf(from);
  const b = numericOf(to);
  if (a === null || b === null || a.rows !== b.rows || a.columns !== 1 || b.columns !== 1) return false;
  if (b.base === 'float') return a.base === 'int' || a.base === 'uint';
  return b.base === 'uint' && a.base === 'int';
}

/** The float type with the same size. */
export function floatLike(type: GlslType): GlslType {
  const numeric = numericOf(type);
  return numeric === null || numeric.columns > 1 ? type : vectorType('float', numeric.rows);
}

function allNumerics(): [GlslType, Numeric][] {
  const numerics: [GlslType, Numeric][] = [];
  for (const base of Object.values(BASES)) {
    for (const rows of [1, 2, 3, 4]) numerics.push([vectorType(base, rows), { base, rows, columns: 1 }]);
  }
  for (const columns of [2, 3, 4]) {
    for (const rows of [2, 3, 4]) numerics.push([`mat${columns}x${rows}`, { base: 'float', rows, columns }]);
    numerics.push([`mat${columns}`, { base: 'float', rows: columns, columns }]);
  }
  return numerics;
}

/** Whether the type is an image, which can only be passed and read. */
export function isImageType(type: GlslType): boolean {
  return type === 'sampler2D' || type === 'samplerCube';
}

/** The type that GLSL means by a name: `mat2x2` is `mat2`. `sampler2DRect`, which GLSL ES does not have, is read as `sampler2D`. */
export function canonicalType(name: string): GlslType {
  if (name === 'sampler2DRect') return 'sampler2D';
  const square = /^mat([234])x\1$/.exec(name);
  return square === null ? name : `mat${square[1]}`;
}

export function matrixType(columns: number, rows: number): GlslType {
  return columns === rows ? `mat${columns}` : `mat${columns}x${rows}`;
}
