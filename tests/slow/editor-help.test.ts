import { expect, test } from '@jest/globals';
import { axeFindings } from '../support/axe.ts';
import type { GraphText } from '../support/open-editor.ts';
import { useEditor } from '../support/open-editor.ts';

const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'gaussian-blur-aaaa': { type: 'filter/gaussian-blur' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: ['video-aaaa.layer -> gaussian-blur-aaaa.inputImage', 'gaussian-blur-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'gaussian-blur-aaaa': [260, 0], 'screen-aaaa': [520, 0] },
};

const openEditor = useEditor();

test('help beside the graph says what the selected node takes, gives and can be set to, and opens an example that uses it', async () => {
  const { page, editor } = await openEditor(GRAPH, { size: { width: 1440, height: 900 } });
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await editor.node('gaussian-blur-aaaa').click();
  await page.keyboard.press('F1');
  const help = page.getByRole('complementary', { name: 'Node help' });
  const part = (name: string) => help.locator('section', { has: page.getByRole('heading', { name }) });
  await help.getByRole('heading', { name: 'Gaussian blur', level: 2 }).waitFor();
  expect(await part('Inputs').textContent()).toContain('layer · required');
  // The unit, the default and both ends of the range are the definition's.
  expect(await part('Parameters').textContent()).toMatch(/Radius.*px.*to.*px.*can be connected/);
  for (const colorScheme of ['light', 'dark'] as const) {
    await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
    expect(await axeFindings(page)).toEqual([]);
  }
  await page.keyboard.press('Escape');
  await help.getByText('Select a node to read what it does.').waitFor();
  await editor.node('video-aaaa').click();
  await help.getByRole('heading', { name: 'Camera video', level: 2 }).waitFor();
  const example = part('Examples').getByRole('button').first();
  await example.locator('img').waitFor();
  const title = (await example.locator('.image-card-title').textContent())?.replace('Open the example: ', '') ?? '';
  await example.click();
  await page.locator('.top-bar').getByText(title, { exact: true }).waitFor();
  await page.keyboard.press('F1');
  await help.waitFor({ state: 'detached' });
});
