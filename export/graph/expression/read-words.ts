/** A token of an expression with its offset. */
export interface Word {
  readonly kind: 'number' | 'name' | 'sign' | 'end';
  readonly text: string;
  readonly offset: number;
}

/** Matches a token. Longer signs come first, so that `<=` is not read as `<`. */
const WORD =
  /(?<space>\s+)|(?<number>(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)|(?<name>[A-Za-z_]\w*)|(?<sign><=|>=|==|!=|&&|\|\||[-+*/%^<>!?:(),[\]−×÷≤≥≠])/y;

/** Typographic characters, as in formulas copied from print, and the signs that they stand for. */
const PRINTED: Readonly<Record<string, string>> = { '−': '-', '×': '*', '÷': '/', '≤': '<=', '≥': '>=', '≠': '!=' };

export type Words = { readonly ok: true; readonly words: readonly Word[] } | { readonly ok: false; readonly offset: number };

/** Splits an expression into tokens, with one for the end; or returns the offset of the first invalid character. */
export function readWords(text: string): Words {
  const words: Word[] = [];
  WORD.lastIndex = 0;
  while (WORD.lastIndex < text.length) {
    const offset = WORD.lastIndex;
    const groups = WORD.exec(text)?.groups;
    if (!groups) return { ok: false, offset };
    const { number, name, sign } = groups;
    if (number !== undefined) words.push({ kind: 'number', text: number, offset });
    else if (name !== undefined) words.push({ kind: 'name', text: name, offset });
    else if (sign !== undefined) words.push({ kind: 'sign', text: PRINTED[sign] ?? sign, offset });
  }
  words.push({ kind: 'end', text: '', offset: text.length });
  return { ok: true, words };
}
