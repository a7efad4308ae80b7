import type { Diagnostic, Result } from '../../../nodes/kit/diagnostics.ts';

/** A color table from a .cube file (Adobe, Cube LUT Specification 1.0). */
export interface CubeTable {
  readonly kind: '1D' | '3D';
  /** Entries along each axis. */
  readonly size: number;
  /** Red, green and blue of every entry; red of the input varies fastest. */
  readonly values: Float32Array;
  /** Inputs of the first and of the last entry, per channel. */
  readonly domainMin: readonly number[];
  readonly domainMax: readonly number[];
}

/** Maximum sizes, by textures of devices and reading time. */
const MAX_SIZE: Readonly<Record<CubeTable['kind'], number>> = { '1D': 65_536, '3D': 129 };

class CubeFault extends Error {
  readonly line: number;
  readonly column: number;

  constructor(line: number, column: number, message: string) {
    super(message);
    this.line = line;
    this.column = column;
  }
}

/** Reads a .cube file. Mistakes are SCR032 with line and column; unknown keywords are ignored. */
export function readCube(text: string, file: string): Result<CubeTable> {
  try {
    return { output: parse(text), diagnostics: [] };
  } catch (fault) {
    if (!(fault instanceof CubeFault)) throw fault;
    const { line, column, message } = fault;
    const diagnostic: Diagnostic = {
      code: 'SCR032',
      severity: 'error',
      file,
      line,
      column,
      message,
      fix: 'Export the table again, as .cube.',
    };
    return { output: null, diagnostics: [diagnostic] };
  }
}

function parse(text: string): CubeTable {
  let shape: { readonly kind: CubeTable['kind']; readonly size: number; readonly values: Float32Array } | null = null;
  let filled = 0;
  let domainMin: readonly number[] = [0, 0, 0];
  let domainMax: readonly number[] = [1, 1, 1];
  const lines = text.split(/\r\n|\r|\n/);
  for (const [index, whole] of lines.entries()) {
    const line = index + 1;
    const content = whole.replace(/#.*/, '').trimEnd();
    const word = /^\s*([A-Za-z_]\w*)/.exec(content)?.[1];
    if (content.trim() === '') continue;
    if (word === undefined) {
      if (shape === null) throw new CubeFault(line, 1, 'Numbers come before LUT_3D_SIZE or LUT_1D_SIZE.');
      if (filled >= shape.values.length) throw new CubeFault(line, 1, `There are more than ${shape.values.length / 3} entries.`);
      shape.values.set(numbers(content, line, 3), filled);
      filled += 3;
    } else if (word === 'LUT_3D_SIZE' || word === 'LUT_1D_SIZE') {
      if (shape !== null) throw new CubeFault(line, 1, 'The file has two sizes.');
      shape = shapeOf(word === 'LUT_3D_SIZE' ? '3D' : '1D', content, line);
    } else if (word === 'DOMAIN_MIN') domainMin = numbers(content, line, 3);
    else if (word === 'DOMAIN_MAX') domainMax = numbers(content, line, 3);
    else if (word === 'LUT_3D_INPUT_RANGE' || word === 'LUT_1D_INPUT_RANGE') {
      const [low = 0, high = 1] = numbers(content, line, 2);
      domainMin = [low, low, low];
      domainMax = [high, high, high];
    }
  }
  if (shape === null) throw new CubeFault(1, 1, 'This is no .cube file: LUT_3D_SIZE and LUT_1D_SIZE are missing.');
  if (filled < shape.values.length) {
    const message = `The table has ${filled / 3} entries, but its size requires ${shape.values.length / 3}.`;
    throw new CubeFault(lines.length, 1, message);
  }
  if (domainMin.some((low, i) => !(low < (domainMax[i] ?? low)))) throw new CubeFault(1, 1, 'DOMAIN_MIN is not below DOMAIN_MAX.');
  return { ...shape, domainMin, domainMax };
}

function shapeOf(kind: CubeTable['kind'], content: string, line: number) {
  const [size = 0] = numbers(content, line, 1);
  if (!Number.isInteger(size) || size < 2 || size > MAX_SIZE[kind]) {
    throw new CubeFault(line, content.search(/\S+$/) + 1, `The size must be a whole number from 2 to ${MAX_SIZE[kind]}.`);
  }
  return { kind, size, values: new Float32Array(3 * (kind === '3D' ? size ** 3 : size)) };
}

/** The numbers of a line after its keyword. */
function numbers(content: string, line: number, count: number): number[] {
  const words = [...content.matchAll(/\S+/g)].filter(({ 0: word }, i) => i > 0 || !/^[A-Za-z_]/.test(word));
  const values = words.map(({ 0: word, index }) => {
    const value = Number(word);
    if (!Number.isFinite(value)) throw new CubeFault(line, index + 1, `“${word}” is not a number.`);
    return value;
  });
  if (values.length !== count) throw new CubeFault(line, 1, `The line has ${values.length} numbers instead of ${count}.`);
  return values;
}
