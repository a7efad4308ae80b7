import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { centerOf } from '../../tools/lib/center-of.ts';
import { axeFindings } from '../support/axe.ts';
import { type GraphText, saveGraphs, useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

/** The camera's picture, blurred, goes to the screen; a sepia stands by. */
const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'gaussian-blur-aaaa': { type: 'filter/gaussian-blur' },
    'sepia-aaaa': { type: 'filter/sepia' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: ['video-aaaa.layer -> gaussian-blur-aaaa.inputImage', 'gaussian-blur-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'gaussian-blur-aaaa': [260, 0], 'sepia-aaaa': [0, 220], 'screen-aaaa': [760, 0] },
};
const TO_SCREEN = 'gaussian-blur-aaaa.layer -> screen-aaaa.layer';

const open = useOneEditor(GRAPH, {}, async () => {
  await open.editor.hold();
});

function title(node: string) {
  return open.editor.node(node).locator('.node-title');
}

test('a node that is dropped on a wire goes into it, in one step with its move', async () => {
  const { page, editor } = open;
  const from = await centerOf(title('sepia'));
  const to = await editor.pointOnWire(TO_SCREEN, 0.5);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  // A hand starts slowly; the node hangs on where the pointer is after its first step.
  await page.mouse.move(from.x + 4, from.y, { steps: 4 });
  await page.mouse.move(to.x, to.y + 60, { steps: 4 });
  await page.mouse.move(to.x, to.y - 8, { steps: 4 });
  await page.locator('.wire-under').waitFor({ state: 'attached' });
  await page.mouse.up();
  await page.getByRole('group', { name: 'Wire from Sepia to Output' }).waitFor();
  expect((await saveGraphs(open)).main?.wires).toEqual([
    'video-aaaa.layer -> gaussian-blur-aaaa.inputImage',
    'sepia-aaaa.layer -> screen-aaaa.layer',
    'gaussian-blur-aaaa.layer -> sepia-aaaa.inputImage',
  ]);
  await page.keyboard.press('Control+z');
  expect((await saveGraphs(open)).main?.wires).toHaveLength(2);
  expect((await centerOf(title('sepia'))).y).toBeCloseTo(from.y, 0);
  await page.keyboard.press('Control+Shift+z');
  await page.getByRole('group', { name: 'Wire from Sepia to Output' }).waitFor();
  await editor.node('sepia-aaaa').waitFor();
});

test('Tab over a selected wire asks for a node to go through, and offers no other', async () => {
  const { page, editor } = open;
  const { x, y } = await open.editor.pointOnWire('video-aaaa.layer -> gaussian-blur-aaaa.inputImage', 0.5);
  await page.mouse.click(x, y);
  await page.keyboard.press('Tab');
  const list = page.getByRole('listbox', { name: 'Node types' });
  await list.waitFor();
  const offered = await list.getByRole('option').allTextContents();
  expect(offered.some((text) => text.startsWith('Scene') || text.startsWith('Camera video'))).toBe(false);
  await page.keyboard.type('pixelate');
  await page.keyboard.press('Enter');
  await editor.node('pixelate').waitFor();
  await page.getByRole('group', { name: 'Wire from Camera video to Pixelate' }).waitFor();
  await page.keyboard.press('Control+z');
  await editor.node('pixelate').waitFor({ state: 'detached' });
});

test('selected nodes become a subgraph, with a name, opened by a double-click, whose value shows outside', async () => {
  const { page, editor } = open;
  await title('gaussian-blur').click();
  await title('sepia').click({ modifiers: ['Shift'] });
  await page.keyboard.press('Control+g');
  const name = editor.inspector.getByRole('textbox', { name: 'Name' });
  await name.fill('Old film');
  await page.keyboard.press('Enter');
  await title('subgraph').getByText('Old film').waitFor();
  await title('subgraph').dblclick();
  const way = page.getByRole('navigation', { name: 'Subgraphs' });
  await way.waitFor();
  await title('sepia').click();
  await editor.inspector.getByRole('button', { name: 'More actions for Amount' }).click();
  await page.getByRole('menuitemcheckbox', { name: 'Expose on the subgraph' }).click();
  await editor.inspector.getByRole('switch', { name: 'Amount, parameter', checked: true }).waitFor();
  await way.getByRole('button', { name: 'Main graph' }).click();
  await way.waitFor({ state: 'detached' });
  await title('subgraph').click();
  const amount = editor.inspector.getByRole('textbox', { name: 'Amount' });
  await amount.fill('0.25');
  await page.keyboard.press('Enter');
  const graphs = await saveGraphs(open);
  expect(Object.keys(graphs)).toEqual(['main', 'old-film']);
  expect(Object.values(graphs.main?.nodes ?? {})).toContainEqual({ type: 'graph/old-film', version: 1, params: { amount: 0.25 } });
  expect(Object.keys(graphs['old-film']?.nodes ?? {})).toEqual(['gaussian-blur-aaaa', 'sepia-aaaa']);
  await editor.settled();
  await page.locator('.status-bar').getByText(/error/).waitFor({ state: 'detached' });
});

test('the borders of an open subgraph show its ports; a wire to a border exposes another one, a button hides it', async () => {
  const { page, editor } = open;
  await title('subgraph').dblclick();
  const border = (side: 'inputs' | 'outputs') => page.locator(`[data-border="${side}"]`);
  const wires = (side: 'inputs' | 'outputs') => page.locator(`.react-flow__edge[data-id^="border:${side}"]`);
  await border('inputs').getByText('Amount').waitFor();
  expect(await border('inputs').locator('.border-label').allTextContents()).toEqual(['Layer', 'Amount']);
  expect(await wires('inputs').count()).toBe(2);
  expect(await wires('outputs').count()).toBe(1);
  await page.keyboard.press('f');
  // An arrow key moves a border, as it does a node.
  const head = border('inputs').locator('.border-head');
  await head.click();
  const { x } = await centerOf(head);
  await page.keyboard.press('ArrowLeft');
  await eventually(async () => expect((await centerOf(head)).x).toBeLessThan(x));
  await page.keyboard.press('Control+z');
  await eventually(async () => expect((await centerOf(head)).x).toBe(x));
  // An input that the instances of the subgraph connect is not said to be missing.
  await title('gaussian-blur').click();
  await editor.inspector.getByRole('combobox', { name: 'Connect to Layer' }).getByText('Input of the subgraph').waitFor();
  const blurred = editor.port('gaussian-blur-aaaa', 'layer', 'source');
  await editor.drag(await centerOf(blurred), await centerOf(border('outputs').locator('.border-add')));
  await border('outputs').locator('.border-label').nth(1).waitFor();
  expect(await wires('outputs').count()).toBe(2);
  const { 'old-film': film } = await saveGraphs(open);
  expect(film?.exposed?.outputs).toHaveLength(2);
  await border('outputs').locator('.border-row').nth(1).hover();
  await border('outputs')
    .getByRole('button', { name: /^Stop exposing/ })
    .nth(1)
    .click();
  await border('outputs').locator('.border-label').nth(1).waitFor({ state: 'detached' });
  expect((await saveGraphs(open))['old-film']?.exposed?.outputs).toHaveLength(1);
  await page.getByRole('navigation', { name: 'Subgraphs' }).getByRole('button', { name: 'Main graph' }).click();
  await title('subgraph').waitFor();
});

test('a subgraph is shared by copies, made independent, unpacked; undo goes through all of it', async () => {
  const { page, editor } = open;
  const before = JSON.stringify(await saveGraphs(open));
  await title('subgraph').click();
  await page.keyboard.press('Control+Shift+d');
  await editor.inspector.getByText('Used by 2 nodes').waitFor();
  await editor.inspector.getByRole('button', { name: 'Make unique' }).click();
  await editor.inspector.getByText('Used by 2 nodes').waitFor({ state: 'detached' });
  expect(Object.keys(await saveGraphs(open))).toEqual(['main', 'old-film', 'old-film-2']);
  await editor.inspector.getByRole('button', { name: 'Ungroup' }).click();
  await page.getByRole('heading', { name: '2 nodes' }).waitFor();
  expect(await editor.node('sepia').count()).toBe(1);
  for (let step = 0; step < 3; step++) await page.keyboard.press('Control+z');
  expect(JSON.stringify(await saveGraphs(open))).toBe(before);
});

test('another type keeps the wires; nodes collapse, are tidied up, and found', async () => {
  const { page, editor } = open;
  await title('video').click();
  await page.keyboard.press('Shift+S');
  await page.getByRole('combobox', { name: 'Search nodes' }).fill('image file');
  await page.keyboard.press('Enter');
  await title('video').getByText('Image file').waitFor();
  await page.getByRole('group', { name: 'Wire from Image file to Old film' }).waitFor();
  await page.keyboard.press('h');
  await page.locator('[data-node="video-aaaa"].node-collapsed').waitFor();
  await page.mouse.click(500, 700);
  await page.keyboard.press('l');
  await page.waitForFunction(() => {
    const box = (node: string) => document.querySelector(`[data-node^="${node}"]`)?.getBoundingClientRect();
    return (box('video')?.right ?? 0) + 40 < (box('subgraph')?.left ?? 0);
  });
  await page.keyboard.press('Control+f');
  await page.getByRole('combobox', { name: 'Name or value' }).fill('sepia');
  await page.keyboard.press('Enter');
  await page.getByRole('navigation', { name: 'Subgraphs' }).getByText('Old film').waitFor();
  await editor.inspector.getByRole('heading', { name: 'Sepia' }).waitFor();
  await page.keyboard.press('Control+z');
});

test('nothing that axe-core knows is wrong, in both themes, with a node, a subgraph, a menu or a dialog open', async () => {
  const { page, editor } = open;
  for (const colorScheme of ['dark', 'light'] as const) {
    await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
    await title('sepia').click();
    expect(await axeFindings(page)).toEqual([]);
    await editor.inspector.getByRole('button', { name: 'More actions for Amount' }).click();
    expect(await axeFindings(page)).toEqual([]);
    await page.keyboard.press('Escape');
    for (const keys of ['?', 'Control+f']) {
      await title('sepia').click();
      await page.keyboard.press(keys);
      await page.getByRole('dialog').waitFor();
      expect(await axeFindings(page)).toEqual([]);
      await page.keyboard.press('Escape');
      await page.getByRole('dialog').waitFor({ state: 'detached' });
    }
  }
});

test('a frame around selected nodes takes them along; a note is written beside them; both are resized and deleted', async () => {
  const { page, editor } = open;
  await page.emulateMedia({ colorScheme: 'dark' });
  await page.keyboard.press('Escape');
  await title('sepia').click();
  await page.keyboard.press('c');
  const frame = page.locator('[data-item^="frame:"]');
  await frame.waitFor();
  await page.getByRole('textbox', { name: 'Frame title' }).fill('Colors');
  const before = await centerOf(title('sepia'));
  const head = await frame.locator('.frame-head').boundingBox();
  if (!head) throw new Error('The frame has no head.');
  const handle = { x: head.x + head.width - 12, y: head.y + head.height / 2 };
  await page.mouse.move(handle.x, handle.y);
  await page.mouse.down();
  await page.mouse.move(handle.x, handle.y + 4, { steps: 4 });
  await page.mouse.move(handle.x, handle.y + 84, { steps: 6 });
  await page.mouse.up();
  await page.waitForFunction(
    (y) => (document.querySelector('[data-node^="sepia"] .node-title')?.getBoundingClientRect().y ?? 0) > y + 40,
    before.y,
  );
  await page.mouse.click(handle.x - 500, handle.y + 300);
  await page.keyboard.press('n');
  const note = page.getByRole('textbox', { name: 'Note text' });
  await note.fill('Warm, as in old prints.');
  const corner = page.locator('.react-flow__resize-control.handle.bottom.right');
  const from = await centerOf(corner);
  await editor.drag(from, { x: from.x + 60, y: from.y + 40 });
  await saveGraphs(open);
  const layout = JSON.parse(await readFile(join(open.project, 'project.layout.json'), 'utf8'));
  const { frames, notes } = layout.graphs['old-film'];
  expect(Object.values(frames)).toEqual([expect.objectContaining({ title: 'Colors' })]);
  const [written] = Object.values(notes) as { readonly text: string; readonly width: number }[];
  expect(written?.text).toBe('Warm, as in old prints.');
  expect(written?.width).toBeGreaterThan(200);
  await page.locator('[data-item^="note:"]').click({ position: { x: 20, y: 4 } });
  await page.keyboard.press('Delete');
  await note.waitFor({ state: 'detached' });
  await page.keyboard.press('Control+z');
  await note.waitFor();
});
