/** A part of a template literal: text, or the delimiters with the code of a substitution. */
export interface Piece {
  readonly text: string;
  readonly isText: boolean;
}

/** Reads the template literal whose first character is at `open`. */
export function readTemplate(script: string, open: number): { readonly pieces: readonly Piece[]; readonly end: number } {
  const pieces: Piece[] = [{ text: '`', isText: false }];
  let from = open + 1;
  for (let at = from; at < script.length; at++) {
    if (script[at] === '\\') {
      at++;
    } else if (script[at] === '`') {
      pieces.push({ text: script.slice(from, at), isText: true }, { text: '`', isText: false });
      return { pieces, end: at + 1 };
    } else if (script.startsWith('${', at)) {
      const end = endOfBlock(script, at + 1);
      pieces.push({ text: script.slice(from, at), isText: true }, { text: script.slice(at, end), isText: false });
      from = end;
      at = end - 1;
    }
  }
  throw new Error('A script has a template literal without end.');
}

/** The index after the brace that closes the one at `open`. Braces in regular expressions are not told apart. */
export function endOfBlock(script: string, open: number): number {
  let depth = 0;
  for (let at = open; at < script.length; at++) {
    const char = script[at];
    if (script.startsWith('//', at)) {
      at = indexAfter(script, '\n', at) - 1;
    } else if (script.startsWith('/*', at)) {
      at = indexAfter(script, '*/', at + 2) - 1;
    } else if (char === '`') {
      at = readTemplate(script, at).end - 1;
    } else if (char === "'" || char === '"') {
      at++;
      while (at < script.length && script[at] !== char) at += script[at] === '\\' ? 2 : 1;
    } else if (char === '{') {
      depth++;
    } else if (char === '}') {
      depth--;
      if (depth === 0) return at + 1;
    }
  }
  throw new Error('A script has a block without end.');
}

function indexAfter(script: string, text: string, from: number): number {
  const found = script.indexOf(text, from);
  return found < 0 ? script.length : found + text.length;
}
