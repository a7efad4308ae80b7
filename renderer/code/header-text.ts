import type { HeaderFields, HeaderValue } from '../../export/glsl/language/header-edits.ts';

/** A header value as text; lists are separated by commas. */
export function textOfField(fields: HeaderFields, key: string): string {
  const value = fields[key];
  if (value === undefined) return '';
  return isList(value) ? value.join(', ') : String(value);
}

function isList(value: HeaderFields[string]): value is readonly (string | number)[] {
  return Array.isArray(value);
}

/**
 * Parses MIN, MAX or DEFAULT.
 *
 * @returns A number, a list of numbers, undefined for empty text (removes the key), or null if invalid.
 */
export function numbersOf(text: string): HeaderValue | undefined | null {
  const parts = text.split(/[\s,;]+/).filter(Boolean);
  if (parts.length === 0) return undefined;
  const numbers = parts.map(Number);
  if (numbers.some((number) => !Number.isFinite(number))) return null;
  const [first] = numbers;
  return numbers.length === 1 && first !== undefined ? first : numbers;
}

/**
 * Parses `Blur, Soft`.
 *
 * @returns A list, or undefined for empty text (removes the key).
 */
export function wordsOf(text: string): readonly string[] | undefined {
  const words = text
    .split(',')
    .map((word) => word.trim())
    .filter(Boolean);
  return words.length === 0 ? undefined : words;
}

/** Parses the width or height of a pass: a number or an expression. */
export function sizeOf(text: string): HeaderValue | undefined {
  const trimmed = text.trim();
  if (trimmed === '') return undefined;
  return Number.isFinite(Number(trimmed)) ? Number(trimmed) : trimmed;
}

/** A name that no input has: `value`, `value2`, … */
export function freeInputName(stem: string, taken: readonly string[]): string {
  for (let number = 1; ; number += 1) {
    const name = number === 1 ? stem : `${stem}${number}`;
    if (!taken.includes(name)) return name;
  }
}

/** Fields of a new input. */
export function newInput(type: string, taken: readonly string[]): HeaderFields {
  switch (type) {
    case 'float':
      return { NAME: freeInputName('amount', taken), TYPE: type, LABEL: 'Amount', MIN: 0, MAX: 1, DEFAULT: 0.5 };
    case 'long':
      return { NAME: freeInputName('choice', taken), TYPE: type, LABEL: 'Choice', VALUES: [0, 1], LABELS: ['First', 'Second'], DEFAULT: 0 };
    case 'bool':
      return { NAME: freeInputName('on', taken), TYPE: type, LABEL: 'On', DEFAULT: true };
    case 'color':
      return { NAME: freeInputName('tint', taken), TYPE: type, LABEL: 'Tint', DEFAULT: [1, 0.5, 0.25, 1] };
    case 'point2D':
      return { NAME: freeInputName('place', taken), TYPE: type, LABEL: 'Place', MIN: [0, 0], MAX: [1, 1], DEFAULT: [0.5, 0.5] };
    case 'curve':
      return { NAME: freeInputName('curve', taken), TYPE: type, LABEL: 'Curve' };
    case 'gradient':
      return { NAME: freeInputName('gradient', taken), TYPE: type, LABEL: 'Gradient' };
    default:
      return { NAME: freeInputName(type === 'image' ? 'inputImage' : type, taken), TYPE: type };
  }
}
