import { lex } from '../syntax/lexer.ts';
import { parseShader } from '../syntax/parse.ts';
import { GlslError, type Token } from '../syntax/token.ts';

/** Global declarations of a piece of GLSL. */
export interface Declared {
  /** Functions, variables and structs. */
  readonly names: ReadonlySet<string>;
  readonly macros: ReadonlySet<string>;
  /** Members of its structs. */
  readonly members: ReadonlySet<string>;
}

const LINE_BREAK = /\r\n|\r|\n/;

/**
 * Finds the declarations of `code`, which follows the text `before`. Code that cannot be parsed has none; the linker reports the mistake.
 */
export function declaredIn(code: string, before: string): Declared {
  const names = new Set<string>();
  const macros = new Set<string>();
  const members = new Set<string>();
  const first = before.split(LINE_BREAK).length;
  try {
    const tokens = lex(code);
    tokens.forEach(({ text }, i) => {
      if (text === 'define' && tokens[i - 1]?.text === '#') macros.add(tokens[i + 1]?.text ?? '');
    });
    for (const declaration of parseShader(`${before}\n${code}`).declarations) {
      const add = ({ text, line }: Token) => line > first && names.add(text);
      if (declaration.kind === 'function') add(declaration.name);
      else {
        for (const { name } of declaration.declarators) add(name);
        const { struct } = declaration.type;
        if (struct?.name) add(struct.name);
        for (const { name } of struct && struct.start.line > first ? struct.members : []) members.add(name.text);
      }
    }
  } catch (fault) {
    if (!(fault instanceof GlslError)) throw fault;
  }
  return { names, macros, members };
}

/** Every word of the text outside of comments. */
export function wordsOf(code: string): Set<string> {
  try {
    return new Set(lex(code).flatMap(({ kind, text }) => (kind === 'word' ? [text] : [])));
  } catch (fault) {
    if (!(fault instanceof GlslError)) throw fault;
    return new Set();
  }
}

/**
 * Replaces words in code, including macros, but not in comments. Each word has one meaning throughout, so hiding is preserved. Members keep
 * their names, except those of the text's own structs.
 */
export function renameWords(code: string, names: ReadonlyMap<string, string>, members: ReadonlySet<string>): string {
  if (names.size === 0) return code;
  const lines = code.split(LINE_BREAK);
  let before: Token | null = null;
  const uses: { readonly token: Token; readonly name: string }[] = [];
  for (const token of lex(code)) {
    const name = token.kind === 'word' ? names.get(token.text) : undefined;
    if (name !== undefined && (before?.text !== '.' || members.has(token.text))) uses.push({ token, name });
    before = token;
  }
  // From the end, so that earlier columns stay valid.
  for (const { token, name } of uses.reverse()) {
    const line = lines[token.line - 1] ?? '';
    lines[token.line - 1] = line.slice(0, token.column - 1) + name + line.slice(token.column - 1 + token.text.length);
  }
  return lines.join('\n');
}
