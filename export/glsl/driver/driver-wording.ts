import { authorsNames } from '../link/names.ts';

/** The author's names for the linker's functions and variables. */
const AUTHORS_NAMES: ReadonlyMap<string, string> = new Map([
  ['scrim_uv', 'isf_FragNormCoord'],
  ['scrim_normCoord', 'isf_FragNormCoord'],
  ['scrim_fragCoord', 'gl_FragCoord'],
  ['scrim_fragColor', 'gl_FragColor'],
  ['scrim_choose', '?:'],
  ['assign', '='],
]);

const VECTORS: Readonly<Record<string, string>> = { float: 'vec', int: 'ivec', uint: 'uvec', bool: 'bvec' };

/** Remedies for the most common driver messages. */
const FIXES: readonly (readonly [words: RegExp, fix: string])[] = [
  [/undeclared/i, 'Check its spelling, capitals included, or declare it above.'],
  [/no matching (?:overloaded )?function/i, 'Check the number and types of the arguments.'],
  [
    /wrong operand types|cannot convert|could not implicitly convert|operands? .*(?:must|type)/i,
    'Give both sides the same type: float(x), vec3(x), x.rgb.',
  ],
  [/syntax error|unexpected/i, 'Check for a missing or extra bracket, comma or semicolon here or just before.'],
  [/redefinition|redeclared/i, 'Choose another name: this one is already declared.'],
  [/l-value|read-?only|can't modify/i, 'Copy it into a local variable first: it is read-only.'],
  [/field selection|swizzle/i, 'Check its number of components: a vec3 has x, y and z, or r, g and b.'],
];

export function fixFor(message: string): string | undefined {
  return FIXES.find(([words]) => words.test(message))?.[1];
}

export function authorsWord(printed: string): string {
  return AUTHORS_NAMES.get(printed) ?? authorsNames(printed)[0] ?? printed;
}

/** Replaces printed names by the author's in a driver's message. Precisions are removed, because all are highp. */
export function inAuthorsWords(message: string): string {
  return message
    .trim()
    .replace(/\b(?:highp|mediump|lowp)\s+/g, '')
    .replace(/\b([234])-component vector of (float|int|uint|bool)\b/g, (_, size: string, of: string) => `${VECTORS[of]}${size}`)
    .replace(/\b([234])X([234]) matrix of float\b/g, (_, columns: string, rows: string) =>
      columns === rows ? `mat${columns}` : `mat${columns}x${rows}`,
    )
    .replace(/structure '([^']*)' \(symbol id \d+\)/g, '$1')
    .replace(/ ?\(symbol id \d+\)/g, '')
    .replace(/\barray\[(\d+)\] of ([^']+)/g, '$2[$1]')
    .replace(/'(?:const|uniform|in|out|inout|global|varying|smooth in) ([^']+)'/g, "'$1'")
    .replace(
      /wrong operand types - no operation '[^']*' exists that takes a left-hand operand of type '([^']*)' and a right operand of type '([^']*)'.*$/,
      'wrong operand types: $1 and $2 cannot be combined',
    )
    .replace(
      /wrong operand type - no operation '[^']*' exists that takes an operand of type ([^(]*?)(?: \(or.*)?$/,
      'wrong operand type: the operator does not take $1',
    )
    .replace(/cannot convert from '([^']*)' to '([^']*)'/g, 'cannot convert from $1 to $2')
    .replace(/\b(?:[a-z]\d*_[A-Za-z]\w*|scrim_\w+)\b/g, authorsWord);
}
