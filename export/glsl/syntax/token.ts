/** A piece of GLSL text, with the place its author wrote it. */
export interface Token {
  readonly kind: TokenKind;
  readonly text: string;
  /** From 1. A token that a macro brought has the place where the macro was used. */
  readonly line: number;
  /** From 1, in UTF-16 units as editors count. */
  readonly column: number;
  /** First on its line; a `#` there begins a directive. */
  readonly startsLine: boolean;
  /** White space or a comment stood before it: tells `#define F (x)` from `#define F(x)`. */
  readonly spaced: boolean;
  /** Macros that must not be expanded in it again (C11 §6.10.3.4); null for none. */
  readonly hidden: ReadonlySet<string> | null;
}

/** `word`: identifier or keyword. `bad`: a character that GLSL does not know. `end`: after the last token. */
export type TokenKind = 'word' | 'int' | 'uint' | 'float' | 'operator' | 'bad' | 'end';

export interface Place {
  readonly line: number;
  readonly column: number;
}

/** What went wrong while reading a source, and where; those that offer a `Result` turn it into a `Diagnostic`. */
export class GlslError extends Error {
  readonly place: Place;
  /** Bad GLSL, or good GLSL that cannot run here. */
  readonly code: 'SCR041' | 'SCR043';
  /** Where it is not the file that was asked for, but one beside it. */
  readonly file: string | null;

  constructor(place: Place, message: string, code: 'SCR041' | 'SCR043' = 'SCR041', file: string | null = null) {
    super(message);
    this.name = 'GlslError';
    this.place = { line: place.line, column: place.column };
    this.code = code;
    this.file = file;
  }
}

/** Runs `read`, and names the file in what goes wrong. */
export function inFile<T>(file: string, read: () => T): T {
  try {
    return read();
  } catch (error) {
    if (!(error instanceof GlslError)) throw error;
    throw new GlslError(error.place, error.message, error.code, file);
  }
}
