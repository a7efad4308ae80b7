import { GlslError, type Token, type TokenKind } from './token.ts';

/** Longest first, so that the pattern takes `<<=` before `<<`. */
const OPERATORS = [
  '<<=',
  '>>=',
  '<<',
  '>>',
  '<=',
  '>=',
  '==',
  '!=',
  '&&',
  '||',
  '^^',
  '++',
  '--',
  '+=',
  '-=',
  '*=',
  '/=',
  '%=',
  '&=',
  '|=',
  '^=',
  '##',
];

const PATTERN = new RegExp(
  [
    String.raw`(?<blank>(?:[ \t\v\f\u00a0\ufeff]|\\(?:\r\n|\r|\n))+)`,
    String.raw`(?<newline>\r\n|\r|\n)`,
    String.raw`(?<line>//(?:[^\r\n\\]|\\(?:\r\n|[\s\S]))*)`,
    String.raw`(?<block>/\*[\s\S]*?\*/)`,
    '(?<word>[A-Za-z_][A-Za-z0-9_]*)',
    String.raw`(?<float>(?:(?:[0-9]+\.[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?|[0-9]+[eE][+-]?[0-9]+)(?:lf|LF|[fF])?|[0-9]+[fF])`,
    '(?<int>(?:0[xX][0-9a-fA-F]+|[0-9]+)[uU]?)',
    `(?<operator>${OPERATORS.map((o) => o.replace(/[|^+*]/g, '\\$&')).join('|')}|[-+*/%<>=!&|^~?:;,.(){}\\[\\]#])`,
    String.raw`(?<bad>[\s\S])`,
  ].join('|'),
  'gy',
);

const LINE_BREAK = /\r\n|\r|\n/g;

/**
 * Cuts a source into tokens, without white space and comments. A character that GLSL does not know becomes a `bad` token:
 * it matters only if it is still there after `#if` has been decided. Throws `GlslError` for a comment that never ends.
 */
export function lex(source: string): Token[] {
  const tokens: Token[] = [];
  const pattern = new RegExp(PATTERN);
  let line = 1;
  let lineStart = 0;
  let startsLine = true;
  let spaced = false;
  let offset = 0;
  while (offset < source.length) {
    pattern.lastIndex = offset;
    const groups = pattern.exec(source)?.groups ?? {};
    const [kind, text] = firstGroup(groups);
    const column = offset - lineStart + 1;
    switch (kind) {
      case 'blank':
      case 'line':
      case 'block':
      case 'newline':
        for (const lineBreak of text.matchAll(LINE_BREAK)) {
          line += 1;
          lineStart = offset + lineBreak.index + lineBreak[0].length;
        }
        spaced = true;
        if (kind === 'newline') startsLine = true;
        break;
      default:
        if (kind === 'operator' && source.startsWith('/*', offset))
          throw new GlslError({ line, column }, 'This comment is never closed with "*/".');
        tokens.push({ kind: tokenKind(kind, text), text, line, column, startsLine, spaced, hidden: null });
        startsLine = false;
        spaced = false;
    }
    offset += text.length;
  }
  tokens.push({ kind: 'end', text: '', line, column: offset - lineStart + 1, startsLine: true, spaced: true, hidden: null });
  return tokens;
}

function firstGroup(groups: Readonly<Record<string, string | undefined>>): readonly [string, string] {
  for (const kind in groups) {
    const text = groups[kind];
    if (text !== undefined) return [kind, text];
  }
  throw new Error('The last alternative of the pattern takes any character.');
}

function tokenKind(group: string, text: string): TokenKind {
  if (group === 'int') return /[uU]$/.test(text) ? 'uint' : 'int';
  return group as TokenKind;
}
