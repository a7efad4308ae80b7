import { expect, test } from '@jest/globals';
import { chooseOption } from '../support/choose-option.ts';
import { gizmoKit } from '../support/gizmo-kit.ts';
import { type GraphText, useOneEditor } from '../support/open-editor.ts';

/** Three boxes in a row half a meter above the floor. */
const GRAPH: GraphText = {
  nodes: {
    'box-aaaa': { type: 'objects/primitive', params: { color: [0.9, 0.6, 0.1, 1], sizeM: [0.2, 0.2, 0.2] } },
    'raised-aaaa': { type: 'objects/transform', params: { positionM: [-0.4, 0.5, 0] } },
    'row-aaaa': { type: 'objects/copies', params: { count: 3, stepM: [0.4, 0, 0] } },
    'sun-aaaa': { type: 'light/directional' },
    'scene-aaaa': { type: 'layer/scene' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: [
    'box-aaaa.objects -> raised-aaaa.objects',
    'raised-aaaa.objects -> row-aaaa.objects',
    'row-aaaa.objects -> scene-aaaa.objects',
    'sun-aaaa.lights -> scene-aaaa.lights',
    'scene-aaaa.layer -> screen-aaaa.layer',
  ],
  places: {
    'box-aaaa': [0, 0],
    'raised-aaaa': [210, 0],
    'row-aaaa': [420, 0],
    'sun-aaaa': [420, 260],
    'scene-aaaa': [630, 0],
    'screen-aaaa': [820, 0],
  },
};

const open = useOneEditor(GRAPH, { colorScheme: 'dark' }, async () => {
  await open.editor.settled();
  await open.editor.rewind();
});
const { hasAxis, tip, holds, select, expectValue, tool, savedParams, undo } = gizmoKit(open);

test('copies are spaced by the second one and turned about y, as one step each; in a ring by the radius', async () => {
  const { page, editor } = open;
  await select('row');
  await tool(/^Move “Spacing” of Array/).waitFor();
  await holds('move');
  const across = await tip('x', ({ x }) => x);
  await page.mouse.move(across.x, across.y);
  await page.mouse.down();
  await page.keyboard.down('Control');
  await page.mouse.move(across.x + 30, across.y, { steps: 5 });
  await expectValue('Spacing X', (value) => value > 0.45);
  await page.mouse.up();
  await page.keyboard.up('Control');
  const { stepM } = (await savedParams('row-aaaa')) as { stepM: number[] };
  expect(stepM).toEqual([Math.round((stepM[0] ?? 0) * 10) / 10, 0, 0]);
  // The arrow went along with the pointer, and so did the second copy.
  const after = await tip('x', ({ x }) => x);
  expect(after.x - across.x).toBeGreaterThan(10);
  // A click on that copy, in the middle of the arrows, selects the Array, and again what it repeats.
  const left = await tip('x', ({ x }) => -x);
  const body = { x: (left.x + after.x) / 2, y: (left.y + after.y) / 2 };
  await select('screen');
  await page.mouse.click(body.x, body.y);
  await editor.inspector.getByRole('heading', { name: 'Array' }).waitFor();
  await page.mouse.click(body.x, body.y);
  await editor.inspector.getByRole('heading', { name: 'Primitive' }).waitFor();
  await undo();
  expect(await savedParams('row-aaaa')).toEqual({ count: 3, stepM: [0.4, 0, 0] });

  await select('row');
  await holds('move');
  const begun = await tip('x', ({ x }) => x);
  await page.mouse.move(begun.x, begun.y);
  await page.mouse.down();
  await page.mouse.move(begun.x + 30, begun.y, { steps: 5 });
  await expectValue('Spacing X', (value) => value > 0.45);
  await page.keyboard.press('Escape');
  await expectValue('Spacing X', (value) => value === 0.4);
  await page.mouse.up();

  await page.keyboard.press('e');
  await holds('rotate');
  const ring = await tip('y', ({ y }) => y);
  expect([await hasAxis('x'), await hasAxis('z')]).toEqual([false, false]);
  await page.mouse.move(ring.x, ring.y);
  await page.mouse.down();
  await page.mouse.move(ring.x + 30, ring.y, { steps: 5 });
  await expectValue('Rotation', (value) => value !== 0);
  await page.mouse.up();
  await undo();
  await expectValue('Rotation', (value) => value === 0);
  await page.keyboard.press('w');

  await chooseOption(editor.inspector.getByRole('combobox', { name: 'Pattern' }), 'ring');
  await tool(/^Move “Radius” of Array/).waitFor();
  await editor.settled();
  // Of both arrows of the only axis.
  const sideways = ({ x, y }: { readonly x: number; readonly y: number }) => x - y;
  const [near, far] = [await tip('z', sideways), await tip('z', (point) => -sideways(point))];
  expect([await hasAxis('x'), await hasAxis('y')]).toEqual([false, false]);
  const length = Math.hypot(far.x - near.x, far.y - near.y);
  await page.mouse.move(near.x, near.y);
  await page.mouse.down();
  await page.mouse.move(near.x + (15 * (near.x - far.x)) / length, near.y + (15 * (near.y - far.y)) / length, { steps: 5 });
  await expectValue('Radius', (value) => Math.abs(value - 1) > 0.03);
  await page.mouse.up();
  for (let step = 0; step < 2; step++) await undo();
});
