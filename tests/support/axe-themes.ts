import { expect, test } from '@jest/globals';
import { axeFindings } from './axe.ts';
import type { OpenEditor } from './open-editor.ts';

/** Checks the editor with axe in each theme, in a large and a small window. */
export function testThemes(open: Pick<OpenEditor, 'page' | 'editor'>): void {
  test.each([
    ['dark', 1440, 900],
    ['light', 1024, 768],
  ] as const)('in the %s theme at %d × %d, axe finds nothing', async (colorScheme, width, height) => {
    const { page, editor } = open;
    await page.setViewportSize({ width, height });
    await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
    await editor.settled();
    expect(await axeFindings(page)).toEqual([]);
  });
}
