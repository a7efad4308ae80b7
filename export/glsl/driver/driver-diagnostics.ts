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

/** A line of the log with its position in the author's text. */
interface Told {
  readonly line: LogLine;
  /** The token that the driver quotes; null if the author's text does not have it. */
  readonly found: Token | null;
  readonly diagnostic: Diagnostic;
}

/**
 * Converts a driver's log to diagnostics on the author's lines (SCR042), in order. With `sourceOf`, which returns the text of a file by
 * name, the column is that of the quoted token, and only the first mistake of each statement is reported. Without it, the column is that of
 * the statement. A log that is not empty gives at least one diagnostic.
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

/** Removes duplicates, because passes of one file share most of their text. Sorts those of one file by line. */
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
 * Finds the quoted token on the author's line, searching from where the text of the printed line starts; no printed line has the token
 * twice. If the message is about a member, the token must follow a dot; if it is about an undeclared name, it must not.
 */
function findQuoted(tokens: readonly Token[], place: Place, { quoted, message }: LogLine): Token | null {
  const word = quoted ?? '';
  const wanted = wantedFor(word);
  const isPart = /field/.test(message) ? true : /undeclared|no matching/.test(message) ? false : null;
  const onLine = tokens.flatMap((token, i) => {
    if (token.line !== place.line || !wanted(token, tokens[i + 1])) return [];
    if (isPart !== null && token.kind === 'word' && (tokens[i - 1]?.text === '.') !== isPart) return [];
    // Calls that read an image are quoted by the image's name.
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
 * Removes errors that only follow from earlier ones: after an error, drivers go on with a number in place of the unknown value. An
 * undeclared name is reported at its first use, and of each statement only the innermost first mistake.
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

/**
 * Whether an operator is only in the printed text, such as the division by the size that the linker prints for `IMG_PIXEL`. The driver's
 * next diagnostic is then at the author's call.
 */
function isPrintersOwn({ line, found, diagnostic }: Told, next: Told | undefined): boolean {
  const isOperator = line.quoted !== null && /^[^\w\s]+$/.test(line.quoted);
  return isOperator && found === null && next !== undefined && next.found !== null && next.diagnostic.line === diagnostic.line;
}

/**
 * Whether a diagnostic only repeats the one before: for a `return;` without value, drivers also report that the function returns nothing.
 */
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
