import { expect, test } from '@jest/globals';
import { axeFindings } from '../support/axe.ts';
import { chooseOption } from '../support/choose-option.ts';
import { keyframedSepia } from '../support/keyframed-sepia.ts';
import { type GraphText, useOneEditor } from '../support/open-editor.ts';

/** A box that a gizmo moves, in a picture that keyframes change, and a color. */
const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'sepia-aaaa': keyframedSepia({ timeS: 0, value: 0, easing: 'linear' }, { timeS: 2, value: 1, easing: 'ease-in-out' }),
    'box-aaaa': { type: 'objects/primitive' },
    'transform-aaaa': { type: 'objects/transform', params: { positionM: [0, 0.5, 0] } },
    'scene-aaaa': { type: 'layer/scene' },
    'over-aaaa': { type: 'operator/over' },
    'color-aaaa': { type: 'value/color' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: [
    'video-aaaa.layer -> sepia-aaaa.inputImage',
    'sepia-aaaa.layer -> over-aaaa.bottom',
    'box-aaaa.objects -> transform-aaaa.objects',
    'transform-aaaa.objects -> scene-aaaa.objects',
    'scene-aaaa.layer -> over-aaaa.top',
    'over-aaaa.layer -> screen-aaaa.layer',
  ],
  places: {
    'video-aaaa': [0, 0],
    'sepia-aaaa': [240, 0],
    'box-aaaa': [0, 200],
    'transform-aaaa': [240, 200],
    'scene-aaaa': [480, 200],
    'over-aaaa': [480, 0],
    'color-aaaa': [0, 420],
    'screen-aaaa': [720, 0],
  },
};

const open = useOneEditor(GRAPH, {}, async () => {
  await open.editor.settled();
  await open.editor.hold();
});

const title = (node: string) => open.editor.node(node).locator('.node-title');
const themes = ['dark', 'light'] as const;

/** What axe-core finds, by theme. */
async function expectNothingFound(): Promise<void> {
  for (const colorScheme of themes) {
    await open.page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
    expect([colorScheme, await axeFindings(open.page)]).toEqual([colorScheme, []]);
  }
}

test('the bar of the gizmo, with a mode that is on', async () => {
  await title('transform').click();
  const bar = open.page.getByRole('toolbar', { name: 'Gizmo' });
  await bar.waitFor();
  await bar.getByRole('button').first().click();
  await expectNothingFound();
});

test('the eyedropper, over the preview', async () => {
  const { page, editor } = open;
  await title('color').click();
  await editor.inspector.getByRole('button', { name: /pick from the preview/ }).click();
  await page.getByRole('application', { name: /pick a color from the preview/ }).waitFor();
  await expectNothingFound();
  await page.keyboard.press('Escape');
});

test('the timeline, with keyframes, one of them chosen, and the inspector of an animated value', async () => {
  const { page } = open;
  await title('sepia').click();
  await page.keyboard.press('Shift+T');
  const key = page.locator('.timeline').getByRole('button', { name: 'Keyframe 1, 0.00 s' });
  await key.waitFor();
  await expectNothingFound();
  await key.click();
  await expectNothingFound();
  await title('sepia').click();
  await page.keyboard.press('Shift+T');
});

test('a reroute, selected, and one with the focus', async () => {
  const { page } = open;
  await page.getByRole('group', { name: 'Wire from Camera video to Sepia' }).focus();
  await page.keyboard.press('Enter');
  await page.keyboard.press('r');
  await page.getByRole('group', { name: 'Reroute of the wire from Camera video to Sepia' }).waitFor();
  await expectNothingFound();
});

test('the help beside the graph, with and without a node', async () => {
  const { page } = open;
  await title('box').click();
  await page.keyboard.press('F1');
  const help = page.getByRole('complementary', { name: 'Node help' });
  await help.waitFor();
  await expectNothingFound();
  await page.keyboard.press('Escape');
  await help.getByText('Select a node to read what it does.').waitFor();
  await expectNothingFound();
  await page.keyboard.press('F1');
});

test('the dialog that asks for frames, of pictures and of a video', async () => {
  const { page } = open;
  await page.keyboard.press('Control+Shift+E');
  const dialog = page.getByRole('dialog', { name: 'Render frames' });
  await dialog.waitFor();
  await expectNothingFound();
  await chooseOption(dialog.getByRole('combobox', { name: 'Format' }), 'video');
  await dialog.getByRole('textbox', { name: 'First frame', exact: true }).fill('none');
  await expectNothingFound();
  await page.keyboard.press('Escape');
  await dialog.waitFor({ state: 'detached' });
});

test('the dialog of an export, and what it says about a folder that is in use', async () => {
  const { page, editor, project } = open;
  await editor.press('Export');
  const dialog = page.getByRole('dialog', { name: 'Export the page' });
  await dialog.waitFor();
  await expectNothingFound();
  // The folder of the project itself.
  await dialog.getByRole('textbox', { name: 'Folder' }).fill(project);
  await dialog.getByRole('button', { name: 'Export', exact: true }).click();
  await dialog.getByRole('alert').getByRole('listitem').first().waitFor();
  await expectNothingFound();
  await page.keyboard.press('Escape');
  await dialog.waitFor({ state: 'detached' });
});

test('the light of an emulated room', async () => {
  const { page, editor } = open;
  await chooseOption(page.getByRole('combobox', { name: 'Preview source' }), 'room/studio');
  await editor.settled();
  await editor.press('Room light');
  await page.getByRole('dialog', { name: 'Room light' }).waitFor();
  await expectNothingFound();
  await page.keyboard.press('Escape');
});
