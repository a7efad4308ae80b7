import { EXPRESSION_CLOCK, EXPRESSION_CONSTANTS, EXPRESSION_FUNCTIONS, type ExpressionOperator } from '../../../nodes/kit/expression.ts';
import { MAX_NUMBER } from '../json/shape-reader.ts';
import { getOwn } from '../record.ts';
import { readWords, type Word } from './read-words.ts';

/** Postfix code (`nodes/kit/expression.ts`), one text per number of the expression, or the error. */
export type ParsedExpression =
  | { readonly ok: true; readonly parts: readonly string[] }
  /** `column` counts from 1. */
  | { readonly ok: false; readonly message: string; readonly column: number };

/** Maximum nesting. Deeper expressions occur only in hostile files and would overflow the stack. */
const MAX_NESTING = 64;

/** Precedence of operators; equal ones associate from left to right, powers from right to left. */
const PRECEDENCE: Readonly<Record<ExpressionOperator | '?', number>> = {
  '?': 1,
  '||': 2,
  '&&': 3,
  '==': 4,
  '!=': 4,
  '<': 4,
  '<=': 4,
  '>': 4,
  '>=': 4,
  '+': 5,
  '-': 5,
  '*': 6,
  '/': 6,
  '%': 6,
  '^': 8,
};
const COMPARISON = 4;
/** Precedence of unary signs: below powers, so `-a^2` is `-(a^2)`. */
const SIGN = 7;

/**
 * Parses an expression into postfix code, in linear time.
 *
 * @param count How many numbers the expression gives: one without brackets, several in brackets.
 * @param names Variables that it may read besides the clock.
 * @returns The postfix code, or the message and column of the first error. Never throws.
 *
 * @example
 * parseExpression('1 + sin(time)', 1); // { ok: true, parts: ['1 time sin +'] }
 */
export function parseExpression(text: string, count: number, names: readonly string[] = []): ParsedExpression {
  const read = readWords(text);
  if (!read.ok) {
    // A clause, as all messages of this parser; the diagnostic completes the sentence.
    const unexpected = `“${[...text.slice(read.offset)][0]}” is not expected here`;
    return { ok: false, message: unexpected, column: read.offset + 1 };
  }
  try {
    return { ok: true, parts: parseWords(read.words, count, names) };
  } catch (error) {
    if (!(error instanceof Mistake)) throw error;
    return { ok: false, message: error.message, column: error.offset + 1 };
  }
}

/** An error in an expression, thrown by the parser's functions and caught by `parseExpression`. */
class Mistake extends Error {
  readonly offset: number;
  constructor({ offset }: Word, message: string) {
    super(message);
    this.offset = offset;
  }
}

function parseWords(words: readonly Word[], count: number, names: readonly string[]): string[] {
  let at = 0;
  let nesting = 0;
  let out: string[] = [];
  const next = (): Word => words[at] ?? (words.at(-1) as Word);
  const accept = (sign: string): boolean => {
    const found = next().kind === 'sign' && next().text === sign;
    if (found) at++;
    return found;
  };
  const expectSign = (sign: string, wanted: string): void => {
    if (!accept(sign)) throw new Mistake(next(), `Expected ${wanted} instead of ${shown(next())}`);
  };

  function operand(): void {
    const word = next();
    at++;
    if (word.kind === 'number') out.push(printNumber(word));
    else if (word.kind === 'name') named(word);
    else if (word.text === '-' || word.text === '!') {
      expression(SIGN);
      out.push(word.text === '-' ? 'negate' : '!');
    } else if (word.text === '+') expression(SIGN);
    else if (word.text === '(') {
      expression(1);
      expectSign(')', '“)”');
    } else if (word.text === '[') throw new Mistake(word, listMistake(count));
    else throw new Mistake(word, `Expected a number, a name or a bracket instead of ${shown(word)}`);
  }

  function named(word: Word): void {
    const { text } = word;
    const constant = getOwn<number>(EXPRESSION_CONSTANTS, text);
    const takes = getOwn<readonly string[]>(EXPRESSION_FUNCTIONS, text);
    // A node may have a name of a function, as Remap has `clamp`.
    const isOwn = names.includes(text) && next().text !== '(';
    if (takes && !isOwn) call(word, takes);
    else if (constant !== undefined) out.push(String(constant));
    else if (names.includes(text) || EXPRESSION_CLOCK.some((name) => name === text)) out.push(text);
    else {
      const isCall = next().text === '(';
      const known = isCall ? Object.keys(EXPRESSION_FUNCTIONS) : [...names, ...EXPRESSION_CLOCK, ...Object.keys(EXPRESSION_CONSTANTS)];
      throw new Mistake(word, `Unknown ${isCall ? 'function' : 'name'} “${text}”; use one of ${known.join(', ')}`);
    }
  }

  function call(word: Word, takes: readonly string[]): void {
    const usage = `${word.text}(${takes.join(', ')})`;
    expectSign('(', `the “(” of ${usage}`);
    // `min` and `max` of several values are folded from left to right.
    const ofMany = word.text === 'min' || word.text === 'max';
    let given = 0;
    do {
      expression(1);
      given++;
      if (ofMany && given > 1) out.push(word.text);
      else if (given > takes.length) throw new Mistake(word, `${usage} takes at most ${countOf(takes.length)}`);
    } while (accept(','));
    if (given < takes.length) throw new Mistake(word, `${usage} takes ${countOf(takes.length)} but has ${given}`);
    expectSign(')', `the “)” of ${usage}`);
    if (!ofMany) out.push(POSTFIX_NAMES[word.text] ?? word.text);
  }

  /** Parses operators with at least this precedence. */
  function expression(precedence: number): void {
    if (++nesting > MAX_NESTING) throw new Mistake(next(), `Brackets and operations are nested more than ${MAX_NESTING} deep`);
    operand();
    let compared = false;
    for (;;) {
      const word = next();
      const binds = word.kind === 'sign' ? getOwn<number>(PRECEDENCE, word.text) : undefined;
      if (binds === undefined || binds < precedence) break;
      if (binds === COMPARISON && compared) throw new Mistake(word, 'Two comparisons follow each other; write a < b && b < c');
      compared = binds === COMPARISON;
      at++;
      if (word.text === '?') {
        expression(1);
        expectSign(':', 'the “:” of “? :”');
        expression(1);
        out.push('?:');
      } else {
        expression(word.text === '^' ? SIGN : binds + 1);
        out.push(word.text);
      }
    }
    nesting--;
  }

  const parts: string[] = [];
  const part = () => {
    out = [];
    expression(1);
    parts.push(out.join(' '));
  };
  if (count === 1) part();
  else {
    const first = next();
    if (!accept('[')) throw new Mistake(first, listMistake(count));
    do part();
    while (accept(','));
    expectSign(']', '“]”');
    if (parts.length !== count) throw new Mistake(first, listMistake(count));
  }
  if (next().kind !== 'end') throw new Mistake(next(), `Expected an operator or the end instead of ${shown(next())}`);
  return parts;
}

/** Functions that are written as operators in postfix. */
const POSTFIX_NAMES: Readonly<Record<string, string>> = { pow: '^', mod: '%' };

function printNumber(word: Word): string {
  const number = Number(word.text);
  if (number > MAX_NUMBER) throw new Mistake(word, `${word.text} is too large`);
  return String(number);
}

function countOf(count: number): string {
  return count === 1 ? '1 argument' : `${count} arguments`;
}

function listMistake(count: number): string {
  if (count === 1) return 'Expected one number instead of a list';
  return `Expected ${count} numbers in brackets: [${new Array(count).fill('0').join(', ')}]`;
}

function shown({ kind, text }: Word): string {
  return kind === 'end' ? 'the end' : `“${text}”`;
}
