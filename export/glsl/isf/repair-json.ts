/** Valid JSON, and the offset of each of its characters in the author's text. */
export interface RepairedJson {
  readonly text: string;
  readonly offsets: readonly number[];
}

const CLOSING: Readonly<Record<string, string>> = { '"': '"', "'": "'", '“': '”', '‘': '’' };
const WORDS: ReadonlyMap<string, string> = new Map([
  ['true', 'true'],
  ['false', 'false'],
  ['yes', 'true'],
  ['no', 'false'],
  ['null', 'null'],
]);

const COMMENT = /(?:\/\/|#)[^\r\n]*/y;
const NUMBER = /[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?[fF]?(?![\w.])/y;
const WORD = /[A-Za-z_$][\w$]*/y;
const ESCAPE = /\\(?:["\\/bfnrt]|u[0-9a-fA-F]{4})/y;

/**
 * Rewrites a header as valid JSON. It repairs faults that other programs accept: numbers such as `.5`, `1.`, `+1` and `1.0f`, unquoted
 * names, `TRUE` and `YES`, other quotes, comments after `#`, semicolons for commas, invalid backslashes. Missing characters, such as a
 * bracket, are not added. Returns null if a text is not closed or a value is invalid.
 */
export function repairJson(source: string): RepairedJson | null {
  let text = '';
  const offsets: number[] = [];
  let at = 0;

  function emit(piece: string, from: number): void {
    for (let i = 0; i < piece.length; i += 1) offsets.push(from);
    text += piece;
  }

  function take(pattern: RegExp): string | null {
    pattern.lastIndex = at;
    const found = pattern.exec(source)?.[0] ?? null;
    if (found !== null) at += found.length;
    return found;
  }

  function takeText(closing: string): boolean {
    emit('"', at);
    at += 1;
    while (at < source.length && source[at] !== closing) {
      const from = at;
      const escaped = take(ESCAPE);
      const character = source[from] ?? '';
      if (escaped === null) at += 1;
      emit(escaped ?? (character === '"' || character === '\\' ? `\\${character}` : character < ' ' ? ' ' : character), from);
    }
    emit('"', at);
    at += 1;
    return at <= source.length;
  }

  while (at < source.length) {
    const from = at;
    const closing = CLOSING[source[at] ?? ''];
    if (closing !== undefined) {
      if (!takeText(closing)) return null;
      continue;
    }
    if (take(COMMENT) !== null) continue;
    const number = take(NUMBER);
    const word = number === null ? take(WORD) : null;
    if (number !== null) emit(String(Number(number.replace(/[fF]$/, ''))), from);
    else if (word !== null) {
      const known = WORDS.get(word.toLowerCase());
      // Keys may be unquoted, values may not.
      if (known === undefined && !/^\s*:/.test(source.slice(at, at + 100))) return null;
      emit(known ?? JSON.stringify(word), from);
    } else {
      emit(source[at] === ';' ? ',' : (source[at] ?? ''), from);
      at += 1;
    }
  }
  return { text, offsets };
}
