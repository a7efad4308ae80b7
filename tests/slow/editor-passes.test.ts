import { expect, test } from '@jest/globals';
import { useEditor } from '../support/open-editor.ts';

const open = useEditor();

test('the inspector says which effects one pass of the exported page draws, and why a layer stays a texture', async () => {
  const { page, editor, errors } = await open({
    nodes: {
      'video-aaaa': { type: 'source/camera-video' },
      'sepia-aaaa': { type: 'filter/sepia' },
      'blur-aaaa': { type: 'filter/gaussian-blur' },
      'dark-aaaa': { type: 'filter/vignette' },
      'screen-aaaa': { type: 'output/screen' },
    },
    wires: [
      'video-aaaa.layer -> sepia-aaaa.inputImage',
      'sepia-aaaa.layer -> blur-aaaa.inputImage',
      'blur-aaaa.layer -> dark-aaaa.inputImage',
      'dark-aaaa.layer -> screen-aaaa.layer',
    ],
    places: { 'video-aaaa': [0, 0], 'sepia-aaaa': [220, 0], 'blur-aaaa': [440, 0], 'dark-aaaa': [660, 0], 'screen-aaaa': [880, 0] },
  });
  await editor.settled();
  await editor.node('blur').locator('.node-title').click();
  const passes = editor.inspector.getByRole('region', { name: 'Passes' });
  await passes.getByRole('button', { name: 'Passes in the exported page' }).click();
  await passes.getByText('One pass with Vignette.').waitFor();
  await passes.getByText(/^A texture between Sepia and Gaussian blur: the reader reads other pixels/).waitFor();
  if (process.env.SHOT) await page.screenshot({ path: '/tmp/passes.png' });
  // A change of the graph changes what is said.
  await editor.node('dark').locator('.node-title').click();
  await page.keyboard.press('m');
  await editor.node('blur').locator('.node-title').click();
  await passes.getByRole('button', { name: 'Passes in the exported page' }).click();
  await passes.getByText('A pass of its own.').first().waitFor();
  await expect(passes.getByText('Vignette').count()).resolves.toBe(0);
  expect(errors).toEqual([]);
});
