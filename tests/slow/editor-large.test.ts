import { expect, test } from '@jest/globals';
import { GRID_ROWS, gridGraph } from '../../tools/bench/grid-graph.ts';
import { useOneEditor } from '../support/open-editor.ts';

const NODES = 1000;
const open = useOneEditor(gridGraph(NODES), { colorScheme: 'dark' }, async () => {
  await open.editor.hold();
});

function nodeCalled(node: string) {
  return open.page.locator(`[data-node="${node}"]`);
}

/** On screen, of a node. */
async function placeOf(node: string) {
  const box = await nodeCalled(node).boundingBox();
  if (!box) throw new Error(`${node} is not on screen.`);
  return box;
}

test('a thousand nodes in view are patches of color, named for screen readers and under the pointer', async () => {
  const { page } = open;
  await page.waitForFunction((count) => document.querySelectorAll('.patch').length === count, NODES);
  expect(await page.locator('.react-flow__handle').count()).toBe(0);
  expect(await page.getByRole('group', { name: 'Gaussian blur' }).count()).toBe(NODES / 4);
  // A path a color: all wires are layers.
  expect(await page.locator('.overview-wires path').count()).toBe(1);
  const node = await placeOf('node-a502');
  await page.mouse.move(node.x + node.width / 2, node.y + node.height / 2);
  await page.locator('.tooltip').getByText('Gaussian blur').waitFor();
});

test('a hundred of them are dragged at once, with their wires, while the inspector rests; one undo brings them back', async () => {
  const { page, editor } = open;
  const first = await placeOf('node-a400');
  const last = await placeOf(`node-a${400 + 4 * GRID_ROWS - 1}`);
  await page.mouse.move(last.x + last.width + 3, first.y - 6);
  await page.mouse.down();
  await page.mouse.move(first.x + 3, last.y + last.height - 1, { steps: 4 });
  await page.mouse.up();
  await editor.inspector.getByRole('heading', { name: /^100 nodes/ }).waitFor();
  const wires = () => page.locator('.overview-wires path').getAttribute('d');
  const before = await wires();
  await page.mouse.move(first.x + 40, first.y + 40);
  await page.mouse.down();
  await page.mouse.move(first.x + 44, first.y + 44, { steps: 2 });
  await page.evaluate(() => {
    const inspector = document.querySelector('.inspector');
    if (!inspector) throw new Error('There is no inspector.');
    const seen = { changes: 0 };
    Object.assign(window, { inspectorSeen: seen });
    new MutationObserver((records) => {
      seen.changes += records.length;
    }).observe(inspector, { attributes: true, characterData: true, childList: true, subtree: true });
  });
  await page.mouse.move(first.x + 60, first.y + 90, { steps: 8 });
  await page.waitForFunction((y) => (document.querySelector('[data-node="node-a400"]')?.getBoundingClientRect().y ?? 0) > y + 20, first.y);
  expect(await wires()).not.toBe(before);
  expect(await page.evaluate(() => (window as unknown as { inspectorSeen: { changes: number } }).inspectorSeen.changes)).toBe(0);
  await page.mouse.up();
  await page.keyboard.press('Control+z');
  await page.waitForFunction(
    (y) => Math.abs((document.querySelector('[data-node="node-a400"]')?.getBoundingClientRect().y ?? 0) - y) < 1,
    first.y,
  );
  expect(await wires()).toBe(before);
});

test('zoomed in they are nodes with ports and wires again, and those out of sight cost nothing', async () => {
  const { page } = open;
  const at = await placeOf('node-a502');
  await page.mouse.click(at.x + at.width / 2, at.y + at.height / 2);
  await page.keyboard.press('Shift+F');
  await nodeCalled('node-a502').locator('.node-title').getByText('Gaussian blur').waitFor();
  await page.waitForFunction(() => document.querySelectorAll('.react-flow__node').length < 60);
  // Its wires, also to nodes out of sight.
  for (const wire of ['node-a477.layer -> node-a502.inputImage', 'node-a502.layer -> node-a527.inputImage'])
    await page.locator(`.react-flow__edge[data-id="${wire}"] path`).first().waitFor({ state: 'attached' });
  expect(await page.locator('.overview-wires').count()).toBe(0);
});
