/** A token of GLSL with its position in the author's text. */
export interface Token {
  readonly kind: TokenKind;
  readonly text: string;
  /** From 1. Tokens of a macro have the position of its use. */
  readonly line: number;
  /** From 1, in UTF-16 units as editors count. */
  readonly column: number;
  /** Whether it is the first on its line, where `#` starts a directive. */
  readonly startsLine: boolean;
  /** Whether white space or a comment precedes it, which distinguishes `#define F (x)` from `#define F(x)`. */
  readonly spaced: boolean;
  /** Macros that must not be expanded in this token again (C11 §6.10.3.4); null for none. */
  readonly hidden: ReadonlySet<string> | null;
}

/** `word`: identifier or keyword. `bad`: an invalid character. `end`: after the last token. */
export type TokenKind = 'word' | 'int' | 'uint' | 'float' | 'operator' | 'bad' | 'end';

export interface Place {
  readonly line: number;
  readonly column: number;
}

/** A mistake in a source with its position; functions that return a `Result` convert it to a `Diagnostic`. */
export class GlslError extends Error {
  readonly place: Place;
  /** SCR041 for invalid GLSL, SCR043 for GLSL that cannot run here. */
  readonly code: 'SCR041' | 'SCR043';
  /** The file, if it is a related file instead of the requested one. */
  readonly file: string | null;

  constructor(place: Place, message: string, code: 'SCR041' | 'SCR043' = 'SCR041', file: string | null = null) {
    super(message);
    this.name = 'GlslError';
    this.place = { line: place.line, column: place.column };
    this.code = code;
    this.file = file;
  }
}

/** Runs `read` and adds the file to its errors. */
export function inFile<T>(file: string, read: () => T): T {
  try {
    return read();
  } catch (error) {
    if (!(error instanceof GlslError)) throw error;
    throw new GlslError(error.place, error.message, error.code, file);
  }
}
