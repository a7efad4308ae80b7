import { GlslError, type Token } from './token.ts';
import { KEYWORDS } from './words.ts';

/** Maximum nesting, which protects the stack of recursive walks. */
const MAX_DEPTH = 250;

/** A position in the tokens of a source, shared by the parser's functions. */
export interface Cursor {
  /** The token `ahead` places on; the end token after the last. */
  peek(ahead?: number): Token;
  next(): Token;
  at(text: string): boolean;
  /** Consumes the token if it is `text`. */
  accept(text: string): Token | null;
  /** Consumes `text`, or throws with its context: “after the condition”. */
  expect(text: string, where: string): Token;
  /** Consumes a word that can be a name. `what` describes what is named. */
  name(what: string): Token;
  unexpected(wanted: string): GlslError;
  /** Runs `parse` one level deeper; throws if the nesting is too deep. */
  nested<T>(parse: () => T): T;
}

export function createCursor(tokens: readonly Token[]): Cursor {
  const last = tokens.at(-1);
  if (last?.kind !== 'end') throw new Error('The tokens of a source end with an end token.');
  const end = last;
  let position = 0;
  let depth = 0;

  function peek(ahead = 0): Token {
    return tokens[position + ahead] ?? end;
  }

  function next(): Token {
    const token = peek();
    position += 1;
    return token;
  }

  function at(text: string): boolean {
    return peek().text === text;
  }

  function unexpected(wanted: string): GlslError {
    const token = peek();
    const before = tokens[position - 1];
    if (token.kind === 'bad') {
      return new GlslError(token, `The character "${token.text}" is not allowed in GLSL outside of comments.`);
    }
    const found = token.kind === 'end' ? 'the file ends' : `"${token.text}" follows`;
    // An error at the end of a line is reported there, not at the next token on another line.
    const place =
      before !== undefined && before.line < token.line ? { line: before.line, column: before.column + before.text.length } : token;
    return new GlslError(place, `${wanted}, but ${found}.`);
  }

  return {
    peek,
    next,
    at,
    accept: (text) => (at(text) && peek().kind !== 'end' ? next() : null),
    expect: (text, where) => {
      if (!at(text) || peek().kind === 'end') throw unexpected(`"${text}" is missing ${where}`);
      return next();
    },
    name: (what) => {
      const token = peek();
      if (token.kind !== 'word') throw unexpected(`A name for ${what} is missing`);
      if (KEYWORDS.has(token.text)) throw new GlslError(token, `"${token.text}" is a word of GLSL itself and cannot name ${what}.`);
      return next();
    },
    unexpected,
    nested: (parse) => {
      depth += 1;
      if (depth > MAX_DEPTH) throw new GlslError(peek(), 'This is nested too deeply.');
      const result = parse();
      depth -= 1;
      return result;
    },
  };
}
