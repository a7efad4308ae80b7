import { hasErrors } from '../../../nodes/kit/diagnostics.ts';
import { INPUT_TYPES } from '../isf/given-symbols.ts';
import { findHeader, readHeader } from '../isf/isf-header.ts';
import type { IsfInput } from '../isf/isf-shader.ts';
import { readInputs } from '../isf/read-inputs.ts';
import type { Place, Token } from '../syntax/token.ts';
import { TECHNIQUE_INTERFACE } from '../technique/interface.ts';
import { isTechnique as holdsTechnique } from '../technique/technique-shader.ts';
import { type HeaderName, readHeaderNames } from './header-names.ts';
import { readOutline } from './outline.ts';
import type { Outline, ShaderName } from './shader-name.ts';
import { offsetOf, type TextRange, touches } from './source-text.ts';
import { ISF_VARIABLES, TECHNIQUE_DOCS, VERTEX_VARIABLES } from './vocabulary.ts';

/** A shader as analyzed for the code editor. Lines and columns count from 1. */
export interface ShaderDocument {
  readonly file: string;
  readonly source: string;
  readonly outline: Outline;
  /** All visible names, the innermost last. */
  readonly names: readonly ShaderName[];
  readonly structs: ReadonlyMap<string, ShaderName>;
  readonly inputs: readonly IsfInput[];
  readonly headerNames: readonly HeaderName[];
  /** Offsets of the JSON without its comment marks; null without a header. */
  readonly header: { readonly start: number; readonly end: number } | null;
  readonly isTechnique: boolean;
}

export interface DocumentOptions {
  /** Returns the text of a chunk, `chunks/NAME.glsl`, by its name. */
  readonly chunkOf: (name: string) => string | undefined;
  /** The previous version of the file, whose inputs are used while the header is invalid. */
  readonly before?: ShaderDocument;
  /** For a vertex shader `edge.vs`: its fragment shader, whose header applies to both. */
  readonly fragment?: NeighborFile | undefined;
}

export interface NeighborFile {
  readonly file: string;
  readonly source: string;
}

/** Analyzes a text, even if it is incomplete. */
export function readShaderDocument(source: string, file: string, { chunkOf, before, fragment }: DocumentOptions): ShaderDocument {
  const { header, diagnostics } = readHeader(fragment?.source ?? source, fragment?.file ?? file);
  const read = header === null ? [] : readInputs(header);
  const inputs = before !== undefined && hasErrors(diagnostics) ? before.inputs : read;
  const headerNames = header === null ? [] : readHeaderNames(header);
  const isTechnique = holdsTechnique(source, file);
  const host = isTechnique ? techniqueNames() : fragment ? vertexNames() : isfNames();
  const fromHeader = [...imageNames(headerNames, inputs), ...inputs.map((input) => inputName(input, headerNames))];
  const given = [...host, ...fromHeader.map((name) => (fragment ? { ...name, file: fragment.file } : name))];
  given.push(...chunkNames(source, given, chunkOf));
  const outline = readOutline(source, given);
  const own = outline.names.filter(({ kind }) => kind !== 'member');
  const ownNames = new Set(own.filter(({ scope }) => scope === null).map(({ name }) => name));
  const names = [...given.filter(({ name }) => !ownNames.has(name)), ...own];
  const structs = new Map(names.filter(({ kind }) => kind === 'struct').map((struct) => [struct.name, struct]));
  const ownHeader = fragment ? { headerNames: [], header: null } : { headerNames, header: findJson(source) };
  return { file, source, outline, names, structs, inputs, ...ownHeader, isTechnique };
}

function isfNames(): ShaderName[] {
  return [...ISF_VARIABLES].map(([name, { type, doc }]) => givenName('builtin', name, type, doc));
}

function vertexNames(): ShaderName[] {
  const starts = ['isf_vertShaderInit', 'vv_vertShaderInit'].map((name) => ({
    ...givenName('function', name, 'void', 'Sets gl_Position and isf_FragNormCoord for this corner: call it first.'),
    signatures: [{ label: `void ${name}()`, returns: 'void', parameters: [] }],
  }));
  return [...starts, ...[...VERTEX_VARIABLES].map(([name, { type, doc }]) => givenName('builtin', name, type, doc))];
}

function techniqueNames(): ShaderName[] {
  const documented = (name: ShaderName): ShaderName => ({
    ...name,
    kind: name.kind === 'variable' ? 'builtin' : name.kind,
    doc: TECHNIQUE_DOCS.get(name.name) ?? '',
    declarations: [],
    members: new Map([...name.members].map(([key, member]) => [key, documented(member)])),
  });
  return readOutline(TECHNIQUE_INTERFACE)
    .names.filter(({ kind }) => kind !== 'member' && kind !== 'parameter')
    .map(documented);
}

/** Names of buffers and images. */
function imageNames(headerNames: readonly HeaderName[], inputs: readonly IsfInput[]): ShaderName[] {
  const isInput = new Set(inputs.map(({ name }) => name));
  return headerNames
    .filter(({ role, name }) => (role === 'target' || role === 'imported') && !isInput.has(name))
    .map((found) => {
      const doc = found.role === 'target' ? 'A buffer of this effect that one of its passes draws.' : 'An image of this effect.';
      return { ...givenName('image', found.name, 'sampler2D', doc), declarations: [tokenAt(found)] };
    });
}

function inputName(input: IsfInput, headerNames: readonly HeaderName[]): ShaderName {
  const type = INPUT_TYPES[input.type];
  const place = headerNames.find(({ role, name }) => role === 'input' && name === input.name);
  const name = givenName(type === 'sampler2D' ? 'image' : 'input', input.name, type, describeInput(input));
  return place === undefined ? name : { ...name, declarations: [tokenAt(place)] };
}

/** Describes an input in Markdown: `**Strength** · float, 0 to 1, starts at 0.5`, followed by its DOC. */
export function describeInput({ label, type, min, max, default: start, doc, choices, unit }: IsfInput): string {
  const written = (numbers: readonly number[]) => (numbers.length === 1 ? String(numbers[0]) : `(${numbers.join(', ')})`);
  const facts = [type === 'long' && choices.length > 0 ? choices.map((choice) => `${choice.value} ${choice.label}`).join(', ') : type];
  if (min !== null && max !== null) facts.push(`${written(min)} to ${written(max)}`);
  if (start.length > 0) facts.push(`starts at ${type === 'bool' ? start[0] !== 0 : written(start)}`);
  if (unit !== 'none') facts.push(`in ${unit}`);
  return [`**${label}** · ${facts.join(' · ')}`, doc].filter(Boolean).join('\n\n');
}

/** Global names of the included chunks, each with its file. */
function chunkNames(source: string, given: readonly ShaderName[], chunkOf: DocumentOptions['chunkOf']): ShaderName[] {
  const found: ShaderName[] = [];
  const seen = new Set<string>();
  const add = (text: string) => {
    for (const { name } of readOutline(text).includes) {
      const chunk = seen.has(name) ? undefined : chunkOf(name);
      seen.add(name);
      if (chunk === undefined) continue;
      add(chunk);
      const shared = readOutline(chunk, [...given, ...found]).names.filter(({ kind, scope }) => kind !== 'member' && scope === null);
      found.push(...shared.map((one) => ({ ...one, file: `chunks/${name}.glsl`, uses: [] })));
    }
  };
  if (source.includes('#')) add(source);
  return found;
}

function givenName(kind: ShaderName['kind'], name: string, type: string, doc: string): ShaderName {
  return { kind, name, type, file: null, doc, declarations: [], uses: [], signatures: [], members: new Map(), scope: null };
}

function tokenAt({ name, range }: HeaderName): Token {
  return { kind: 'word', text: name, ...range.start, startsLine: false, spaced: false, hidden: null };
}

function findJson(source: string): ShaderDocument['header'] {
  const open = findHeader(source);
  if (open < 0) return null;
  const close = source.indexOf('*/', open + 2);
  return { start: open + 2, end: close < 0 ? source.length : close };
}

/** A name at a position. */
export interface Found {
  readonly name: ShaderName;
  readonly range: TextRange;
}

/** The name at a position in the GLSL or in the header. */
export function findName(document: ShaderDocument, place: Place): Found | null {
  const token = wordAt(document, place);
  const named = token && nameOf(document, token);
  if (token && named) return { name: named, range: { start: token, end: { line: token.line, column: token.column + token.text.length } } };
  const inHeader = document.headerNames.find(({ range }) => touches(range, place));
  const name = inHeader && document.names.find((one) => one.name === inHeader.name && isFromHeader(one));
  return inHeader && name ? { name, range: inHeader.range } : null;
}

export function isFromHeader({ kind, file, declarations }: ShaderName): boolean {
  return file === null && (kind === 'input' || kind === 'image') && declarations.length > 0;
}

/** The name of a token. Members after a dot are not resolved here. */
export function nameOf({ outline, names }: ShaderDocument, token: Token): ShaderName | null {
  const meant = outline.nameAt(token);
  if (meant === null) return null;
  // Names from elsewhere are copied for each analysis; the outline has the copy with the uses in this text.
  const known = names.find((name) => name.name === meant.name && name.file === meant.file && name.scope === null && meant.scope === null);
  return known && known.declarations.length > 0 && meant.declarations.length === 0 ? { ...meant, declarations: known.declarations } : meant;
}

/** The word around a position or next to it. */
export function wordAt({ outline: { tokens } }: ShaderDocument, place: Place): Token | null {
  return (
    tokens.find(
      (token) =>
        token.kind === 'word' &&
        token.line === place.line &&
        token.column <= place.column &&
        place.column <= token.column + token.text.length,
    ) ?? null
  );
}

/** Uses of the name in the header. */
export function headerUsesOf({ headerNames }: ShaderDocument, name: ShaderName): readonly HeaderName[] {
  return isFromHeader(name) ? headerNames.filter((one) => one.name === name.name) : [];
}

/** Whether a position is in the header or in another comment. */
export function commentAt(source: string, place: Place): 'header' | 'comment' | null {
  const offset = offsetOf(source, place);
  const header = findJson(source);
  if (header !== null && offset >= header.start && offset <= header.end) return 'header';
  for (const { index, 0: text } of source.matchAll(/\/\/[^\r\n]*|\/\*[\s\S]*?(?:\*\/|$)/g)) {
    if (offset > index + 1 && (offset < index + text.length || (text.startsWith('//') && offset === index + text.length))) return 'comment';
  }
  return null;
}
