import { type Node, type ParseError, parseTree } from 'jsonc-parser';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { Place } from '../syntax/token.ts';
import { repairJson } from './repair-json.ts';

/** The JSON at the top of a shader, and positions in the file. */
export interface Header {
  readonly root: Node;
  place(offset: number): Place;
  error(at: Node | number, message: string, fix?: string): void;
  warn(at: Node | number, message: string, fix?: string): void;
}

export interface HeaderReading {
  readonly header: Header | null;
  readonly diagnostics: Diagnostic[];
}

/** Error code of headers that are only valid JSON after repair. jsonc-parser does not use this code. */
const LOOSE_JSON = 100;

/** Messages for errors that do not prevent reading: 25 of the 321 public ISF files have one. Keyed by the codes of jsonc-parser. */
const HARMLESS: ReadonlyMap<number, string> = new Map([
  [3, 'Expected a name here'],
  [4, 'Expected a value here'],
  [6, 'Expected a comma here'],
  [9, 'Text follows the JSON'],
  [15, 'JSON does not know this escape, such as "\\n"'],
  [16, 'A text contains a line break or another control character'],
  [LOOSE_JSON, 'This is not valid JSON'],
]);

const BROKEN: ReadonlyMap<number, string> = new Map([
  [1, 'This is not a JSON value: text needs double quotes'],
  [2, 'This is not a number'],
  [5, 'Expected “:” here'],
  [7, 'Expected “}” here'],
  [8, 'Expected “]” here'],
  [11, 'A comment is not closed'],
  [12, 'The closing quote of a text is missing'],
  [13, 'This number is not complete'],
  [14, 'This "\\u" escape is not complete'],
]);

const UNCLOSED_TEXT = 12;
const CONTROL_CHARACTER = 16;
const TRAILING_TEXT = 9;
const MISSING_BRACE = 7;
const MISSING_BRACKET = 8;

const MAX_DEPTH = 100;

const SYNTAX_FIX = 'Write the header as a JSON object in the first comment of the file: { "ISFVSN": "2", "INPUTS": [ … ] }.';

/** Finds and reads the header. `header` is null if it cannot be read; `diagnostics` grows while the header is used. */
export function readHeader(source: string, file: string): HeaderReading {
  const diagnostics: Diagnostic[] = [];
  const place = createPlaces(source);

  function report(severity: 'error' | 'warning', at: Node | number, message: string, fix?: string): void {
    const { line, column } = place(typeof at === 'number' ? at : at.offset);
    diagnostics.push({ code: 'SCR040', severity, message, file, line, column, ...(fix === undefined ? {} : { fix }) });
  }

  const open = findHeader(source);
  if (open < 0) {
    if (isUtf16(source)) report('error', 0, 'The file is encoded in UTF-16, which GLSL does not allow.', 'Save it as UTF-8.');
    else report('error', 0, 'The shader has no header.', SYNTAX_FIX);
    return { header: null, diagnostics };
  }
  const close = source.indexOf('*/', open + 2);
  if (close < 0) {
    report('error', open, 'The header comment is not closed with “*/”.');
    return { header: null, diagnostics };
  }
  const start = open + 2;
  const text = source.slice(start, close);
  if (!isShallow(text)) {
    report('error', start, 'The header is nested too deeply.', SYNTAX_FIX);
    return { header: null, diagnostics };
  }
  const { root, errors } = parseLeniently(text);
  const [first] = errors;
  if (root === undefined || root.type !== 'object' || errors.some(isFatal)) {
    const what =
      first === undefined ? 'The first comment of the file is not a JSON object' : (BROKEN.get(first.error) ?? HARMLESS.get(first.error));
    const offset = first?.offset ?? Math.max(text.search(/\S/), 0);
    report('error', start + offset, `${what ?? 'The JSON is not well formed'}, so the header cannot be read.`, SYNTAX_FIX);
    return { header: null, diagnostics };
  }
  for (const error of errors) {
    report('warning', start + error.offset, `${HARMLESS.get(error.error)}. Scrim reads the header anyway; other programs may reject it.`);
  }
  return {
    header: {
      root: moved(root, (offset) => offset + start),
      place,
      error: (...args) => report('error', ...args),
      warn: (...args) => report('warning', ...args),
    },
    diagnostics,
  };
}

/** Value of an own key; the last one if the key is duplicate, as in JSON. */
export function property(object: Node | undefined, key: string): Node | undefined {
  return object?.type === 'object'
    ? object.children?.filter((child) => child.children?.[0]?.value === key).at(-1)?.children?.[1]
    : undefined;
}

export function entries(object: Node): readonly (readonly [key: Node, value: Node])[] {
  const pairs: (readonly [Node, Node])[] = [];
  for (const child of object.children ?? []) {
    const [key, value] = child.children ?? [];
    if (key !== undefined && value !== undefined) pairs.push([key, value]);
  }
  return pairs;
}

export function items(array: Node | undefined): readonly Node[] {
  return array?.type === 'array' ? (array.children ?? []) : [];
}

export function textOf(node: Node | undefined): string | null {
  return node?.type === 'string' ? (node.value as string) : null;
}

/**
 * The value of a number, of a number in quotes, or of a boolean as 0 or 1: published headers contain all three; null for anything else and
 * for values that are not finite.
 */
export function numberOf(node: Node | undefined): number | null {
  if (node?.type === 'boolean') return node.value === true ? 1 : 0;
  if (node?.type === 'string' && /^\s*[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?\s*$/.test(node.value as string))
    return finite(Number(node.value));
  return node?.type === 'number' ? finite(node.value as number) : null;
}

/** True for `true`, for numbers other than 0, and for the texts "true", "yes" and "1" in any case. */
export function flagOf(node: Node | undefined): boolean {
  if (node?.type === 'string') return /^\s*(true|yes|1)\s*$/i.test(node.value as string);
  return node?.type === 'boolean' ? node.value === true : (numberOf(node) ?? 0) !== 0;
}

function finite(value: number): number | null {
  return Number.isFinite(value) ? value : null;
}

/**
 * Whether a source is UTF-16 text that was read as UTF-8: one of the two bytes of ASCII characters is 0, so there are NUL characters
 * between the letters.
 */
function isUtf16(source: string): boolean {
  const start = source.slice(0, 1000);
  return start.split('\0').length - 1 > start.length / 4;
}

/** Offset of the header: the first comment that starts with a brace, because a license may come first. */
export function findHeader(source: string): number {
  const brace = /\/\*\s*\{/.exec(source);
  return brace?.index ?? source.indexOf('/*');
}

/**
 * Parses a header. If quotes are not closed on their line, a second attempt replaces line breaks in quotes by spaces, which keeps the
 * offsets; for other errors, the second attempt repairs the JSON.
 */
function parseLeniently(text: string): { root: Node | undefined; errors: readonly Mistake[] } {
  const strict = parseOnce(text);
  const fatal = strict.errors.find(isFatal);
  if (fatal === undefined) return strict;
  if (fatal.error !== UNCLOSED_TEXT) return parseRepaired(text, fatal) ?? strict;
  const joined = text.replace(/"(?:[^"\\]|\\[\s\S])*"/g, (quoted) => quoted.replace(/[\r\n]/g, ' '));
  if (!isShallow(joined)) return strict;
  const lenient = parseOnce(joined);
  if (lenient.errors.some(isFatal)) return strict;
  return { root: lenient.root, errors: [{ ...fatal, error: CONTROL_CHARACTER }, ...lenient.errors] };
}

/** An error of jsonc-parser, with its own code for text after the header. */
interface Mistake {
  readonly error: number;
  readonly offset: number;
}

/**
 * Repairs a header and parses the result; null if that fails. Only the error that made the repair necessary is reported, as `LOOSE_JSON`.
 */
function parseRepaired(text: string, fatal: Mistake): { root: Node | undefined; errors: readonly Mistake[] } | null {
  const repaired = repairJson(text);
  if (repaired === null || !isShallow(repaired.text)) return null;
  const { root, errors } = parseOnce(repaired.text);
  if (root?.type !== 'object' || errors.some(isFatal)) return null;
  const at = (offset: number): number => repaired.offsets[offset] ?? text.length;
  return { root: moved(root, at), errors: [{ ...fatal, error: LOOSE_JSON }] };
}

function moved(node: Node, at: (offset: number) => number): Node {
  return { ...node, offset: at(node.offset), ...(node.children ? { children: node.children.map((child) => moved(child, at)) } : {}) };
}

/** Parses a header once. All errors behind its object count as one harmless error. */
function parseOnce(text: string): { root: Node | undefined; errors: readonly ParseError[] } {
  const errors: ParseError[] = [];
  const root = parseTree(text, errors, { allowTrailingComma: true });
  const end = root === undefined ? text.length : root.offset + root.length;
  const behind = errors.find((error) => error.offset >= end);
  const inside = errors.filter((error) => error.offset < end);
  const isOpen = errors.some((error) => error.error === MISSING_BRACE || error.error === MISSING_BRACKET);
  if (behind === undefined || root?.type !== 'object' || isOpen) return { root, errors };
  return { root, errors: [...inside, ...(inside.some(isFatal) ? [] : [{ ...behind, error: TRAILING_TEXT }])] };
}

function isFatal(error: Mistake): boolean {
  return !HARMLESS.has(error.error);
}

/** Whether the nesting of a header is at most `MAX_DEPTH`, because the JSON parser is recursive. */
function isShallow(text: string): boolean {
  let depth = 0;
  for (const [piece] of text.matchAll(/"(?:[^"\\\r\n]|\\.)*"?|[[\]{}]/g)) {
    if (piece === '{' || piece === '[') depth += 1;
    if (piece === '}' || piece === ']') depth -= 1;
    if (depth > MAX_DEPTH) return false;
  }
  return true;
}

/** Line and column of an offset, both from 1; line ends are located once. */
function createPlaces(source: string): (offset: number) => Place {
  const starts = [0];
  for (const lineBreak of source.matchAll(/\r\n|\r|\n/g)) starts.push(lineBreak.index + lineBreak[0].length);
  return (offset) => {
    let low = 0;
    let high = starts.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if ((starts[middle] ?? 0) <= offset) low = middle;
      else high = middle - 1;
    }
    return { line: low + 1, column: offset - (starts[low] ?? 0) + 1 };
  };
}
