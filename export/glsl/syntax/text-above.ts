import { lex } from './lexer.ts';
import { preprocess } from './preprocess.ts';
import { GlslError, type Place, type Token } from './token.ts';

/** An open bracket. Statements end inside of blocks; `list` is any other bracket: arguments, members, values. */
interface Open {
  readonly kind: 'block' | 'list';
  readonly close: string;
  /** Index of the bracket's token. */
  readonly at: number;
}

interface Cut {
  readonly offset: number;
  readonly closing: string;
}

/**
 * The text of a shader up to the last statement that ends before `place`, completed: open blocks and `#if`s are closed, and `start` (the
 * text of `main`) is added if it is missing. Lines keep their numbers. Returns null if there is no text above.
 */
export function textAbove(source: string, place: Place, start: string): string | null {
  for (let end = offsetAt(lineStarts(source), place, source.length); end > 0; ) {
    try {
      return textUntil(source, end, start);
    } catch (error) {
      if (!(error instanceof GlslError)) throw error;
      // A macro whose arguments are incomplete.
      const earlier = offsetAt(lineStarts(source), error.place, source.length);
      if (earlier >= end) return null;
      end = earlier;
    }
  }
  return null;
}

function textUntil(source: string, end: number, start: string): string | null {
  const tokens = preprocess(whole(source.slice(0, end)));
  const cut = lastCut(tokens, lineStarts(source), end);
  if (cut === null) return null;
  const startName = /(\w+)\s*\(/.exec(start)?.[1] ?? '';
  const kept = `${whole(source.slice(0, cut.offset))}${cut.closing}\n`;
  return defines(preprocess(kept), startName) ? kept : `${kept}${start}\n`;
}

/** Adds an `#endif` for each open `#if`. */
function whole(text: string): string {
  let open = 0;
  const tokens = lex(text);
  tokens.forEach((token, i) => {
    const directive = token.startsLine && token.text === '#' ? tokens[i + 1]?.text : undefined;
    if (directive === 'if' || directive === 'ifdef' || directive === 'ifndef') open += 1;
    if (directive === 'endif') open -= 1;
  });
  return `${text}\n${'#endif\n'.repeat(Math.max(open, 0))}`;
}

/** The position after the last statement or start of a block that is not inside other brackets. */
function lastCut(tokens: readonly Token[], starts: readonly number[], end: number): Cut | null {
  const open: Open[] = [];
  let declaration = 0;
  let last: Cut | null = null;
  let closed: Open | undefined;
  tokens.forEach((token, i) => {
    if (token.kind === 'end') return;
    if (isOpener(token)) open.push(openAt(tokens, i, declaration, open, tokens[(closed?.at ?? 0) - 1]?.text));
    if (isCloser(token)) closed = open.pop();
    const isBlockEnd = token.text === '}' && closed?.kind === 'block' && closed.close !== END_OF_DO;
    const isStatementEnd = token.text === ';' || token.text === '{' || isBlockEnd;
    if (!isStatementEnd || open.some(({ kind }) => kind === 'list')) return;
    if (open.length === 0) declaration = i + 1;
    const next = tokens[i + 1];
    // The text of one macro cannot be split.
    if (next === undefined || (next.line === token.line && next.column === token.column)) return;
    const offset = next.kind === 'end' ? end : offsetAt(starts, next, end);
    last = {
      offset,
      closing: [...open]
        .reverse()
        .map(({ close }) => close)
        .join(' '),
    };
  });
  return last;
}

function isOpener({ text }: Token): boolean {
  return text === '(' || text === '[' || text === '{';
}

function isCloser({ text }: Token): boolean {
  return text === ')' || text === ']' || text === '}';
}

const BEFORE_BLOCKS: ReadonlySet<string> = new Set([')', ';', '{', '}', ':', 'else', 'do']);

/** Closes the body of a loop whose end was cut off. Without the `break`, the loop might be endless, and drivers reject endless loops. */
const END_OF_LOOP = 'break; }';
const END_OF_DO = 'break; } while (true);';

/**
 * Classifies the opening bracket at index `at` and finds the text that closes it. `declaration` is the index of the first token of the
 * enclosing global declaration. `head` is the word before the bracket pair that was closed last, such as `for`.
 */
function openAt(tokens: readonly Token[], at: number, declaration: number, around: readonly Open[], head = ''): Open {
  const before = tokens[at - 1]?.text ?? '';
  if (tokens[at]?.text !== '{' || !BEFORE_BLOCKS.has(before)) return { kind: 'list', close: '', at };
  if (before === 'do') return { kind: 'block', close: END_OF_DO, at };
  if (before === ')' && (head === 'for' || head === 'while')) return { kind: 'block', close: END_OF_LOOP, at };
  if (around.length > 0) return { kind: 'block', close: '}', at };
  // A function with a return type must return a value.
  const declared = tokens.slice(declaration, at);
  const type = declared.slice(0, Math.max(declared.findIndex(({ text }) => text === '(') - 1, 0)).map(({ text }) => text);
  const isVoid = type.length === 0 || type.includes('void');
  return { kind: 'block', close: isVoid ? '}' : `{ ${type.join(' ')} above; return above; } }`, at };
}

function defines(tokens: readonly Token[], name: string): boolean {
  return tokens.some((token, i) => {
    if (token.text !== name || tokens[i + 1]?.text !== '(') return false;
    const close = tokens.findIndex(({ text }, at) => at > i && text === ')');
    return tokens[close + 1]?.text === '{';
  });
}

function lineStarts(source: string): number[] {
  return [0, ...[...source.matchAll(/\r\n|\r|\n/g)].map((found) => found.index + found[0].length)];
}

function offsetAt(starts: readonly number[], { line, column }: Place, end: number): number {
  const start = starts[line - 1];
  return start === undefined ? end : Math.min(start + column - 1, end);
}
