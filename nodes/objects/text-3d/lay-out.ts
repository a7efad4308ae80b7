import { charactersOf } from '../../kit/glyphs.ts';
import type { Letter, PlacedLetter } from './letters.ts';

/** The most characters of a text. Longer texts are slow to draw and easier to read on a Label. */
export const MAX_CHARACTERS = 200;

export interface LayoutOptions {
  readonly align: 'left' | 'center' | 'right';
  readonly vertical: 'baseline' | 'middle' | 'top';
  /** Distance between baselines, as a multiple of the height of a capital letter. */
  readonly lineHeight: number;
  readonly spacing: number;
}

/** The letters of a text with their positions. The unit is the height of a capital letter. */
export interface LaidOut {
  readonly placed: readonly PlacedLetter[];
  /** The characters that the font has no letter for, each once. */
  readonly missing: readonly string[];
  /** Whether the text was cut off after `MAX_CHARACTERS`. */
  readonly cut: boolean;
}

/** Lays out a text, whose lines `\n` separates. */
export function layOut(text: string, letterOf: (character: string) => Letter | null, options: LayoutOptions): LaidOut {
  const { align, vertical, lineHeight, spacing } = options;
  const all = charactersOf(text.replaceAll('\\n', '\n'));
  const cut = all.length > MAX_CHARACTERS;
  const lines = all.slice(0, MAX_CHARACTERS).join('').split('\n');
  const missing = new Set<string>();
  const below = (lines.length - 1) * lineHeight;
  const firstBaseline = vertical === 'baseline' ? below : vertical === 'middle' ? (below - 1) / 2 : -1;
  const placed = lines.flatMap((line, row) => {
    const letters = charactersOf(line).flatMap((character) => {
      const letter = letterOf(character);
      if (!letter) missing.add(character);
      return letter ?? [];
    });
    const width = letters.reduce((sum, { advance }) => sum + advance + spacing, 0) - (letters.length > 0 ? spacing : 0);
    let x = align === 'left' ? 0 : align === 'center' ? -width / 2 : -width;
    return letters.map((letter) => {
      const at = x;
      x += letter.advance + spacing;
      return { letter, x: at, y: firstBaseline - row * lineHeight };
    });
  });
  return { placed: placed.filter(({ letter }) => letter.positions.length > 0), missing: [...missing], cut };
}
