/** The units that a placeholder can name: the factor from meters, radians or ratios, and the text after the number. */
const UNITS: Readonly<Record<string, { readonly factor: number; readonly suffix: string }>> = {
  mm: { factor: 1000, suffix: ' mm' },
  cm: { factor: 100, suffix: ' cm' },
  m: { factor: 1, suffix: ' m' },
  km: { factor: 0.001, suffix: ' km' },
  // The international inch and foot (1959).
  in: { factor: 1 / 0.0254, suffix: ' in' },
  ft: { factor: 1 / 0.3048, suffix: ' ft' },
  '°': { factor: 180 / Math.PI, suffix: '°' },
  '%': { factor: 100, suffix: ' %' },
};

const MAX_DECIMALS = 10;
const NOT_A_NUMBER = '–';

/** A piece of a template: words, the text input, or a number. */
export type Piece = { readonly kind: 'words'; readonly words: string } | { readonly kind: 'text' } | NumberPiece;

/** A placeholder for a number, and how the number is written. */
export interface NumberPiece {
  readonly kind: 'number';
  readonly name: string;
  readonly decimals: number;
  readonly factor: number;
  readonly suffix: string;
}

/** A template split into pieces. `unknown` lists the placeholders that cannot be read; they stay in the text unchanged. */
export interface Template {
  readonly pieces: readonly Piece[];
  readonly unknown: readonly string[];
}

/**
 * Reads a template of texts and numbers. With the names `a` and `b`: `{a}`, `{a:2}` (two decimals), `{a:cm}`, `{a:2 cm}` (a length in
 * meters as centimeters with the unit), `{text}`, and `{{` for a brace. Units: mm, cm, m, km, in and ft of meters, ° of radians, % of
 * ratios.
 *
 * @param names The names that stand for a number.
 * @param decimals Digits after the decimal mark if a placeholder does not say how many.
 *
 * @example
 * readTemplate('{a:1 cm}', ['a'], 2).pieces; // one number piece: factor 100, one decimal, ' cm'
 */
export function readTemplate(template: string, names: readonly string[], decimals: number): Template {
  const pieces: Piece[] = [];
  const unknown: string[] = [];
  let words = '';
  for (const [whole, inside] of template.matchAll(/\{\{|\{([^{}]*)\}|[^{]+|\{/g)) {
    const piece = inside === undefined ? null : readPlaceholder(inside.trim(), names, decimals);
    if (piece === null) {
      words += whole === '{{' ? '{' : whole;
      if (inside !== undefined) unknown.push(whole);
      continue;
    }
    if (words !== '') pieces.push({ kind: 'words', words });
    words = '';
    pieces.push(piece);
  }
  if (words !== '') pieces.push({ kind: 'words', words });
  return { pieces, unknown };
}

/** Fills the numbers and the text input into a template; `createTextWriter` creates it. */
export interface TextWriter {
  /** Placeholders that cannot be read. They stay in the text unchanged. */
  readonly unknown: readonly string[];
  /**
   * Takes the current numbers, and rounds them as they will be written. Returns whether the text of one of them has changed. Allocates
   * nothing.
   */
  round(numberOf: (name: string) => number): boolean;
  /** Returns the template with the numbers of the last `round` and the text input. */
  write(text: string): string;
}

/**
 * Creates a writer of numbers into a template. Numbers have no group separators, and those that are not finite are written as –.
 *
 * @param names The names that stand for a number.
 * @param decimals Digits after the decimal mark if a placeholder does not say how many.
 * @param language The language whose decimal mark is used (BCP 47); undefined is the visitor's.
 *
 * @example
 * const writer = createTextWriter('{a:2 m}', ['a'], 2, 'en');
 * if (writer.round(() => lengthM)) result.value = writer.write('');
 */
export function createTextWriter(template: string, names: readonly string[], decimals: number, language: string | undefined): TextWriter {
  const { pieces, unknown } = readTemplate(template, names, decimals);
  const formats = pieces.map((piece) => (piece.kind === 'number' ? numberFormat(piece.decimals, language) : null));
  const rounded = new Float64Array(pieces.length);
  return {
    unknown,
    round: (numberOf) => {
      let changed = false;
      for (let i = 0; i < pieces.length; i++) {
        const piece = pieces[i];
        if (piece?.kind !== 'number') continue;
        const scale = 10 ** piece.decimals;
        // Plus 0: -0 would be written with its sign.
        const value = Math.round(numberOf(piece.name) * piece.factor * scale) / scale + 0;
        changed ||= !Object.is(value, rounded[i]);
        rounded[i] = value;
      }
      return changed;
    },
    write: (text) => {
      let words = '';
      for (let i = 0; i < pieces.length; i++) {
        const piece = pieces[i];
        if (piece?.kind === 'words') words += piece.words;
        else if (piece?.kind === 'text') words += text;
        else if (piece) words += writeNumber(rounded[i] ?? 0, formats[i] ?? null) + piece.suffix;
      }
      return words;
    },
  };
}

function numberFormat(digits: number, language: string | undefined): Intl.NumberFormat {
  const options = { minimumFractionDigits: digits, maximumFractionDigits: digits, useGrouping: false } as const;
  return new Intl.NumberFormat(language, options);
}

function writeNumber(value: number, format: Intl.NumberFormat | null): string {
  return Number.isFinite(value) && format ? format.format(value) : NOT_A_NUMBER;
}

function readPlaceholder(inside: string, names: readonly string[], decimals: number): Piece | null {
  if (inside === 'text') return { kind: 'text' };
  const [, name = '', digits, unit = ''] = /^(\w+)(?:\s*:\s*(\d*)\s*(mm|cm|m|km|in|ft|°|%)?)?$/.exec(inside) ?? [];
  if (!names.includes(name)) return null;
  const { factor, suffix } = UNITS[unit] ?? { factor: 1, suffix: '' };
  const wanted = digits === undefined || digits === '' ? decimals : Number(digits);
  return { kind: 'number', name, decimals: Math.min(MAX_DECIMALS, wanted), factor, suffix };
}
