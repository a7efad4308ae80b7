import { expect, test } from '@jest/globals';
import { useEditor } from '../support/open-editor.ts';
import { TINTED } from '../support/tinted.ts';

const openEditor = useEditor();

test('by keys alone, the shader’s text completes a call, renames an input with its wire, turns a color, and has its mistakes told, those above a syntax error too', async () => {
  const { page, editor } = await openEditor(TINTED);
  await editor.settled();
  await editor.openCode('tint-aaaa');
  await editor.findInText('vec4 pixel');
  await page.keyboard.press('End');
  await editor.type(' pixel.rgb = pai');
  await page
    .locator('.suggest-widget.visible')
    .getByRole('option', { name: /^paint/ })
    .waitFor();
  await page.keyboard.press('Tab');
  await page.locator('.parameter-hints-widget.visible').getByText('Paints it over.').waitFor();
  await editor.type('pixel.rgb, 0.1');
  await page.keyboard.press('ArrowRight');
  await editor.type(';');
  await page.locator('.status-bar').getByText('No problems').waitFor();

  await editor.findInText('share * 0.50');
  await page.keyboard.press('F2');
  await page.locator('.rename-box input:focus').fill('strength');
  await page.keyboard.press('Enter');
  await editor.port('tint-aaaa', 'strength', 'target').waitFor({ state: 'attached' });
  expect(await page.locator('.react-flow__edge').count()).toBe(TINTED.wires.length);

  await editor.findInText('vec3(0.1');
  await page.keyboard.press('Alt+Enter');
  await page.getByRole('slider', { name: 'Red' }).press('End');
  await page.locator('.view-line', { hasText: 'vec3(1.0, 0.2, 0.9)' }).waitFor();
  await page.locator('.status-bar').getByText('No problems').waitFor();

  // The driver finds the first mistake, though the second keeps the shader from being a program.
  await editor.findInText('// Paints');
  await editor.type('float above() { return missing; }\nfloat below( { }\n');
  const problems = page.locator('.status-bar').getByRole('button', { name: /errors/ });
  await problems.getByText('2 errors').waitFor();
  await problems.click();
  const listed = page.getByRole('list', { name: 'Problems' }).getByRole('listitem');
  expect(await listed.first().textContent()).toContain('"missing"');
});
