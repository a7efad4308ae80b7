/** A word of an expression, and where it begins. */
export interface Word {
  readonly kind: 'number' | 'name' | 'sign' | 'end';
  readonly text: string;
  readonly offset: number;
}

/** Longer signs first, so that `<=` is not read as `<`. */
const WORD =
  /(?<space>\s+)|(?<number>(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)|(?<name>[A-Za-z_]\w*)|(?<sign><=|>=|==|!=|&&|\|\||[-+*/%^<>!?:(),[\]−×÷≤≥≠])/y;

/** As they stand in print, and in texts that formulas are copied from. */
const PRINTED: Readonly<Record<string, string>> = { '−': '-', '×': '*', '÷': '/', '≤': '<=', '≥': '>=', '≠': '!=' };

export type Words = { readonly ok: true; readonly words: readonly Word[] } | { readonly ok: false; readonly offset: number };

/** The words, and one for the end; or where something stands that is none. */
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
