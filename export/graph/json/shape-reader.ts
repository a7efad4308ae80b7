import { getOwn } from '../record.ts';
import type { JsonPath } from './positions.ts';

/** A mistake in the shape of a document. */
export interface ShapeProblem {
  readonly code: 'SCR002' | 'SCR006';
  readonly path: JsonPath;
  /** Whether the key or the value at `path` is invalid. */
  readonly of: 'key' | 'value';
  readonly message: string;
}

/** Maximum number of problems to report. */
const MAX_PROBLEMS = 50;

/** Largest 32-bit float; larger uniforms would be infinite in a shader. */
export const MAX_NUMBER = 3.4028234663852886e38;

/**
 * Reads parsed JSON field by field. An invalid value is added to `problems` and read as an empty one, so that one pass finds all problems;
 * the caller discards the result if there are any. The recursion follows the schema, so its depth is limited.
 */
export interface ShapeReader {
  readonly problems: readonly ShapeProblem[];
  problem(path: JsonPath, message: string, of?: 'key' | 'value'): void;
  /** Reads an object that may have no other keys than these. */
  fields(value: unknown, path: JsonPath, keys: readonly string[]): Fields;
  /** Reads an object with arbitrary names as keys, which must match `names`. */
  record<T>(value: unknown, path: JsonPath, names: NameRule, item: (value: unknown, path: JsonPath) => T): Record<string, T>;
  list<T>(value: unknown, path: JsonPath, item: (value: unknown, path: JsonPath) => T): T[];
  text(value: unknown, path: JsonPath): string;
  number(value: unknown, path: JsonPath): number;
  flag(value: unknown, path: JsonPath): boolean;
  oneOf<T extends string>(value: unknown, path: JsonPath, words: readonly [T, ...T[]]): T;
  name(value: unknown, path: JsonPath, rule: NameRule): string;
}

export interface NameRule {
  readonly is: (text: string) => boolean;
  /** The rule as a sentence for the message. */
  readonly words: string;
}

/** Returns a field by name, or undefined if the file does not have it. */
export type Fields = (key: string) => unknown;

const NO_FIELDS: Fields = () => undefined;

export function createShapeReader(): ShapeReader {
  const problems: ShapeProblem[] = [];

  const problem = (path: JsonPath, message: string, of: 'key' | 'value' = 'value', code: ShapeProblem['code'] = 'SCR002') => {
    if (problems.length < MAX_PROBLEMS) problems.push({ code, path, of, message: `${printPath(path)}: ${message}` });
  };

  const wrongKind = (value: unknown, path: JsonPath, wanted: string) =>
    problem(path, value === undefined ? `${wanted} is missing.` : `this must be ${wanted}, but it is ${describe(value)}.`);

  const reader: ShapeReader = {
    problems,
    problem: (path, message, of) => problem(path, message, of),

    fields: (value, path, keys) => {
      if (!isObject(value)) {
        wrongKind(value, path, 'an object');
        return NO_FIELDS;
      }
      for (const key of Object.keys(value)) {
        if (!keys.includes(key)) problem([...path, key], `this key is unknown; known keys are ${keys.join(', ')}. Remove it.`, 'key');
      }
      return (key) => getOwn(value, key);
    },

    record: <T>(value: unknown, path: JsonPath, names: NameRule, item: (value: unknown, path: JsonPath) => T) => {
      const result: Record<string, T> = {};
      if (value === undefined) return result;
      if (!isObject(value)) {
        wrongKind(value, path, 'an object');
        return result;
      }
      for (const [key, entry] of Object.entries(value)) {
        const entryPath = [...path, key];
        if (names.is(key)) result[key] = item(entry, entryPath);
        else problem(entryPath, names.words, 'key');
      }
      return result;
    },

    list: <T>(value: unknown, path: JsonPath, item: (value: unknown, path: JsonPath) => T) => {
      if (value === undefined) return [];
      if (!Array.isArray(value)) {
        wrongKind(value, path, 'a list');
        return [];
      }
      return value.map((entry, index) => item(entry, [...path, index]));
    },

    text: (value, path) => {
      if (typeof value === 'string') return value;
      wrongKind(value, path, 'a text');
      return '';
    },

    number: (value, path) => {
      if (typeof value !== 'number') {
        wrongKind(value, path, 'a number');
        return 0;
      }
      if (Math.abs(value) <= MAX_NUMBER) return value === 0 ? 0 : value;
      problem(path, 'this number is too large for a 32-bit float. Write a finite one.', 'value', 'SCR006');
      return 0;
    },

    flag: (value, path) => {
      if (typeof value === 'boolean') return value;
      wrongKind(value, path, 'true or false');
      return false;
    },

    oneOf: <T extends string>(value: unknown, path: JsonPath, words: readonly [T, ...T[]]) => {
      const found = words.find((word) => word === value);
      if (found === undefined) problem(path, `this must be one of ${words.join(', ')}.`);
      return found ?? words[0];
    },

    name: (value, path, rule) => {
      const text = reader.text(value, path);
      if (typeof value === 'string' && !rule.is(text)) problem(path, rule.words);
      return text;
    },
  };
  return reader;
}

export function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

/** Prints a path: `graphs.main.nodes["a b"].type`. */
export function printPath(path: JsonPath): string {
  if (path.length === 0) return 'The document';
  return path
    .map((part, index) => {
      if (typeof part === 'number') return `[${part}]`;
      const plain = /^[A-Za-z_][A-Za-z0-9_-]*$/.test(part);
      return plain ? `${index === 0 ? '' : '.'}${part}` : `[${JSON.stringify(part.slice(0, 80))}]`;
    })
    .join('');
}

function describe(value: unknown): string {
  if (value === null) return 'null';
  if (Array.isArray(value)) return 'a list';
  if (typeof value === 'object') return 'an object';
  return typeof value === 'string' ? 'a text' : typeof value === 'boolean' ? 'true or false' : 'a number';
}
