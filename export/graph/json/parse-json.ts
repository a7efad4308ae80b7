import { createScanner, type ParseError, parse, printParseErrorCode } from 'jsonc-parser';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { positionOf } from './positions.ts';

/** Maximum length of a JSON text: that of one message of the host, far above any real project. */
export const MAX_JSON_CHARACTERS = 64 * 2 ** 20;

export type ParsedJson = { readonly ok: true; readonly value: unknown } | { readonly ok: false; readonly diagnostic: Diagnostic };

/**
 * Parses strict JSON. Errors: SCR001 for a syntax error, with line and column; SCR005 if the text is too large; SCR006 for `NaN` and
 * `Infinity`; SCR002 for a duplicate key, of which JSON would silently drop the first.
 */
export function parseJson(text: string, file: string): ParsedJson {
  if (text.length > MAX_JSON_CHARACTERS) {
    const mebibytes = (characters: number) => Math.round(characters / 2 ** 20);
    const message = `${file} has ${mebibytes(text.length)} MiB; Scrim reads up to ${mebibytes(MAX_JSON_CHARACTERS)} MiB.`;
    return { ok: false, diagnostic: { code: 'SCR005', severity: 'error', file, message } };
  }
  // A byte order mark is not part of JSON, but some editors write one.
  const json = text.startsWith('\uFEFF') ? ` ${text.slice(1)}` : text;
  let value: unknown;
  try {
    value = JSON.parse(json);
  } catch {
    return { ok: false, diagnostic: syntaxError(json, file) };
  }
  const twice = findDuplicateKey(json);
  if (twice === null) return { ok: true, value };
  const message = `The key ${JSON.stringify(twice.key)} occurs twice in the same object. Remove one of the two.`;
  return { ok: false, diagnostic: { code: 'SCR002', severity: 'error', file, ...positionOf(json, twice.offset), message } };
}

function syntaxError(text: string, file: string): Diagnostic {
  if (text.trim() === '') {
    const fix = 'Restore the file from a backup or from version control.';
    return { code: 'SCR001', severity: 'error', file, line: 1, column: 1, message: `${file} is empty.`, fix };
  }
  const error = firstError(text);
  if (error === null) return { code: 'SCR001', severity: 'error', file, message: 'The file is not JSON.' };
  const place = { severity: 'error', file, ...positionOf(text, error.offset) } as const;
  const number = /^[-+]?(?:NaN|Infinity)\b/i.exec(text.slice(error.offset, error.offset + 16));
  if (number) return { code: 'SCR006', ...place, message: `${number[0]} is not a finite number. Write a finite one.` };
  return { code: 'SCR001', ...place, message: `${WORDS[printParseErrorCode(error.error)] ?? 'An unexpected character is'} here.` };
}

/** Locates the error, because messages of `JSON.parse` differ between engines. */
function firstError(text: string): ParseError | null {
  const errors: ParseError[] = [];
  try {
    parse(text, errors, { disallowComments: true, allowTrailingComma: false });
  } catch (error) {
    if (!(error instanceof RangeError)) throw error;
  }
  return errors[0] ?? null;
}

const WORDS: Readonly<Record<string, string>> = {
  InvalidSymbol: 'An unknown word is',
  InvalidNumberFormat: 'An invalid number is',
  PropertyNameExpected: 'A key in double quotes is missing',
  ValueExpected: 'A value is missing',
  ColonExpected: 'A colon is missing',
  CommaExpected: 'A comma is missing',
  CloseBraceExpected: 'A closing brace is missing',
  CloseBracketExpected: 'A closing bracket is missing',
  EndOfFileExpected: 'Expected the end of the document',
  InvalidCommentToken: 'JSON does not allow the comment',
  UnexpectedEndOfComment: 'JSON does not allow the comment',
  UnexpectedEndOfString: 'A text without its closing quote begins',
  UnexpectedEndOfNumber: 'An invalid number is',
  InvalidUnicode: 'An invalid \\u escape is',
  InvalidEscapeCharacter: 'A text with an unknown escape begins',
  InvalidCharacter: 'A text with a control character in it begins',
};

/** Finds a key that occurs twice in an object; null if there is none. It uses its own stack, so the nesting is not limited. */
function findDuplicateKey(text: string): { readonly key: string; readonly offset: number } | null {
  const scanner = createScanner(text, true);
  const open: (Set<string> | null)[] = [];
  let key = '';
  let offset = 0;
  while (true) {
    scanner.scan();
    const start = scanner.getTokenOffset();
    if (start >= text.length) return null;
    const first = text[start];
    if (first === '{') open.push(new Set());
    else if (first === '[') open.push(null);
    else if (first === '}' || first === ']') open.pop();
    else if (first === '"') {
      key = scanner.getTokenValue();
      offset = start;
    } else if (first === ':') {
      const keys = open.at(-1);
      if (keys?.has(key)) return { key, offset };
      keys?.add(key);
    }
  }
}
