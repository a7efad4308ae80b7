/**
 * Outlines of a font, stored as text. A program contains only the glyphs that its texts may show. The first line has the height of a
 * capital letter, the ascender and the descender. Each other line has a character, its advance, and its path in the commands M, L, Q, C
 * and Z of SVG. Fields are separated by tabs. Numbers are in font units, y up.
 */

/** Outlines of glyphs after reading, and the metrics of their font. */
export interface Glyphs {
  readonly capitalHeight: number;
  readonly ascender: number;
  /** The lowest point of glyphs below the baseline, font units; negative. */
  readonly descender: number;
  readonly byCharacter: ReadonlyMap<string, Glyph>;
}

/** A character of a font. */
export interface Glyph {
  /** Distance to the origin of the next character. */
  readonly advance: number;
  /** Outline of the character: SVG path commands with absolute coordinates, such as `M0 0L10 0Q…Z`. */
  readonly path: string;
}

/**
 * The part of a font that a text needs. Characters that the font lacks are left out.
 *
 * @param font The outlines of all characters.
 * @param text In any order, with repetitions.
 * @returns Outlines in the same form, in the order of the font.
 *
 * @example
 * subsetGlyphs(library.shader('fonts/inter'), '1.20 m'); // six glyphs: 1 . 2 0, the space and m
 */
export function subsetGlyphs(font: string, text: string): string {
  const wanted = new Set(charactersOf(text));
  const [head = '', ...lines] = font.split('\n');
  return [head, ...lines.filter((line) => wanted.has(line.slice(0, line.indexOf('\t'))))].join('\n');
}

/**
 * Reads outlines.
 *
 * @throws Error if the text is not in the form of this module.
 *
 * @example
 * const { byCharacter } = readGlyphs(ctx.config.characters);
 */
export function readGlyphs(outlines: string): Glyphs {
  const [head = '', ...lines] = outlines.split('\n');
  const [capitalHeight = Number.NaN, ascender = Number.NaN, descender = Number.NaN] = head.split('\t').map(Number);
  if (!Number.isFinite(capitalHeight + ascender + descender)) throw new Error('The outlines have no sizes in their first line.');
  const byCharacter = new Map<string, Glyph>();
  for (const line of lines) {
    const [character = '', advance = '', path = ''] = line.split('\t');
    byCharacter.set(character, { advance: Number(advance), path });
  }
  return { capitalHeight, ascender, descender, byCharacter };
}

/**
 * Splits a text into the characters that a font has: composed (NFC), one per code point.
 *
 * @example
 * charactersOf('e\u0301'); // ['é']
 */
export function charactersOf(text: string): string[] {
  return [...text.normalize('NFC')];
}
