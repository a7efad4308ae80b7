import { describe, expect, test } from '@jest/globals';
import { FONT_PX, layOutLabel, MAX_CHARACTERS, shorten } from './layout.ts';

/** A font in which every character is half as wide as high, and ideographs are square. */
const measure = (text: string) => [...text].reduce((sum, c) => sum + (/\p{Script=Han}/u.test(c) ? FONT_PX : FONT_PX / 2), 0);

function lines(text: string, widthEm: number, title = '') {
  const layout = layOutLabel({ title, text, hasIcon: false, maxWidthPx: widthEm * FONT_PX }, measure);
  return layout.lines.map((line) => line.text);
}

describe('the layout of a label', () => {
  test('breaks lines at spaces and line ends, and long words where they are full', () => {
    expect(lines('one two three', 4)).toEqual(['one two', 'three']);
    expect(lines('one\\ntwo', 10)).toEqual(['one', 'two']);
    expect(lines('aaaaaaaaaaaa', 3)).toEqual(['aaaaaa', 'aaaaaa']);
    expect(lines('', 10)).toEqual([]);
    expect(lines('x', 10, 'Title')).toEqual(['Title', 'x']);
  });

  test('breaks scripts without spaces between characters, and keeps a mark with the one before it', () => {
    expect(lines('東京都庁舎', 3)).toEqual(['東京都', '庁舎']);
    expect(lines('東京都。庁舎', 3)).toEqual(['東京', '都。庁', '舎']);
  });

  test('lines of right-to-left scripts end at the right edge', () => {
    const layout = layOutLabel({ title: 'abcdef', text: 'שלום', hasIcon: true, maxWidthPx: 400 }, measure);
    const [title, text] = layout.lines;
    expect([title?.direction, text?.direction]).toEqual(['ltr', 'rtl']);
    expect((text?.xPx ?? 0) + (text?.widthPx ?? 0)).toBe((title?.xPx ?? 0) + (title?.widthPx ?? 0));
    expect(title?.xPx).toBeGreaterThan((layout.icon?.xPx ?? 0) + (layout.icon?.sizePx ?? 0));
  });

  test('the card contains all lines', () => {
    const {
      widthPx,
      heightPx,
      lines: all,
    } = layOutLabel({ title: 'T', text: 'one two three four', hasIcon: true, maxWidthPx: 100 }, measure);
    for (const { xPx, topPx, widthPx: width } of all) {
      expect(xPx + width).toBeLessThan(widthPx);
      expect(topPx).toBeGreaterThan(0);
      expect(topPx + 42).toBeLessThan(heightPx);
    }
  });

  test('a text of 10,000 characters is cut between graphemes, with an ellipsis', () => {
    expect(shorten('short')).toBe('short');
    const cut = shorten('👩‍👩‍👧‍👦'.repeat(1000));
    expect(cut.length).toBeLessThanOrEqual(MAX_CHARACTERS);
    expect(cut).toMatch(/^(👩‍👩‍👧‍👦)+…$/u);
  });
});
