import { expect, test } from '@jest/globals';
import { centerOf, type Point } from '../../tools/lib/center-of.ts';
import { type GraphText, saveGraphs, useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

/** The camera's picture goes to the screen; other nodes stand by. */
const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'sepia-aaaa': { type: 'filter/sepia' },
    'over-aaaa': { type: 'operator/over' },
    'number-aaaa': { type: 'value/number' },
    'transform-aaaa': { type: 'objects/transform', params: { positionM: [-1.2345, 0.5, -2.75] } },
    'threshold-aaaa': { type: 'filter/threshold' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: ['video-aaaa.layer -> screen-aaaa.layer'],
  places: {
    'video-aaaa': [0, 0],
    'sepia-aaaa': [0, 180],
    'over-aaaa': [300, 180],
    'number-aaaa': [0, 340],
    'transform-aaaa': [300, 340],
    'threshold-aaaa': [600, 180],
    'screen-aaaa': [600, 0],
  },
};
const WIRES = GRAPH.wires;

const open = useOneEditor(GRAPH, { size: { width: 1024, height: 768 } }, async () => {
  await open.editor.hold();
});

function title(node: string) {
  return open.editor.node(node).locator('.node-title');
}

function field(name: string) {
  return open.editor.inspector.getByRole('textbox', { name, exact: true });
}

/** Presses at a point and moves, and does not let go. */
async function begin(from: Point, to: Point): Promise<void> {
  const { mouse } = open.page;
  await mouse.move(from.x, from.y);
  await mouse.down();
  await mouse.move(from.x + 4, from.y + 4, { steps: 4 });
  await mouse.move(to.x, to.y, { steps: 6 });
}

/** Escape, and on with the pointer: what was given up stays so. */
async function giveUp(at: Point): Promise<void> {
  await open.page.keyboard.press('Escape');
  await open.page.mouse.move(at.x + 20, at.y + 10, { steps: 3 });
  await open.page.mouse.up();
}

async function wires(): Promise<readonly string[]> {
  return (await saveGraphs(open)).main?.wires ?? [];
}

async function expectNothingToUndo(): Promise<void> {
  expect(await open.page.getByRole('button', { name: 'Undo', exact: true }).isDisabled()).toBe(true);
}

test('Escape gives up what the pointer drags: nodes, wires, numbers and sliders, and leaves nothing to undo', async () => {
  const { page, editor } = open;
  const sepia = await centerOf(title('sepia'));
  const away = { x: sepia.x + 80, y: sepia.y + 40 };
  await begin(sepia, away);
  await eventually(async () => expect((await centerOf(title('sepia'))).x).toBeGreaterThan(sepia.x + 40));
  await giveUp(away);
  await eventually(async () => expect(await centerOf(title('sepia'))).toEqual(sepia));

  const empty = await editor.emptyPlace();
  await begin(await centerOf(editor.port('video-aaaa', 'layer', 'source')), empty);
  await page.locator('.react-flow__connection').waitFor({ state: 'attached' });
  await page.keyboard.press('Escape');
  await page.locator('.react-flow__connection').waitFor({ state: 'detached' });
  await page.mouse.up();
  // Over a port that would take it, too.
  const port = await centerOf(editor.port('sepia-aaaa', 'inputImage', 'target'));
  await begin(await centerOf(editor.port('video-aaaa', 'layer', 'source')), port);
  await giveUp(port);
  expect(await page.getByRole('combobox', { name: 'Search nodes' }).count()).toBe(0);

  await title('threshold').click();
  const level = await centerOf(field('Level'));
  await begin(level, { x: level.x + 40, y: level.y });
  await eventually(async () => expect(await field('Level').inputValue()).not.toBe('0.5'));
  await giveUp(level);
  expect(await field('Level').inputValue()).toBe('0.5');
  const slider = editor.inspector.getByRole('slider', { name: 'Level, slider' });
  const middle = await centerOf(slider);
  await begin(middle, { x: middle.x + 14, y: middle.y });
  await eventually(async () => expect(await field('Level').inputValue()).not.toBe('0.5'));
  await giveUp(middle);
  expect(await field('Level').inputValue()).toBe('0.5');

  await expectNothingToUndo();
  expect(await page.locator('.unsaved').count()).toBe(0);
  // What is let go the usual way counts as ever.
  await editor.drag(level, { x: level.x + 40, y: level.y });
  await eventually(async () => expect(await field('Level').inputValue()).not.toBe('0.5'));
  await page.keyboard.press('Control+z');
  await eventually(async () => expect(await field('Level').inputValue()).toBe('0.5'));
});

test('a wire let go over a node goes to the first port of it that is free, which is named beforehand; else it says why not', async () => {
  const { page, editor } = open;
  const from = await centerOf(editor.port('video-aaaa', 'layer', 'source'));
  const over = await centerOf(title('over'));
  const hint = page.locator('.connection-hint');
  await begin(from, over);
  await hint.getByText('Connect to Top').waitFor();
  await page.mouse.up();
  await page.getByRole('group', { name: 'Wire from Camera video to Alpha over' }).waitFor();
  await begin(from, over);
  await hint.getByText('Connect to Bottom').waitFor();
  await page.mouse.up();
  await eventually(async () => expect(await page.getByRole('group', { name: 'Wire from Camera video to Alpha over' }).count()).toBe(2));
  // The other way round: from an input to a node that gives it.
  await begin(await centerOf(editor.port('threshold-aaaa', 'inputImage', 'target')), over);
  await hint.getByText('Connect from Layer').waitFor();
  await page.mouse.up();
  await page.getByRole('group', { name: 'Wire from Alpha over to Threshold' }).waitFor();
  expect(await wires()).toEqual([
    'video-aaaa.layer -> over-aaaa.bottom',
    'video-aaaa.layer -> over-aaaa.top',
    ...WIRES,
    'over-aaaa.layer -> threshold-aaaa.inputImage',
  ]);
  // A node without such an input, and one with several of them.
  await begin(from, await centerOf(title('transform')));
  expect(await hint.count()).toBe(0);
  await page.mouse.up();
  await page.getByText('Transform has no layer input.').waitFor();
  await begin(await centerOf(editor.port('number-aaaa', 'number', 'source')), await centerOf(title('threshold')));
  await page.mouse.up();
  await page.getByText('Threshold has several parameters of this type.').waitFor();
  // One value that fits is the one that is meant.
  await begin(await centerOf(editor.port('number-aaaa', 'number', 'source')), await centerOf(title('sepia')));
  await page.mouse.up();
  await page.getByRole('group', { name: 'Wire from Number to Sepia' }).waitFor();
  for (let step = 0; step < 4; step++) await page.keyboard.press('Control+z');
  expect(await wires()).toEqual(WIRES);
});

test('a wire let go within 24 px of another is composited there; the nearer one is meant, and ports come first', async () => {
  const { page, editor } = open;
  const [straight = ''] = WIRES;
  const under = (wire: string) => page.locator(`.react-flow__edge[data-id="${wire}"] .wire-under`);
  const from = await centerOf(editor.port('sepia-aaaa', 'layer', 'source'));
  const middle = await editor.pointOnWire(straight, 0.5);
  await begin(from, { x: middle.x, y: middle.y + 20 });
  await under(straight).waitFor({ state: 'attached' });
  await page.mouse.move(middle.x, middle.y + 30);
  await under(straight).waitFor({ state: 'detached' });
  // A port that takes the wire, near the end of the other wire.
  const port = await centerOf(editor.port('screen-aaaa', 'layer', 'target'));
  await page.mouse.move(port.x - 16, port.y + 2, { steps: 2 });
  await page.locator('.react-flow__handle.valid').waitFor({ state: 'attached' });
  expect(await page.locator('.wire-under').count()).toBe(0);
  await page.mouse.move(middle.x, middle.y + 20, { steps: 4 });
  await under(straight).waitFor({ state: 'attached' });
  await page.mouse.up();
  await page.getByRole('group', { name: 'Wire from Sepia to Alpha over' }).waitFor();
  expect(await wires()).not.toContain(straight);
  await page.keyboard.press('Control+z');
  expect(await wires()).toEqual(WIRES);

  // Two wires that part slowly.
  await editor.wire(['video-aaaa', 'layer'], ['over-aaaa', 'bottom']);
  const bent = 'video-aaaa.layer -> over-aaaa.bottom';
  const start = await editor.pointOnWire(bent, 0);
  const fork = await editor.pointOnWire(bent, 0.25);
  expect(fork.y - start.y).toBeGreaterThan(6);
  // The view may have moved to show the new node.
  await begin(await centerOf(editor.port('sepia-aaaa', 'layer', 'source')), { x: fork.x, y: fork.y + 3 });
  await under(bent).waitFor({ state: 'attached' });
  await page.mouse.move(fork.x, start.y - 3, { steps: 2 });
  await under(straight).waitFor({ state: 'attached' });
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await page.keyboard.press('Control+z');
  expect(await wires()).toEqual(WIRES);
});

test('the numbers of a vector can be read in a narrow window; units can be typed, and invalid text stays for correction', async () => {
  const { page } = open;
  await title('transform').click();
  const clipped = await open.editor.inspector
    .locator('.vector-control input')
    .evaluateAll((all) => (all as HTMLInputElement[]).filter((input) => input.scrollWidth > input.clientWidth).length);
  expect(clipped).toBe(0);
  expect(await field('Position X').inputValue()).toBe('-1.2345');
  const y = field('Position Y');
  await y.fill('1 m + 20 cm');
  await page.keyboard.press('Enter');
  expect(await y.inputValue()).toBe('1.2');
  await y.fill('high');
  await page.keyboard.press('Enter');
  expect(await y.getAttribute('aria-invalid')).toBe('true');
  expect(await y.inputValue()).toBe('high');
  await page.keyboard.press('Escape');
  expect(await y.inputValue()).toBe('1.2');
  expect(await y.getAttribute('aria-invalid')).toBe('false');
  // Nor do the parts of a color stand on one another.
  await title('threshold').click();
  const row = open.editor.inspector.getByRole('group', { name: 'Dark', exact: true });
  const boxes = await row
    .locator('.color-field > *, .param-actions > *')
    .evaluateAll((all) => all.map((element) => element.getBoundingClientRect()));
  const overlapping = boxes.filter((a, i) =>
    boxes.slice(i + 1).some((b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom),
  );
  expect(overlapping).toEqual([]);
});

test('a slider drag with Shift and Ctrl is one undo step, and then keys mean the selected node again', async () => {
  const { page, editor } = open;
  await title('threshold').click();
  const slider = editor.inspector.getByRole('slider', { name: 'Level, slider' });
  const level = async () => Number(await field('Level').inputValue());
  const from = await centerOf(slider);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  // The first step changes the param, which marks its row; the drag goes on.
  for (const byPx of [2, 4, 6, 8]) {
    const last = await level();
    await page.mouse.move(from.x + byPx, from.y);
    await eventually(async () => expect(await level()).toBeGreaterThan(last));
  }
  const coarse = await level();
  await page.keyboard.down('Shift');
  await page.mouse.move(from.x + 18, from.y, { steps: 4 });
  await eventually(async () => expect(await level()).toBeGreaterThan(coarse));
  expect(await level()).toBeLessThan(coarse + 0.05);
  await page.keyboard.up('Shift');
  await page.keyboard.down('Control');
  await page.mouse.move(from.x + 12, from.y, { steps: 2 });
  await eventually(async () => expect((await level()) * 10).toBeCloseTo(Math.round((await level()) * 10), 6));
  await page.keyboard.up('Control');
  await page.mouse.up();

  const before = await centerOf(title('threshold'));
  await page.keyboard.press('ArrowRight');
  await eventually(async () => expect((await centerOf(title('threshold'))).x).toBeGreaterThan(before.x));
  await page.keyboard.press('m');
  await page.locator('[data-node="threshold-aaaa"].node-muted').waitFor();
  for (let step = 0; step < 3; step++) await page.keyboard.press('Control+z');
  await eventually(async () => expect(await level()).toBe(0.5));

  // With the focus, arrow keys of the slider have the same modifiers.
  await slider.focus();
  for (const [key, value] of [
    ['ArrowRight', 0.51],
    ['Shift+ArrowRight', 0.511],
    ['Control+ArrowRight', 0.6],
    ['Control+ArrowLeft', 0.5],
  ] as const) {
    await page.keyboard.press(key);
    await eventually(async () => expect(await level()).toBe(value));
  }
});

test('a click on one of several selected nodes selects only it; a drag moves all of them', async () => {
  const { page, editor } = open;
  await title('threshold').click();
  await title('transform').click({ modifiers: ['Shift'] });
  await editor.inspector.getByRole('heading', { name: '2 nodes', exact: true }).waitFor();
  const [one, other] = [await centerOf(title('threshold')), await centerOf(title('transform'))];
  await editor.drag(one, { x: one.x + 40, y: one.y + 40 });
  await eventually(async () => expect((await centerOf(title('transform'))).y).toBeGreaterThan(other.y));
  expect(await page.locator('.node-selected').count()).toBe(2);
  await title('threshold').click();
  await editor.inspector.getByRole('heading', { name: 'Threshold', exact: true }).waitFor();
  expect(await page.locator('.node-selected').count()).toBe(1);
});
