import { property, readHeader, textOf } from '../isf/isf-header.ts';
import type { Place, Token } from '../syntax/token.ts';
import { BUILTIN_FUNCTIONS } from './builtin-docs.ts';
import { commentAt, findName, headerUsesOf, type ShaderDocument, wordAt } from './shader-document.ts';
import type { NameSignature, ShaderName } from './shader-name.ts';
import { isBefore, rangeOf, type TextRange } from './source-text.ts';
import { typeOfValue } from './type-at.ts';
import { HEADER_KEYS, INPUT_TYPE_DOCS, ISF_FUNCTIONS } from './vocabulary.ts';

export interface HoverText {
  readonly range: TextRange;
  /** GLSL code. */
  readonly code: string;
  /** Markdown. */
  readonly doc: string;
}

export interface FoundPlace {
  /** Null for the text itself. */
  readonly file: string | null;
  readonly range: TextRange;
}

export interface SignatureHelp {
  readonly signatures: readonly NameSignature[];
  readonly doc: string;
  /** Index of the first signature that has a parameter for the current argument, and index of that parameter. */
  readonly active: number;
  readonly parameter: number;
}

const GENERIC_NOTE = '`T`: float, vec2, vec3 or vec4; the same letter has the same size.';

export function hoverAt(document: ShaderDocument, place: Place): HoverText | null {
  if (commentAt(document.source, place) === 'header') return headerHover(document, place);
  const found = findName(document, place);
  if (found !== null) return { range: found.range, code: codeOf(found.name), doc: found.name.doc };
  const token = wordAt(document, place);
  if (token === null) return null;
  const member = memberAt(document, token);
  if (member !== null) return { range: rangeOf(token), ...member };
  const builtin = builtinOf(token.text);
  if (builtin === null) return null;
  const code = builtin.signatures.map(({ label }) => label).join('\n');
  return { range: rangeOf(token), code, doc: /\bT\b/.test(code) ? `${builtin.doc}\n\n${GENERIC_NOTE}` : builtin.doc };
}

function codeOf({ kind, name, type, signatures, members }: ShaderName): string {
  switch (kind) {
    case 'function':
      return signatures.map(({ label }) => label).join('\n');
    case 'macro':
      return signatures.map(({ label }) => `#define ${label}`).join('\n');
    case 'struct':
      return `struct ${name} { ${[...members.values()].map((member) => `${member.type} ${member.name};`).join(' ')} }`;
    case 'input':
      return `uniform ${type} ${name}`;
    case 'image':
      return `image ${name}`;
    default:
      return `${type} ${name}`.trim();
  }
}

function memberAt({ outline, structs }: ShaderDocument, token: Token): { code: string; doc: string } | null {
  const index = outline.tokens.indexOf(token);
  if (outline.tokens[index - 1]?.text !== '.') return null;
  const { struct } = typeOfValue(outline, index - 2, structs);
  const member = struct?.members.get(token.text);
  return member ? { code: `${member.type} ${struct?.name}.${member.name}`, doc: member.doc } : null;
}

function builtinOf(word: string) {
  return BUILTIN_FUNCTIONS.get(word) ?? ISF_FUNCTIONS.get(word) ?? null;
}

function headerHover(document: ShaderDocument, place: Place): HoverText | null {
  const found = findName(document, place);
  if (found !== null) return { range: found.range, code: codeOf(found.name), doc: found.name.doc };
  const line = document.source.split(/\r\n|\r|\n/)[place.line - 1] ?? '';
  for (const { index, 1: word = '' } of line.matchAll(/"([A-Za-z0-9_]+)"/g)) {
    if (place.column < index + 1 || place.column > index + word.length + 3) continue;
    const doc = HEADER_KEYS.input[word] ?? HEADER_KEYS.pass[word] ?? HEADER_KEYS.root[word] ?? INPUT_TYPE_DOCS[word];
    if (doc === undefined) return null;
    const range = { start: { line: place.line, column: index + 1 }, end: { line: place.line, column: index + word.length + 3 } };
    return { range, code: '', doc };
  }
  return null;
}

/** The signatures of the function that is called around a position; null outside of calls. */
export function signatureAt(document: ShaderDocument, place: Place): SignatureHelp | null {
  if (commentAt(document.source, place) !== null) return null;
  const { tokens } = document.outline;
  let index = tokens.findIndex((token) => !isBefore(token, place)) - 1;
  if (index === -2) index = tokens.length - 1;
  let depth = 0;
  let parameter = 0;
  for (; index > 0; index -= 1) {
    const { text } = tokens[index] as Token;
    if (text === ')' || text === ']') depth += 1;
    else if (text === '[' && depth === 0) parameter = 0;
    else if (text === '(' || text === '[') {
      const callee = tokens[index - 1] as Token;
      if (depth === 0 && text === '(' && callee.kind === 'word') return helpFor(document, callee, parameter);
      if (depth === 0) parameter = 0;
      else depth -= 1;
    } else if (text === ',' && depth === 0) parameter += 1;
    else if (text === ';' || text === '{' || text === '}') return null;
  }
  return null;
}

function helpFor(document: ShaderDocument, callee: Token, parameter: number): SignatureHelp | null {
  const name = document.outline.nameAt(callee);
  const called = name ?? builtinOf(callee.text);
  if (called === null) return null;
  const signatures =
    name?.kind === 'struct'
      ? [structSignature(name)]
      : name?.kind === 'macro'
        ? called.signatures.map((signature) => ({ ...signature, label: /^\w+\([^)]*\)/.exec(signature.label)?.[0] ?? signature.label }))
        : called.signatures;
  if (signatures.every(({ parameters }) => parameters.length === 0)) return null;
  const active = signatures.findIndex(({ parameters }) => parameters.length > parameter);
  return { signatures, doc: called.doc, active: Math.max(active, 0), parameter };
}

function structSignature({ name, members }: ShaderName): NameSignature {
  const parameters = [...members.values()].map((member) => `${member.type} ${member.name}`);
  return { label: `${name} ${name}(${parameters.join(', ')})`, returns: name, parameters };
}

/** Declarations of the name at a position: in the text, its header or a chunk. An `#include` leads to its chunk. */
export function definitionsAt(document: ShaderDocument, place: Place): readonly FoundPlace[] {
  const start = { line: 1, column: 1 };
  const included = document.outline.includes.find(({ token }) => token.line === place.line);
  if (included) return [{ file: `chunks/${included.name}.glsl`, range: { start, end: start } }];
  const found = findName(document, place);
  if (found === null) {
    const token = wordAt(document, place);
    const member = token && memberToken(document, token);
    return member ? [{ file: member.file, range: rangeOf(member.token) }] : [];
  }
  return found.name.declarations.map((token) => ({ file: found.name.file, range: rangeOf(token) }));
}

function memberToken({ outline, structs }: ShaderDocument, token: Token): { file: string | null; token: Token } | null {
  const index = outline.tokens.indexOf(token);
  if (outline.tokens[index - 1]?.text !== '.') return null;
  const { struct } = typeOfValue(outline, index - 2, structs);
  const declared = struct?.members.get(token.text)?.declarations[0];
  return struct && declared ? { file: struct.file, token: declared } : null;
}

/** All uses of the name at a position in the text and header, those in the header first. */
export function referencesAt(document: ShaderDocument, place: Place): readonly TextRange[] {
  const found = findName(document, place);
  if (found === null) return [];
  return [...headerUsesOf(document, found.name).map(({ range }) => range), ...usesOf(document, found.name).map(rangeOf)];
}

/** Finds the tokens of the text that use a name. The uses of a name from elsewhere are recorded in the outline's copy of that name only. */
export function usesOf({ outline }: ShaderDocument, name: ShaderName): readonly Token[] {
  if (name.uses.length > 0) return name.uses;
  return outline.tokens.filter((token) => {
    const meant = outline.nameAt(token);
    return meant !== null && meant.name === name.name && meant.scope === null && meant.file === name.file && meant.kind === name.kind;
  });
}

/** TYPE of an input as written in the header. */
export function typeOfInput(source: string, file: string, name: string): string | null {
  const { header } = readHeader(source, file);
  const input = property(header?.root, 'INPUTS')?.children?.find((one) => textOf(property(one, 'NAME')) === name);
  return textOf(property(input, 'TYPE'));
}
