import { getLocation } from 'jsonc-parser';
import { SHADER_ENCODINGS } from '../isf/isf-shader.ts';
import type { Place } from '../syntax/token.ts';
import { TYPES } from '../syntax/words.ts';
import { BUILTIN_FUNCTIONS } from './builtin-docs.ts';
import { commentAt, type ShaderDocument } from './shader-document.ts';
import type { NameKind, ShaderName } from './shader-name.ts';
import { isBefore, offsetOf } from './source-text.ts';
import { typeOfValue } from './type-at.ts';
import { HEADER_KEYS, INPUT_TYPE_DOCS, ISF_FUNCTIONS } from './vocabulary.ts';

export interface Completion {
  readonly label: string;
  readonly kind: NameKind | 'keyword' | 'type' | 'directive' | 'key' | 'value';
  /** Type or signature. */
  readonly detail: string;
  readonly doc: string;
  /** Text to insert; `$0` is the position of the caret. */
  readonly insert: string;
  /** Order among equal matches; lower values come first. */
  readonly rank: number;
}

const DIRECTIVES = ['define', 'undef', 'if', 'ifdef', 'ifndef', 'elif', 'else', 'endif'];

const STATEMENTS: Readonly<Record<string, string>> = {
  if: 'if ($0) ',
  else: 'else ',
  for: 'for (int i = 0; i < $0; i++) ',
  while: 'while ($0) ',
  return: 'return $0;',
  break: 'break;',
  continue: 'continue;',
  discard: 'discard;',
};

const QUALIFIER_WORDS = ['const', 'in', 'out', 'inout', 'struct', 'true', 'false'];

const SWIZZLES = ['x', 'y', 'z', 'w', 'xy', 'xyz', 'r', 'g', 'b', 'a', 'rgb', 'rgba'];

/** All completions at a position. The editor filters them by the typed characters. */
export function completionsAt(document: ShaderDocument, place: Place): readonly Completion[] {
  const inside = commentAt(document.source, place);
  if (inside === 'header') return headerCompletions(document, place);
  if (inside === 'comment') return [];
  const { tokens } = document.outline;
  const behind = tokens.findIndex(
    ({ kind, line, column, text }) => kind === 'end' || !isBefore({ line, column: column + text.length - 1 }, place),
  );
  const next = behind < 0 ? tokens.length : behind;
  const touched = tokens[next - 1];
  const typing = touched?.kind === 'word' && touched.line === place.line && touched.column + touched.text.length >= place.column;
  const before = typing ? next - 2 : next - 1;
  if (tokens[before]?.text === '.') return memberCompletions(document, before);
  const { kind } = tokens[next - 1] ?? {};
  // No completions inside of a number or after its dot.
  if (
    (kind === 'float' || kind === 'int') &&
    touched &&
    touched.line === place.line &&
    touched.column + touched.text.length === place.column
  )
    return [];
  const hash = tokens[before];
  if (hash?.text === '#' && hash.startsLine && hash.line === place.line) return directiveCompletions(document);
  return [...nameCompletions(document, place), ...wordCompletions()];
}

function nameCompletions({ names }: ShaderDocument, place: Place): Completion[] {
  const seen = new Set<string>();
  const found: Completion[] = [];
  // Inner names hide outer ones.
  for (const name of [...names].reverse()) {
    // Functions that the host calls are not offered.
    if (seen.has(name.name) || name.name === 'main' || !isVisible(name, place)) continue;
    seen.add(name.name);
    found.push(ofName(name));
  }
  const functions = [...BUILTIN_FUNCTIONS.values(), ...ISF_FUNCTIONS.values()];
  for (const { name, signatures, doc } of functions) {
    if (seen.has(name)) continue;
    found.push({ label: name, kind: 'function', detail: signatures[0]?.label ?? '', doc, insert: `${name}($0)`, rank: 3 });
  }
  return found;
}

function isVisible({ scope, declarations, file }: ShaderName, place: Place): boolean {
  if (scope !== null) return !isBefore(place, scope.from) && isBefore(place, scope.to);
  const [first] = declarations;
  // Global names of the text are visible from their declaration on; those of the header and of chunks everywhere.
  return first === undefined || file !== null || !isBefore(place, first);
}

function ofName(name: ShaderName): Completion {
  const { kind, type, signatures, doc } = name;
  const called = kind === 'function' || kind === 'struct' || (kind === 'macro' && (signatures[0]?.parameters.length ?? 0) > 0);
  return {
    label: name.name,
    kind,
    detail: signatures[0]?.label ?? type,
    doc,
    insert: called && kind !== 'struct' ? `${name.name}($0)` : name.name,
    rank: name.scope !== null ? 0 : kind === 'input' || kind === 'image' ? 1 : kind === 'builtin' ? 3 : 2,
  };
}

function wordCompletions(): Completion[] {
  const word = (label: string, kind: Completion['kind'], insert = label): Completion => ({
    label,
    kind,
    detail: '',
    doc: '',
    insert,
    rank: 4,
  });
  return [
    ...Object.entries(STATEMENTS).map(([label, insert]) => word(label, 'keyword', insert)),
    ...QUALIFIER_WORDS.map((label) => word(label, 'keyword')),
    ...[...TYPES].filter((type) => !/^[iu]?sampler(?!2D$)/.test(type)).map((label) => word(label, 'type')),
  ];
}

function memberCompletions({ outline, structs }: ShaderDocument, dot: number): Completion[] {
  const { type, struct } = typeOfValue(outline, dot - 1, structs);
  if (struct !== null) return [...struct.members.values()].map((member) => ({ ...ofName(member), rank: 0 }));
  const size = /^[iub]?vec([234])$/.exec(type)?.[1];
  if (size === undefined) return [];
  const letters = new Set('xyzw'.slice(0, Number(size)) + 'rgba'.slice(0, Number(size)));
  return SWIZZLES.filter((label) => [...label].every((letter) => letters.has(letter))).map((label, i) => ({
    label,
    kind: 'member',
    detail: label.length === 1 ? 'float' : `vec${label.length}`,
    doc: '',
    insert: label,
    rank: i,
  }));
}

function directiveCompletions({ isTechnique }: ShaderDocument): Completion[] {
  const labels = isTechnique ? ['include', ...DIRECTIVES] : DIRECTIVES;
  return labels.map((label) => ({
    label,
    kind: 'directive',
    detail: '',
    doc: '',
    insert: label === 'include' ? 'include <$0>' : label,
    rank: 0,
  }));
}

function headerCompletions({ source, header, inputs, isTechnique }: ShaderDocument, place: Place): Completion[] {
  if (header === null) return [];
  const { path, isAtPropertyKey, previousNode } = getLocation(
    source.slice(header.start, header.end),
    offsetOf(source, place) - header.start,
  );
  const quoted = previousNode?.type === 'string' || previousNode?.type === 'property';
  const text = (label: string, kind: 'key' | 'value', doc: string, insert: string): Completion => ({
    label,
    kind,
    detail: '',
    doc,
    insert,
    rank: 0,
  });
  if (isAtPropertyKey) {
    const where =
      path[0] === 'INPUTS' && path.length === 3
        ? 'input'
        : path[0] === 'PASSES' && path.length === 3
          ? 'pass'
          : path.length === 1
            ? 'root'
            : null;
    if (where === null) return [];
    return Object.entries(HEADER_KEYS[where]).map(([key, doc]) => text(key, 'key', doc, quoted ? key : `"${key}": $0`));
  }
  const values = valuesAt(
    String(path.at(-1)),
    isTechnique,
    inputs.map(({ name }) => name),
  );
  return Object.entries(values).map(([value, doc]) => text(value, 'value', doc, quoted ? value : `"${value}"`));
}

function valuesAt(key: string, isTechnique: boolean, inputs: readonly string[]): Readonly<Record<string, string>> {
  switch (key) {
    case 'TYPE': {
      const types = Object.entries(INPUT_TYPE_DOCS);
      return Object.fromEntries(
        isTechnique ? types.filter(([type]) => ['bool', 'long', 'float', 'point2D', 'color', 'image'].includes(type)) : types,
      );
    }
    case 'UNIT':
      return {
        m: 'Meters',
        s: 'Seconds',
        rad: 'Radians; shown in degrees',
        px: 'Pixels',
        K: 'Kelvin',
        Hz: 'Hertz',
        cd: 'Candela',
        ratio: 'Shown in percent',
        none: '',
      };
    case 'HANDLE':
      return {
        center: 'A point of the image',
        extent: 'Radius of a circle around the center, in pixels',
        angle: 'Angle around the center',
        low: 'Bottom left corner of a rectangle',
        high: 'Top right corner of a rectangle',
        size: 'Width and height around the center, as fractions of the height of the layer',
        feather: 'Width of a soft edge, as a fraction of the height of the layer',
      };
    case 'SCRIM_ALPHA':
      return { straight: '', premultiplied: '' };
    case 'SCRIM_DEPTH':
      return { auto: '', same: '', none: '', over: '', nearer: '' };
    case 'SCRIM_ENCODING':
      return Object.fromEntries(SHADER_ENCODINGS.map((word) => [word, '']));
    case 'SIDE':
      return { object: 'As the object says', front: '', back: '', both: '', edges: 'Silhouettes, creases and borders as lines' };
    case 'WIDTH':
    case 'HEIGHT':
      return Object.fromEntries(['WIDTH', 'HEIGHT', ...inputs].map((name) => [`$${name}`, '']));
    default:
      return {};
  }
}
