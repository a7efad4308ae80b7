import { expect, test } from '@jest/globals';
import { axeFindings } from '../support/axe.ts';
import { useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';
import { TINTED } from '../support/tinted.ts';

const open = useOneEditor(TINTED, {}, async () => {
  await open.editor.settled();
  await open.editor.hold();
});

const flag = () => open.page.getByRole('region', { name: 'Preview' }).locator('.stage-flag');
const says = () => open.editor.node('tint-aaaa').locator('.node-says');

test('an error is said at the node and over the preview, where “Show” goes to its line', async () => {
  const { page, editor } = open;
  await expect(flag().count()).resolves.toBe(0);
  await editor.openCode('tint-aaaa');
  await editor.findInText('0), pixel.a)');
  const line = await editor.lineNumber();
  await editor.type('q');
  await says().waitFor();
  const message = await says().textContent();
  expect(message).toMatch(/\w+ \w+/);
  await flag().getByText('Showing the last working version', { exact: true }).waitFor();
  await flag()
    .getByText(message ?? '', { exact: true })
    .waitFor();
  for (const colorScheme of ['dark', 'light'] as const) {
    await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
    expect([colorScheme, await axeFindings(page)]).toEqual([colorScheme, []]);
  }

  // Tests may cover the top of the preview only this far, and neither covers the head.
  const [image, bar, head, text] = await Promise.all(
    [page.locator('iframe[title="Preview"]'), flag(), editor.node('tint-aaaa').locator('.node-head'), says()].map((one) =>
      one.boundingBox(),
    ),
  );
  expect((bar?.y ?? 0) + (bar?.height ?? 0)).toBeLessThanOrEqual((image?.y ?? 0) + 40);
  expect((text?.y ?? 0) + (text?.height ?? 0)).toBeLessThanOrEqual(head?.y ?? 0);

  await page.keyboard.press('Control+j');
  await page.locator('.monaco-editor').first().waitFor({ state: 'detached' });
  await editor.node('video').locator('.node-title').click();
  await flag().getByRole('button', { name: 'Show' }).click();
  await page.locator('.monaco-editor .squiggly-error').first().waitFor();
  await eventually(async () => expect(await editor.lineNumber()).toBe(line));

  await page.locator('.monaco-editor.focused').waitFor();
  await page.keyboard.press('Control+z');
  await says().waitFor({ state: 'detached' });
  await flag().waitFor({ state: 'detached' });
});
