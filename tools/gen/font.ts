import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import type { ShaderFile } from './find-nodes.ts';

/** The parts of opentype.js that are read here. */
interface Font {
  readonly ascender: number;
  readonly descender: number;
  readonly tables: {
    readonly os2?: { readonly sCapHeight: number };
    readonly cmap?: { readonly glyphIndexMap: Readonly<Record<string, number>> };
  };
  charToGlyph(character: string): { readonly advanceWidth: number; readonly path: { readonly commands: readonly PathCommand[] } };
}

interface PathCommand {
  readonly type: 'M' | 'L' | 'Q' | 'C' | 'Z';
  readonly x?: number;
  readonly y?: number;
  readonly x1?: number;
  readonly y1?: number;
  readonly x2?: number;
  readonly y2?: number;
}

/** Name of the font in the library, as node definitions give it. */
const NAME = 'fonts/inter';
/** Weight of the font, SemiBold: thin strokes are lost in a headset, bold letters fill up when they are extruded. */
const WEIGHT = 600;
/** The files of the font, one per script. A character that is in several files is read from the first. */
const SUBSETS = ['latin', 'latin-ext', 'greek', 'cyrillic', 'vietnamese'] as const;
/** Characters of today's languages; `latin-ext` also has hundreds of phonetic and historical ones. */
const KEPT =
  /[\u0020-\u007e\u00a0-\u017f\u0218-\u021b\u0384-\u03ce\u0400-\u045f\u0490\u0491\u1e9e\u1ea0-\u1ef9\u2010-\u2044\u20a0-\u20bf\u2100-\u2199\u2200-\u2265]/;

/**
 * The glyphs of the bundled font, as a text file of the library from which the compiler takes the glyphs that a program uses. The first
 * line has the cap height, the ascender and the descender. Each other line has a character, its advance width and its outline as an SVG
 * path. All numbers are in font units, with y up.
 *
 * Kerning is missing, because opentype.js does not read the lookups of this font that contain it.
 */
export async function fontLibrary(): Promise<ShaderFile> {
  // opentype.js has no types and no named exports.
  const requireFrom = createRequire(import.meta.url);
  const { parse } = requireFrom('opentype.js') as { parse(buffer: ArrayBufferLike): Font };
  const glyphs = new Map<string, string>();
  let head = '';
  for (const subset of SUBSETS) {
    const bytes = await readFile(requireFrom.resolve(`@fontsource/inter/files/inter-${subset}-${WEIGHT}-normal.woff`));
    const font = parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
    head ||= [font.tables.os2?.sCapHeight, font.ascender, font.descender].join('\t');
    for (const code of Object.keys(font.tables.cmap?.glyphIndexMap ?? {})) {
      const character = String.fromCodePoint(Number(code));
      if (!KEPT.test(character) || glyphs.has(character)) continue;
      const { advanceWidth, path } = font.charToGlyph(character);
      glyphs.set(character, `${character}\t${advanceWidth}\t${path.commands.map(print).join('')}`);
    }
  }
  const lines = [...glyphs].sort(([a], [b]) => (a < b ? -1 : 1)).map(([, line]) => line);
  return { name: NAME, text: [head, ...lines].join('\n') };
}

function print(command: PathCommand): string {
  const { type, x1, y1, x2, y2, x, y } = command;
  return `${type}${[x1, y1, x2, y2, x, y].filter((value) => value !== undefined).join(' ')}`;
}
