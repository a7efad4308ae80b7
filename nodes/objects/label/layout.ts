/** Size of the font in label pixels. The size of a label in the room or on the screen is that of its font. */
export const FONT_PX = 32;
const LINE_PX = 42;
const PADDING_PX = 18;
const ICON_PX = 40;
const GAP_PX = 14;

/** The most characters of a label. Longer texts are shortened, because a label of a whole page is slow to draw and hides the room. */
export const MAX_CHARACTERS = 280;

/** The content of a label that is to be laid out. */
export interface LabelContent {
  readonly title: string;
  readonly text: string;
  readonly hasIcon: boolean;
  /** Width at which lines are broken, label pixels. */
  readonly maxWidthPx: number;
}

/** A line of text; label pixels from the upper left corner, y down. */
export interface LabelLine {
  readonly text: string;
  readonly isTitle: boolean;
  /** Position and width of the line's box, which is as wide as its text. */
  readonly xPx: number;
  readonly topPx: number;
  readonly widthPx: number;
  /** The direction of the line's text, decided by its first letter with a direction, as in HTML's `dir="auto"`. */
  readonly direction: 'ltr' | 'rtl';
}

/** The layout of a label, from which the page and the texture draw it. */
export interface LabelLayout {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly lines: readonly LabelLine[];
  /** The square of the icon; null if there is no icon. */
  readonly icon: { readonly xPx: number; readonly yPx: number; readonly sizePx: number } | null;
}

/** A function that returns the width of a text in label pixels. */
export type MeasureText = (text: string, isTitle: boolean) => number;

export const LINE_HEIGHT_PX = LINE_PX;

/** Cuts a text that is too long, between two graphemes. */
export function shorten(text: string): string {
  if (text.length <= MAX_CHARACTERS) return text;
  let cut = '';
  for (const { segment } of new Intl.Segmenter().segment(text.slice(0, 4 * MAX_CHARACTERS))) {
    if (cut.length + segment.length >= MAX_CHARACTERS) break;
    cut += segment;
  }
  return `${cut.trimEnd()}…`;
}

/** Breaks title and text into lines and positions them in a column beside the icon. */
export function layOutLabel({ title, text, hasIcon, maxWidthPx }: LabelContent, measure: MeasureText): LabelLayout {
  const left = PADDING_PX + (hasIcon ? ICON_PX + GAP_PX : 0);
  const room = Math.max(FONT_PX, maxWidthPx);
  const rows = [
    ...breakLines(title, room, (words) => measure(words, true)).map((words) => ({ words, isTitle: true })),
    ...breakLines(text, room, (words) => measure(words, false)).map((words) => ({ words, isTitle: false })),
  ];
  const widths = rows.map(({ words, isTitle }) => Math.ceil(measure(words, isTitle)));
  const column = Math.max(0, ...widths);
  const contentHeight = Math.max(rows.length * LINE_PX, hasIcon ? ICON_PX : 0);
  const firstTop = PADDING_PX / 2 + (contentHeight - rows.length * LINE_PX) / 2;
  const heightPx = contentHeight + PADDING_PX;
  return {
    widthPx: left + column + PADDING_PX,
    heightPx,
    lines: rows.map(({ words, isTitle }, i) => {
      const direction = directionOf(words);
      const widthPx = widths[i] ?? 0;
      const xPx = direction === 'rtl' ? left + column - widthPx : left;
      return { text: words, isTitle, xPx, topPx: firstTop + i * LINE_PX, widthPx, direction };
    }),
    icon: hasIcon ? { xPx: PADDING_PX, yPx: (heightPx - ICON_PX) / 2, sizePx: ICON_PX } : null,
  };
}

/**
 * Breaks a text into lines: at its line ends, at spaces, and between the characters of scripts without spaces and of words that are too
 * long.
 */
function breakLines(text: string, maxWidthPx: number, measure: (words: string) => number): string[] {
  if (text.trim() === '') return [];
  return text
    .replaceAll('\\n', '\n')
    .split('\n')
    .flatMap((paragraph) => breakParagraph(paragraph.trim(), maxWidthPx, measure));
}

function breakParagraph(paragraph: string, maxWidthPx: number, measure: (words: string) => number): string[] {
  if (measure(paragraph) <= maxWidthPx) return [paragraph];
  const lines: string[] = [];
  let line = '';
  for (const piece of piecesOf(paragraph)) {
    const longer = line + piece;
    if (line !== '' && measure(longer.trimEnd()) > maxWidthPx) {
      lines.push(line.trimEnd());
      line = piece.trimStart();
    } else {
      line = longer;
    }
    while (measure(line.trimEnd()) > maxWidthPx && [...line].length > 1) {
      const fits = longestStart(line, maxWidthPx, measure);
      lines.push(fits);
      line = line.slice(fits.length);
    }
  }
  if (line.trim() !== '') lines.push(line.trimEnd());
  return lines;
}

/** Splits a paragraph into the pieces between which lines may break: words with the space after them, and single ideographs and kana. */
function piecesOf(paragraph: string): string[] {
  return (
    paragraph.match(
      /[\p{Script=Han}\p{Script=Hiragana}\p{Script=Katakana}][、。，．」』）！？]*\s*|[^\s\p{Script=Han}\p{Script=Hiragana}\p{Script=Katakana}]+\s*|\s+/gu,
    ) ?? []
  );
}

function longestStart(line: string, maxWidthPx: number, measure: (words: string) => number): string {
  let start = '';
  for (const { segment } of new Intl.Segmenter().segment(line)) {
    if (start !== '' && measure(start + segment) > maxWidthPx) break;
    start += segment;
  }
  return start;
}

function directionOf(text: string): 'ltr' | 'rtl' {
  const letter = /\p{L}/u.exec(text)?.[0] ?? '';
  return /[\p{Script=Hebrew}\p{Script=Arabic}\p{Script=Syriac}\p{Script=Thaana}\p{Script=Nko}]/u.test(letter) ? 'rtl' : 'ltr';
}
