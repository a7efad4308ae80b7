/**
 * Prints JSON with readable diffs: two spaces, one item per line, except numbers in arrays and values wrapped by `inline`, which stay on
 * one line. Keys keep their order.
 *
 * @throws Error if a number is not finite, which commands and loading prevent.
 *
 * @example
 * printJson({ position: inline({ x: 1, y: 2 }) });
 */
export function printJson(value: PrintableJson): string {
  return `${print(value, '')}\n`;
}

export type PrintableJson = string | number | boolean | readonly PrintableJson[] | Inline | { readonly [key: string]: PrintableJson };

class Inline {
  readonly value: PrintableJson;
  constructor(value: PrintableJson) {
    this.value = value;
  }
}

/** Prints a small value such as a position or a keyframe on one line. */
export function inline(value: PrintableJson): PrintableJson {
  return new Inline(value);
}

function print(value: PrintableJson, indent: string): string {
  if (value instanceof Inline) return printInline(value.value);
  if (typeof value !== 'object') return printScalar(value);
  const inner = `${indent}  `;
  if (isArray(value)) {
    if (value.every((item) => typeof item === 'number')) return printInline(value);
    return `[\n${value.map((item) => inner + print(item, inner)).join(',\n')}\n${indent}]`;
  }
  const entries = Object.entries(value);
  if (entries.length === 0) return '{}';
  return `{\n${entries.map(([key, item]) => `${inner}${JSON.stringify(key)}: ${print(item, inner)}`).join(',\n')}\n${indent}}`;
}

function printInline(value: PrintableJson): string {
  if (value instanceof Inline) return printInline(value.value);
  if (typeof value !== 'object') return printScalar(value);
  if (isArray(value)) return `[${value.map(printInline).join(', ')}]`;
  const entries = Object.entries(value).map(([key, item]) => `${JSON.stringify(key)}: ${printInline(item)}`);
  return entries.length === 0 ? '{}' : `{ ${entries.join(', ')} }`;
}

function printScalar(value: string | number | boolean): string {
  if (typeof value === 'number' && !Number.isFinite(value)) throw new Error(`${value} cannot be saved.`);
  return JSON.stringify(value);
}

/** `Array.isArray` with a type that also narrows readonly arrays. */
function isArray(value: object): value is readonly PrintableJson[] {
  return Array.isArray(value);
}
