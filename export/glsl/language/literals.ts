import { items, property, readHeader, textOf } from '../isf/isf-header.ts';
import type { Place, Token } from '../syntax/token.ts';
import type { Outline } from './shader-name.ts';
import { lexLeniently, rangeOf, type TextRange, touches } from './source-text.ts';

export type Color = readonly [red: number, green: number, blue: number, alpha: number];

/** A color in the text. Components from 0 to 1, as written. */
export interface ColorLiteral {
  readonly range: TextRange;
  readonly color: Color;
  /** False for `vec3` and lists of three numbers. */
  readonly hasAlpha: boolean;
  /** How the color is written: `call` for `vec3(…)` or `vec4(…)`, `list` for a list in the header. */
  readonly form: 'call' | 'list';
}

export interface NumberLiteral {
  /** Includes its sign, if it has one. */
  readonly range: TextRange;
  readonly value: number;
  readonly isInt: boolean;
  /** Number of decimal digits. */
  readonly decimals: number;
}

/**
 * Colors in a text: `vec3` and `vec4` of literals, such as `vec3(0.2, 0.4, 1.0)`, and the DEFAULT of color inputs. All components are
 * between 0 and 1.
 */
export function colorsOf(source: string, outline: Pick<Outline, 'tokens'> = { tokens: lexLeniently(source) }): readonly ColorLiteral[] {
  const found: ColorLiteral[] = [...headerColors(source)];
  const { tokens } = outline;
  tokens.forEach((token, i) => {
    const size = token.text === 'vec3' ? 3 : token.text === 'vec4' ? 4 : 0;
    if (size === 0 || tokens[i + 1]?.text !== '(') return;
    const numbers: number[] = [];
    let at = i + 2;
    for (; tokens[at] !== undefined; at += 2) {
      const value = unitValue(tokens[at] as Token);
      if (value === null) return;
      numbers.push(value);
      if (tokens[at + 1]?.text !== ',') break;
    }
    const close = tokens[at + 1];
    if (close?.text !== ')') return;
    const color = colorOf(numbers.length === 1 ? new Array<number>(size).fill(numbers[0] ?? 0) : numbers);
    if (color === null || (numbers.length !== 1 && numbers.length !== size)) return;
    found.push({ range: { start: rangeOf(token).start, end: rangeOf(close).end }, color, hasAlpha: size === 4, form: 'call' });
  });
  return found;
}

function headerColors(source: string): ColorLiteral[] {
  const { header } = readHeader(source, '');
  if (header === null) return [];
  return items(property(header.root, 'INPUTS')).flatMap((input): ColorLiteral[] => {
    const list = property(input, 'DEFAULT');
    if (textOf(property(input, 'TYPE')) !== 'color' || list?.type !== 'array') return [];
    const numbers = items(list).map(({ value }) => (typeof value === 'number' && value >= 0 && value <= 1 ? value : Number.NaN));
    const color = numbers.some(Number.isNaN) ? null : colorOf(numbers);
    const range = { start: header.place(list.offset), end: header.place(list.offset + list.length) };
    return color === null ? [] : [{ range, color, hasAlpha: numbers.length === 4, form: 'list' }];
  });
}

function colorOf(numbers: readonly number[]): Color | null {
  const [red, green, blue, alpha = 1] = numbers;
  return red === undefined || green === undefined || blue === undefined || numbers.length > 4 ? null : [red, green, blue, alpha];
}

function unitValue({ kind, text }: Token): number | null {
  const value = kind === 'float' || kind === 'int' ? Number.parseFloat(text) : Number.NaN;
  return value >= 0 && value <= 1 ? value : null;
}

/** Prints a color in the form of the literal that it replaces. */
export function printColor({ form, hasAlpha }: Pick<ColorLiteral, 'form' | 'hasAlpha'>, color: Color): string {
  const numbers = (hasAlpha ? color : color.slice(0, 3)).map((value) => printNumber(value, 3)).join(', ');
  return form === 'list' ? `[${numbers}]` : `vec${hasAlpha ? 4 : 3}(${numbers})`;
}

/** Prints a number, always with a decimal point, because GLSL would read an integer without one. */
function printNumber(value: number, decimals: number): string {
  const text = value.toFixed(decimals).replace(/0+$/, '');
  return text.endsWith('.') ? `${text}0` : text;
}

/** The number at a position in the GLSL, with a minus if that can only be its sign. */
export function numberAt(
  source: string,
  place: Place,
  outline: Pick<Outline, 'tokens'> = { tokens: lexLeniently(source) },
): NumberLiteral | null {
  const { tokens } = outline;
  const index = tokens.findIndex((token) => (token.kind === 'float' || token.kind === 'int') && touches(rangeOf(token), place));
  const token = tokens[index];
  if (token === undefined || /^0[xX]/.test(token.text) || /[eE]/.test(token.text)) return null;
  const sign = tokens[index - 1];
  const beforeSign = tokens[index - 2];
  const operand =
    beforeSign !== undefined && (['word', 'int', 'uint', 'float'].includes(beforeSign.kind) || [')', ']'].includes(beforeSign.text));
  const negative = sign?.text === '-' && sign.line === token.line && !(operand && beforeSign?.text !== 'return');
  const value = Number.parseFloat(token.text) * (negative ? -1 : 1);
  const start = negative && sign ? rangeOf(sign).start : rangeOf(token).start;
  const decimals = /\.(\d*)/.exec(token.text)?.[1]?.length ?? 0;
  return { range: { start, end: rangeOf(token).end }, value, isInt: token.kind === 'int', decimals };
}

/** Prints a value in place of a literal, with as many decimal digits as `step` needs, and at least as many as the literal had. */
export function printLiteral({ isInt, decimals }: Pick<NumberLiteral, 'isInt' | 'decimals'>, value: number, step: number): string {
  if (isInt) return String(Math.round(value));
  const digits = Math.max(decimals, Math.ceil(-Math.log10(step)), 1);
  const text = value.toFixed(Math.min(digits, 8));
  return Number(text) === 0 ? text.replace('-', '') : text;
}

/** Step for dragging a number: a hundredth of the largest power of ten up to its magnitude, at least 0.01; 1 for integers. */
export function stepOf({ value, isInt }: Pick<NumberLiteral, 'value' | 'isInt'>): number {
  if (isInt) return 1;
  const size = Math.max(Math.abs(value), 0.1);
  return 10 ** (Math.floor(Math.log10(size)) - 2 + (size >= 1 ? 0 : 1));
}

/**
 * Range of a slider for a number: from 0 (for negative numbers, from minus the limit) to the limit. The limit is 1 for magnitudes up to 1;
 * above, it is a power of ten, or twice one, and at least twice the magnitude. For integers it is at least 10.
 */
export function rangeOfSlider({ value, isInt }: Pick<NumberLiteral, 'value' | 'isInt'>): { readonly min: number; readonly max: number } {
  const size = Math.abs(value);
  const reach = size <= 1 ? 1 : 10 ** Math.ceil(Math.log10(size)) * (size * 2 <= 10 ** Math.ceil(Math.log10(size)) ? 1 : 2);
  const max = isInt ? Math.max(Math.round(reach), 10) : reach;
  return { min: value < 0 ? -max : 0, max };
}
