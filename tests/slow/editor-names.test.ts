import { expect, test } from '@jest/globals';
import { saveGraphs, useOneEditor } from '../support/open-editor.ts';

const open = useOneEditor(
  {
    nodes: {
      'video-aaaa': { type: 'source/camera-video' },
      'sepia-aaaa': { type: 'filter/sepia' },
      'blur-aaaa': { type: 'filter/blur' },
      'screen-aaaa': { type: 'output/screen' },
    },
    wires: [
      'video-aaaa.layer -> sepia-aaaa.inputImage',
      'sepia-aaaa.layer -> blur-aaaa.inputImage',
      'blur-aaaa.layer -> screen-aaaa.layer',
    ],
    places: { 'video-aaaa': [0, 0], 'sepia-aaaa': [260, 0], 'blur-aaaa': [520, 0], 'screen-aaaa': [780, 0] },
  },
  {},
);

const field = (name: string) => open.page.getByRole('textbox', { name });
const title = (text: string) => open.page.locator('.node-title').getByText(text, { exact: true });

// The tests go on from one another.
test('a subgraph is renamed at its head: Escape cancels, an empty name is refused there, Enter is one undo step', async () => {
  const { page } = open;
  await title('Sepia').click();
  await page.keyboard.press('Control+g');
  await title('Subgraph').dblclick();
  const name = field('Name of the subgraph').first();
  await page.keyboard.type('Old photo');
  await page.keyboard.press('Escape');
  await title('Subgraph').waitFor();
  await title('Subgraph').dblclick();
  await page.keyboard.type('12');
  await page.getByText('The name must begin with a letter.').waitFor();
  await page.keyboard.press('Enter');
  expect(await name.getAttribute('aria-invalid')).toBe('true');
  await name.fill('Old photo');
  await page.keyboard.press('Enter');
  await title('Old photo').waitFor();
  await page.keyboard.press('Control+z');
  await title('Subgraph').waitFor();
  await page.keyboard.press('Control+Shift+z');
  await title('Old photo').waitFor();
});

test('inside, its name and those of its ports are renamed in place; another port keeps its name', async () => {
  const { page } = open;
  await page.locator('[data-node^="subgraph"]').dblclick({ position: { x: 40, y: 45 } });
  const trail = page.getByRole('navigation', { name: 'Subgraphs' });
  await trail.getByRole('button', { name: 'Old photo' }).dblclick();
  await page.keyboard.type('Faded photo');
  await page.keyboard.press('Enter');
  await trail.getByRole('button', { name: 'Faded photo' }).waitFor();

  const inputs = page.locator('[data-border="inputs"]');
  await inputs.locator('.border-label').first().dblclick();
  await page.keyboard.type('Layer');
  await page.getByText('The subgraph already has a port of this name.').waitFor();
  await page.keyboard.press('Control+a');
  await page.keyboard.type('Fresh photo');
  await page.keyboard.press('Enter');
  await inputs.getByText('Fresh photo').waitFor();

  const { main, 'faded-photo': inner } = await saveGraphs(open);
  expect(inner?.exposed?.inputs).toMatchObject([{ name: 'freshPhoto', port: 'inputImage' }]);
  expect(main?.wires.some((wire) => wire.startsWith('video-aaaa.layer -> ') && wire.endsWith('.freshPhoto'))).toBe(true);
});
