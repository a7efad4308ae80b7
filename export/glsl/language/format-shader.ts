import { lex } from '../syntax/lexer.ts';
import { GlslError, type Token } from '../syntax/token.ts';
import { TYPES } from '../syntax/words.ts';

const INDENT = '  ';

/** A token or a comment; `breaks` counts the line ends before it. */
interface Piece {
  readonly text: string;
  readonly kind: Token['kind'] | 'comment' | 'directive';
  readonly breaks: number;
  /** Whether white space precedes the piece. */
  readonly spaced: boolean;
}

/**
 * Formats a shader: indents by brackets, normalizes spaces, and removes trailing spaces and repeated empty lines. Line breaks, the header,
 * comments, directives and all tokens stay. Returns null if a comment is not closed.
 */
export function formatShader(source: string): string | null {
  let pieces: readonly Piece[];
  try {
    pieces = readPieces(source);
  } catch (error) {
    if (error instanceof GlslError) return null;
    throw error;
  }
  const lines = splitLines(pieces);
  const output: string[] = [];
  const layout = createLayout();
  lines.forEach((line, i) => {
    if (i > 0 && (line[0]?.breaks ?? 0) > 1) output.push('');
    output.push(layout.print(line));
  });
  return `${output.join('\n')}\n`;
}

function readPieces(source: string): Piece[] {
  const pieces: Piece[] = [];
  const lineStarts = [0, ...[...source.matchAll(/\r\n|\r|\n/g)].map(({ index, 0: text }) => index + text.length)];
  const tokens = lex(source);
  let offset = 0;
  let breaks = 0;
  let spaced = false;
  const add = (text: string, kind: Piece['kind']) => {
    pieces.push({ text, kind, breaks, spaced });
    breaks = 0;
    spaced = false;
  };
  const readBlanks = (to: number) => {
    for (const { 0: text } of source
      .slice(offset, to)
      .matchAll(/\/\/(?:[^\r\n\\]|\\(?:\r\n|[\s\S]))*|\/\*[\s\S]*?\*\/|\r\n|\r|\n|[^\S\r\n]+|\\/g)) {
      if (text.startsWith('/')) add(text.trimEnd(), 'comment');
      else if (/[\r\n]/.test(text)) breaks += 1;
      else spaced = true;
    }
    offset = to;
  };
  for (let i = 0; i < tokens.length; i += 1) {
    const token = tokens[i] as Token;
    const start = token.kind === 'end' ? source.length : (lineStarts[token.line - 1] ?? 0) + token.column - 1;
    readBlanks(start);
    if (token.kind === 'end') break;
    if (token.startsLine && token.text === '#') {
      while (tokens[i + 1]?.startsLine === false) i += 1;
      const end = directiveEnd(source, start);
      add(source.slice(start, end).trimEnd(), 'directive');
      offset = end;
      continue;
    }
    add(token.text, token.kind);
    offset = start + token.text.length;
  }
  return pieces;
}

/** End of a directive with its continuation lines; a comment in it may contain line ends. */
function directiveEnd(source: string, start: number): number {
  const rest = /(?:\/\*[\s\S]*?\*\/|\/\/(?:[^\r\n\\]|\\(?:\r\n|[\s\S]))*|\\(?:\r\n|\r|\n)|[^\r\n])*/y;
  rest.lastIndex = start;
  return start + (rest.exec(source)?.[0].length ?? 0);
}

function splitLines(pieces: readonly Piece[]): Piece[][] {
  const lines: Piece[][] = [];
  for (const piece of pieces) {
    if (piece.breaks > 0 || lines.length === 0 || piece.kind === 'directive') lines.push([]);
    lines.at(-1)?.push(piece);
  }
  return lines;
}

function createLayout() {
  let braces = 0;
  let brackets = 0;
  /** Whether a statement is unfinished, so that the next line continues it. */
  let goesOn = false;
  let ternaries = 0;
  let before: Piece | null = null;
  /** Whether the last token is a unary operator, which no space follows. */
  let unary = false;

  function print(line: readonly Piece[]): string {
    const [first] = line;
    if (first === undefined) return '';
    if (first.kind === 'directive') return line.map(({ text }) => text).join(' ');
    let closing = 0;
    for (const { text } of line) {
      if (text !== '}') break;
      closing += 1;
    }
    const levels = Math.max(braces - closing, 0) + (brackets > 0 && ![')', ']'].includes(first.text) ? 1 : 0) + (continues(first) ? 1 : 0);
    let text = first.kind === 'comment' && braces === 0 && brackets === 0 ? '' : INDENT.repeat(levels);
    line.forEach((piece, i) => {
      const last = line[i - 1];
      if (last !== undefined && needsSpace(last, piece)) text += ' ';
      text += piece.text;
      take(piece);
    });
    return text;
  }

  function continues(first: Piece): boolean {
    return goesOn && brackets === 0 && first.text !== '{' && first.text !== '}' && first.kind !== 'comment';
  }

  function take(piece: Piece): void {
    if (piece.kind === 'comment') return;
    const { text } = piece;
    unary = isUnary(piece);
    if (text === '{') braces += 1;
    if (text === '}') braces = Math.max(braces - 1, 0);
    if (text === '(' || text === '[') brackets += 1;
    if (text === ')' || text === ']') brackets = Math.max(brackets - 1, 0);
    const label = text === ':' && ternaries === 0;
    if (text === '?') ternaries += 1;
    else if (text === ':' && ternaries > 0) ternaries -= 1;
    if (text === ';' || text === '{' || text === '}') ternaries = 0;
    goesOn = !(text === '{' || text === '}' || label || (text === ';' && brackets === 0));
    before = piece;
  }

  function isUnary({ text }: Piece): boolean {
    if (!['-', '+', '!', '~', '++', '--'].includes(text)) return false;
    if (text === '!' || text === '~') return true;
    return !endsOperand(before);
  }

  function needsSpace(left: Piece, right: Piece): boolean {
    if (left.kind === 'comment' || right.kind === 'comment') return true;
    return wantsSpace(left, right) || !staysApart(left, right);
  }

  function wantsSpace(left: Piece, right: Piece): boolean {
    const [l, r] = [left.text, right.text];
    if (r === ';' || r === ',' || r === ')' || r === ']' || r === '.') return false;
    if (l === '(' || l === '[' || l === '.') return false;
    if (l === ',' || l === ';') return true;
    if (unary) return false;
    if (r === '++' || r === '--') return !endsOperand(left);
    if (l === '++' || l === '--') return true;
    if (r === '[') return false;
    if (r === '(') return !isCallee(left);
    if (r === ':' && ternaries === 0) return false;
    return true;
  }

  return { print };
}

/** Whether a token ends an operand, so that a binary operator or a suffix may follow it. */
function endsOperand(piece: Piece | null): boolean {
  if (piece === null) return false;
  const { kind, text } = piece;
  if (kind === 'int' || kind === 'uint' || kind === 'float') return true;
  if (kind === 'word') return text !== 'return' && text !== 'case' && text !== 'else';
  return text === ')' || text === ']';
}

function isCallee({ kind, text }: Piece): boolean {
  if (kind !== 'word') return text === ')' || text === ']';
  return TYPES.has(text) || !['if', 'for', 'while', 'switch', 'return', 'case', 'else', 'do'].includes(text);
}

/** Whether two tokens are still read as two if they are written without a space. */
function staysApart(left: Piece, right: Piece): boolean {
  const glued = lex(left.text + right.text);
  return glued.length === 3 && glued[0]?.text === left.text && glued[1]?.text === right.text;
}
