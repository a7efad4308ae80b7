import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { LinkedShader, SourceMap } from '../../program/program.ts';
import { authorsNames } from '../link/names.ts';
import { lex } from '../syntax/lexer.ts';
import { ASSIGNMENTS } from '../syntax/parse-expression.ts';
import { GlslError, type Place, type Token } from '../syntax/token.ts';
import { TYPES } from '../syntax/words.ts';
import { type LogLine, readLog } from './driver-log.ts';
import { authorsWord, fixFor, inAuthorsWords } from './driver-wording.ts';
import { argumentsAt, statementAt } from './statement-at.ts';

type TokensOf = (file: string) => readonly Token[];

/** A line of the log with its place in the author's text. */
interface Told {
  readonly line: LogLine;
  /** The word that the driver quotes, as the author wrote it; null where the text does not have it. */
  readonly found: Token | null;
  readonly diagnostic: Diagnostic;
}

/**
 * Turns a driver's log into diagnostics on the author's lines (SCR042), in their order. `sourceOf` gives the text of a file by the
 * name that its header was read with; with it, the column is that of the token which the driver quotes, and of each statement
 * only what is wrong first is told; without it, the column is that of the statement. Says something for every log that is not empty.
 */
export function driverDiagnostics(
  linked: LinkedShader,
  log: string,
  sourceOf?: (file: string) => string | undefined,
  stage: 'vertex' | 'fragment' | 'link' = 'fragment',
): Diagnostic[] {
  const map = stage === 'vertex' ? linked.vertexMap : linked.sourceMap;
  const tokens = tokensOf(sourceOf);
  const told = readLog(log).map((line) => diagnose(map, line, tokens));
  return uniqueDiagnostics(firstMistakes(told, tokens).map(({ diagnostic }) => diagnostic));
}

/** Passes of one file share most of their text, and so its mistakes: each is to be told once. Those of a file in order of its lines. */
export function uniqueDiagnostics(diagnostics: readonly Diagnostic[]): Diagnostic[] {
  const seen = new Set<string>();
  const unique = diagnostics.filter((diagnostic) => {
    const key = [diagnostic.nodeId, diagnostic.file, diagnostic.line, diagnostic.column, diagnostic.message].join('\0');
    return !seen.has(key) && seen.add(key);
  });
  const files = [...new Set(unique.map(({ file }) => file))];
  return files.flatMap((file) =>
    unique
      .filter((diagnostic) => diagnostic.file === file)
      .sort((a, b) => (a.line ?? 0) - (b.line ?? 0) || (a.column ?? 0) - (b.column ?? 0)),
  );
}

function diagnose(map: SourceMap | undefined, line: LogLine, tokens: TokensOf): Told {
  const entry = line.line === null ? null : (map?.lines[line.line - 1] ?? null);
  const [source = 0, authorLine, column] = entry ?? [];
  const file = map?.sources[source];
  const node = map?.nodes[source];
  const place = authorLine === undefined || column === undefined ? null : { line: authorLine, column };
  const found = place !== null && file !== undefined && line.quoted !== null ? findQuoted(tokens(file), place, line) : null;
  const quoted = line.quoted === null || line.quoted === '' ? '' : `"${found?.text ?? authorsWord(line.quoted)}": `;
  const fix = fixFor(line.message);
  const diagnostic: Diagnostic = {
    code: 'SCR042',
    severity: line.severity,
    message: `${quoted}${inAuthorsWords(line.message)}${fix === undefined ? '' : '.'}`,
    ...(fix === undefined ? {} : { fix }),
    ...(node === undefined ? {} : { nodeId: node }),
    ...(file === undefined ? {} : { file }),
    ...(place === null ? {} : { line: place.line, column: found?.column ?? place.column }),
  };
  return { line, found, diagnostic };
}

/**
 * The quoted token on the author's line, from the place on where the printed line begins: no printed line has it twice. What
 * selects a part stands behind a dot, and what does not exist does not.
 */
function findQuoted(tokens: readonly Token[], place: Place, { quoted, message }: LogLine): Token | null {
  const word = quoted ?? '';
  const wanted = wantedFor(word);
  const isPart = /field/.test(message) ? true : /undeclared|no matching/.test(message) ? false : null;
  const onLine = tokens.flatMap((token, i) => {
    if (token.line !== place.line || !wanted(token, tokens[i + 1])) return [];
    if (isPart !== null && token.kind === 'word' && (tokens[i - 1]?.text === '.') !== isPart) return [];
    // What reads an image is quoted by the image's name: authors wrote a function.
    const isReading = /_(?:at|depthAt)$/.test(word) && tokens[i - 1]?.text === '(';
    return [(isReading ? tokens[i - 2] : undefined) ?? token];
  });
  return onLine.find((token) => token.column >= place.column) ?? onLine[0] ?? null;
}

function wantedFor(quoted: string): (token: Token, next: Token | undefined) => boolean {
  if (quoted === 'constructor') return ({ text }, next) => TYPES.has(text) && next?.text === '(';
  if (quoted === 'assign' || quoted === '=') return ({ text }) => ASSIGNMENTS.has(text);
  if (quoted === '[]' || quoted === '?:') return ({ text }) => text === quoted[0];
  const image = authorsWord(quoted).replace(/_(?:at|depthAt)$/, '');
  const names = new Set([quoted, authorsWord(quoted), ...authorsNames(quoted), image]);
  return ({ text }) => names.has(text);
}

/**
 * Leaves out what follows from what was told before: drivers read on with a number in the place of what they do not know. A name
 * that is not declared is told where it first stands, and of a statement only what is wrong first, from inside out.
 */
function firstMistakes(told: readonly Told[], tokens: TokensOf): readonly Told[] {
  const undeclared = new Set<string>();
  const kept: Told[] = [];
  for (const [i, one] of told.entries()) {
    if (isPrintersOwn(one, told[i + 1]) || isToldByReturn(one, told[i - 1])) continue;
    const { file, line, column } = one.diagnostic;
    if (file === undefined || line === undefined || column === undefined || one.line.severity === 'warning') {
      kept.push(one);
      continue;
    }
    const statement = statementAt(tokens(file), { line, column });
    if (/undeclared/.test(one.line.message) && one.found) {
      const { text } = one.found;
      if (undeclared.has(text)) continue;
      undeclared.add(text);
      kept.push(one);
      continue;
    }
    const isCall = /no matching/.test(one.line.message) && one.found !== null;
    const concerned = isCall ? argumentsAt(statement, { line, column }) : statement;
    const follows =
      concerned.some(({ text, kind }) => kind === 'word' && undeclared.has(text)) ||
      kept.some(({ diagnostic: before }) => before.file === file && concerned.some((token) => isAt(token, before)));
    if (!follows) kept.push(one);
  }
  return kept;
}

/** An operator that only the printed text has, as where IMG_PIXEL divides by the picture's size; the author's call is told next. */
function isPrintersOwn({ line, found, diagnostic }: Told, next: Told | undefined): boolean {
  const isOperator = line.quoted !== null && /^[^\w\s]+$/.test(line.quoted);
  return isOperator && found === null && next !== undefined && next.found !== null && next.diagnostic.line === diagnostic.line;
}

/** Of a `return;` that gives nothing drivers also say, of the head, that the function gives nothing. */
function isToldByReturn({ line }: Told, before: Told | undefined): boolean {
  return /does not return a value/i.test(line.message) && before !== undefined && /must return a value/i.test(before.line.message);
}

function isAt(token: Token, { line, column }: Diagnostic): boolean {
  return token.line === line && token.column === column;
}

function tokensOf(sourceOf: ((file: string) => string | undefined) | undefined): TokensOf {
  const cache = new Map<string, readonly Token[]>();
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
