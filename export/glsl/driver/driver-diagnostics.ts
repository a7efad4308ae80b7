import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { LinkedShader, SourceMap } from '../../program/program.ts';
import { authorsNames } from '../link/names.ts';
import { lex } from '../syntax/lexer.ts';
import { GlslError, type Place, type Token } from '../syntax/token.ts';

interface LogLine {
  readonly severity: 'error' | 'warning';
  /** Printed line, from 1; null where the driver names none. */
  readonly line: number | null;
  readonly quoted: string | null;
  readonly message: string;
}

/** ANGLE, and with it every Chromium: `ERROR: 0:12: 'foo' : undeclared identifier`. */
const ANGLE = /^(ERROR|WARNING):\s*(?:\d+:(\d+):\s*)?(?:'([^']*)'\s*:\s*)?(.*)$/;

/** Mesa, and drivers like it: `0:12(5): error: …`. */
const MESA = /^\d+:(\d+)\(\d+\):\s*(error|warning):\s*(.*)$/;

/** What authors wrote for the names that the linker gave. */
const AUTHORS_NAMES: ReadonlyMap<string, string> = new Map([
  ['scrim_uv', 'isf_FragNormCoord'],
  ['scrim_normCoord', 'isf_FragNormCoord'],
  ['scrim_fragCoord', 'gl_FragCoord'],
  ['scrim_fragColor', 'gl_FragColor'],
  ['assign', '='],
]);

/**
 * Turns a driver's log into diagnostics on the author's lines (SCR042). `sourceOf` gives the text of a file by the name that
 * its header was read with; with it, the column is that of the token which the driver quotes, without it, that of the
 * statement. Says something for every log that is not empty.
 */
export function driverDiagnostics(
  linked: LinkedShader,
  log: string,
  sourceOf?: (file: string) => string | undefined,
  stage: 'vertex' | 'fragment' | 'link' = 'fragment',
): Diagnostic[] {
  const map = stage === 'vertex' ? linked.vertexMap : linked.sourceMap;
  const lines = log
    .replaceAll('\0', '')
    .split('\n')
    .map(readLogLine)
    .filter((line) => line !== null);
  const [first] = log.replaceAll('\0', '').trim().split('\n');
  if (lines.length === 0 && first) lines.push({ severity: 'error', line: null, quoted: null, message: first });
  const tokens = new Map<string, readonly Token[]>();
  return uniqueDiagnostics(lines.map((line) => diagnose(map, line, tokensOf(tokens, sourceOf))));
}

/** Passes of one file share most of their text, and so its mistakes: each is to be told once. */
export function uniqueDiagnostics(diagnostics: readonly Diagnostic[]): Diagnostic[] {
  const seen = new Set<string>();
  return diagnostics.filter((diagnostic) => {
    const key = [diagnostic.nodeId, diagnostic.file, diagnostic.line, diagnostic.column, diagnostic.message].join('\0');
    return !seen.has(key) && seen.add(key);
  });
}

function readLogLine(text: string): LogLine | null {
  const angle = ANGLE.exec(text.trim());
  if (angle !== null) {
    const [, severity, line, quoted, message = ''] = angle;
    return {
      severity: severity === 'WARNING' ? 'warning' : 'error',
      line: line === undefined ? null : Number(line),
      quoted: quoted ?? null,
      message,
    };
  }
  const mesa = MESA.exec(text.trim());
  if (mesa === null) return null;
  const [, line, severity, message = ''] = mesa;
  return {
    severity: severity === 'warning' ? 'warning' : 'error',
    line: Number(line),
    quoted: /[`'"]([^`'"]+)[`'"]/.exec(message)?.[1] ?? null,
    message,
  };
}

function diagnose(map: SourceMap | undefined, line: LogLine, tokens: (file: string) => readonly Token[]): Diagnostic {
  const entry = line.line === null ? null : (map?.lines[line.line - 1] ?? null);
  const [source = 0, authorLine, column] = entry ?? [];
  const file = map?.sources[source];
  const node = map?.nodes[source];
  const place = authorLine === undefined || column === undefined ? null : { line: authorLine, column };
  const found = place !== null && file !== undefined && line.quoted !== null ? findQuoted(tokens(file), place, line.quoted) : null;
  const quoted = line.quoted === null || line.quoted === '' ? '' : `"${found?.text ?? authorsWord(line.quoted)}": `;
  const fix = FIXES.find(([words]) => words.test(line.message))?.[1];
  return {
    code: 'SCR042',
    severity: line.severity,
    message: `${quoted}${inAuthorsWords(line.message)}${fix === undefined ? '' : '.'}`,
    ...(fix === undefined ? {} : { fix }),
    ...(node === undefined ? {} : { nodeId: node }),
    ...(file === undefined ? {} : { file }),
    ...(place === null ? {} : { line: place.line, column: found?.column ?? place.column }),
  };
}

/** The quoted token on the author's line, from the statement's start on if it is there. */
function findQuoted(tokens: readonly Token[], place: Place, quoted: string): Token | null {
  const ofImage = authorsWord(quoted).replace(/_(?:at|depthAt)$/, '');
  const wanted = new Set([quoted, authorsWord(quoted), ...authorsNames(quoted), ofImage]);
  const onLine = tokens.filter((token) => token.line === place.line && wanted.has(token.text));
  return onLine.find((token) => token.column >= place.column) ?? onLine[0] ?? null;
}

function authorsWord(printed: string): string {
  return AUTHORS_NAMES.get(printed) ?? authorsNames(printed)[0] ?? printed;
}

/** What to do about what drivers of either kind say most often: their own words are those of people who write compilers. */
const FIXES: readonly (readonly [words: RegExp, fix: string])[] = [
  [/undeclared/i, 'Check its spelling, capitals included, or declare it above.'],
  [/no matching (?:overloaded )?function/i, 'Check how many values the function takes, and of which types.'],
  [
    /wrong operand types|cannot convert|could not implicitly convert|operands? .*(?:must|type)/i,
    'Give both sides the same type: float(x), vec3(x), x.rgb.',
  ],
  [/syntax error|unexpected/i, 'Look for a bracket, comma or semicolon that is missing or too much, here or just before.'],
  [/redefinition|redeclared/i, 'Something else has this name: take another.'],
  [/l-value|read-?only|can't modify/i, 'This cannot be set: copy it into a variable of your own first.'],
  [/field selection|swizzle/i, 'Look at how many parts it has: a vec3 has x, y and z, or r, g and b.'],
];

/** Everything is highp, so drivers' talk of it says nothing. */
function inAuthorsWords(message: string): string {
  return message
    .trim()
    .replace(/\bhighp\s+/g, '')
    .replace(/\b(?:[a-z]\d*_[A-Za-z]\w*|scrim_\w+)\b/g, authorsWord);
}

function tokensOf(
  cache: Map<string, readonly Token[]>,
  sourceOf: ((file: string) => string | undefined) | undefined,
): (file: string) => readonly Token[] {
  return (file) => {
    const known = cache.get(file);
    if (known !== undefined) return known;
    const tokens = lexLeniently(sourceOf?.(file) ?? '');
    cache.set(file, tokens);
    return tokens;
  };
}

function lexLeniently(source: string): readonly Token[] {
  try {
    return lex(source);
  } catch (error) {
    if (error instanceof GlslError) return [];
    throw error;
  }
}
