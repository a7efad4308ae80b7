import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { centerOf, type Point } from '../../tools/lib/center-of.ts';
import { type GraphText, saveGraphs, useOneEditor } from '../support/open-editor.ts';

/** The camera's picture goes to a sepia, and on to the screen; a blur and an operator stand by. */
const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'sepia-aaaa': { type: 'filter/sepia' },
    'gaussian-blur-aaaa': { type: 'filter/gaussian-blur' },
    'over-aaaa': { type: 'operator/over' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: ['video-aaaa.layer -> sepia-aaaa.inputImage', 'sepia-aaaa.layer -> screen-aaaa.layer'],
  places: {
    'video-aaaa': [0, 0],
    'sepia-aaaa': [480, 0],
    'gaussian-blur-aaaa': [480, 160],
    'over-aaaa': [480, 320],
    'screen-aaaa': [760, 0],
  },
};
const TO_SEPIA = 'video-aaaa.layer -> sepia-aaaa.inputImage';

const open = useOneEditor(GRAPH, { colorScheme: 'dark' }, async () => {
  await open.page.emulateMedia({ reducedMotion: 'reduce' });
  await open.editor.hold();
});

interface SavedLayout {
  readonly nodes: Readonly<Record<string, Point>>;
  readonly reroutes?: Readonly<Record<string, Point>>;
  readonly routes?: Readonly<Record<string, readonly string[]>>;
}

/** Of the main graph, after a save by keys. */
async function savedLayout(): Promise<SavedLayout> {
  await saveGraphs(open);
  return JSON.parse(await readFile(join(open.project, 'project.layout.json'), 'utf8')).graphs.main;
}

function reroutes() {
  return open.page.locator('.react-flow__node-reroute');
}

function title(node: string) {
  return open.editor.node(node).locator('.node-title');
}

/** A point on a stretch, `along` its length from 0 to 1. */
function pointOn(stretch: string, along = 0.5): Promise<Point> {
  return open.editor.pointOnWire(stretch, along);
}

async function press(...keys: readonly string[]): Promise<void> {
  for (const key of keys) await open.page.keyboard.press(key);
}

test('a double-click on a wire puts a point there, which is dragged, undone and done again; the graph knows nothing of it', async () => {
  const { page, editor } = open;
  const before = await saveGraphs(open);
  const at = await pointOn(TO_SEPIA);
  await page.mouse.dblclick(at.x, at.y);
  await reroutes().waitFor();
  const stood = await centerOf(reroutes());
  expect(Math.hypot(stood.x - at.x, stood.y - at.y)).toBeLessThan(2);
  await editor.drag(stood, { x: stood.x, y: stood.y + 120 });
  await page.waitForFunction(
    (y) => (document.querySelector('.react-flow__node-reroute')?.getBoundingClientRect().y ?? 0) > y + 90,
    stood.y,
  );
  const { reroutes: saved = {}, routes } = await savedLayout();
  const [id = ''] = Object.keys(saved);
  expect(routes).toEqual({ [TO_SEPIA]: [id] });
  const after = await saveGraphs(open);
  expect({ ...after.main, wires: [...(after.main?.wires ?? [])].sort() }).toEqual({
    ...before.main,
    wires: [...(before.main?.wires ?? [])].sort(),
  });
  await press('Control+z', 'Control+z');
  await reroutes().waitFor({ state: 'detached' });
  expect((await savedLayout()).routes).toBeUndefined();
  await press('Control+Shift+z', 'Control+Shift+z');
  await reroutes().waitFor();
  expect(await savedLayout()).toMatchObject({ reroutes: saved, routes });
});

test('from its knob more wires are drawn: to ports, to what the palette offers; all of them share the way up to it', async () => {
  const { page, editor } = open;
  await reroutes().hover();
  const knob = await centerOf(page.locator('.reroute-knob'));
  await editor.drag(knob, await centerOf(editor.port('gaussian-blur-aaaa', 'inputImage', 'target')));
  await page.getByRole('group', { name: 'Wire from Camera video to Gaussian blur' }).waitFor();
  await reroutes().hover();
  await editor.drag(await centerOf(page.locator('.reroute-knob')), { x: knob.x + 40, y: knob.y + 260 });
  await page.getByRole('combobox', { name: 'Search nodes' }).fill('pixelate');
  await press('Enter');
  await page.getByRole('group', { name: 'Wire from Camera video to Pixelate' }).waitFor();
  const { routes = {} } = await savedLayout();
  expect(Object.keys(routes)).toHaveLength(3);
  expect(new Set(Object.values(routes).map(String)).size).toBe(1);
  // One stretch up to the point, three from there.
  expect(await page.locator('.react-flow__edge').count()).toBe(5);
});

test('a point is selected, put by a key, moved by arrows with a node, aligned with it, and named', async () => {
  const { page } = open;
  await page.getByRole('group', { name: 'Reroute of 3 wires from Camera video' }).waitFor();
  await page.getByRole('group', { name: 'Wire from Sepia to Output' }).focus();
  await press('Enter', 'r');
  const added = page.getByRole('group', { name: 'Reroute of the wire from Sepia to Output' });
  await added.waitFor();
  await page.locator('.reroute-selected').waitFor();
  const before = await savedLayout();
  await added.focus();
  await press('ArrowDown');
  await title('sepia').click({ modifiers: ['Shift'] });
  await press('ArrowDown');
  const after = await savedLayout();
  const id = after.routes?.['sepia-aaaa.layer -> screen-aaaa.layer']?.[0] ?? '';
  expect((after.reroutes?.[id]?.y ?? 0) - (before.reroutes?.[id]?.y ?? 0)).toBeGreaterThanOrEqual(15);
  expect((after.nodes['sepia-aaaa']?.y ?? 0) - (before.nodes['sepia-aaaa']?.y ?? 0)).toBe(8);
  await press('Control+k');
  await page.getByRole('combobox', { name: 'Command' }).fill('align top');
  await press('Enter');
  const aligned = await savedLayout();
  expect(aligned.reroutes?.[id]?.y).toBe(aligned.nodes['sepia-aaaa']?.y);
});

test('the menu of a wire puts a point where it was pressed; Delete takes that alone', async () => {
  const { page } = open;
  const at = await pointOn('sepia-aaaa.layer -> screen-aaaa.layer', 0.7);
  await page.mouse.click(at.x, at.y, { button: 'right' });
  await page.getByRole('menuitem', { name: 'Add reroute' }).click();
  const points = page.getByRole('group', { name: 'Reroute of the wire from Sepia to Output' });
  await points.nth(1).waitFor();
  const added = await centerOf(page.locator('.reroute-selected'));
  expect(Math.hypot(added.x - at.x, added.y - at.y)).toBeLessThan(2);
  await press('Delete');
  await points.nth(1).waitFor({ state: 'detached' });
  await points.waitFor();
});

test('a wire let go over a point brings all that come after it something else', async () => {
  const { page, editor } = open;
  const shared = page.getByRole('group', { name: 'Reroute of 3 wires from Camera video' });
  await editor.drag(await centerOf(editor.port('over-aaaa', 'layer', 'source')), await centerOf(shared));
  await page.getByRole('group', { name: 'Reroute of 3 wires from Alpha over' }).waitFor();
  await press('Control+z');
  await shared.waitFor();
});

test('deleted, a point leaves its wires; copied and put into a subgraph, wires keep their points', async () => {
  const { page, editor } = open;
  await page.keyboard.press('Escape');
  await page.getByRole('group', { name: 'Reroute of the wire from Sepia to Output' }).click();
  await press('Delete');
  await page.getByRole('group', { name: 'Reroute of the wire from Sepia to Output' }).waitFor({ state: 'detached' });
  await page.getByRole('group', { name: 'Wire from Sepia to Output' }).waitFor();
  await title('video').click();
  await title('sepia').click({ modifiers: ['Shift'] });
  await press('Control+d');
  await page.getByRole('group', { name: 'Reroute of the wire from Camera video to Sepia' }).waitFor();
  expect(await reroutes().count()).toBe(2);
  await press('Control+z');
  await page.getByRole('group', { name: 'Reroute of the wire from Camera video to Sepia' }).waitFor({ state: 'detached' });
  await title('video').click();
  await title('sepia').click({ modifiers: ['Shift'] });
  await press('Control+g');
  await editor.node('subgraph').waitFor();
  await title('subgraph').dblclick();
  await page.getByRole('group', { name: 'Reroute of the wire from Camera video to Sepia' }).waitFor();
  await page.getByRole('navigation', { name: 'Subgraphs' }).getByRole('button', { name: 'Main graph' }).click();
  await page.getByRole('group', { name: 'Reroute of 2 wires from Subgraph' }).waitFor();
  await editor.settled();
});

// The last: where the view is afterwards is none of the others' business.
test('tidied up, points stand between what their wires join', async () => {
  const { page } = open;
  await press('Control+z');
  await page.getByRole('group', { name: 'Reroute of 3 wires from Camera video' }).waitFor();
  await page.keyboard.press('Escape');
  await savedLayout();
  await press('l');
  await page.locator('.unsaved').waitFor();
  const { nodes, reroutes: points = {} } = await savedLayout();
  const [point] = Object.values(points);
  expect(point?.x).toBeGreaterThan((nodes['video-aaaa']?.x ?? 0) + 184);
  for (const id of ['sepia-aaaa', 'gaussian-blur-aaaa']) expect(point?.x).toBeLessThan(nodes[id]?.x ?? 0);
});
