import { expect, test } from '@jest/globals';
import type { Point } from '../../tools/lib/center-of.ts';
import { chooseOption } from '../support/choose-option.ts';
import { type Axis, gizmoKit } from '../support/gizmo-kit.ts';
import type { RgbaImage } from '../support/image.ts';
import { type GraphText, saveGraphs, useOneEditor } from '../support/open-editor.ts';

/** A box with two Transforms, a point light whose position is connected, and a directional light. */
const GRAPH: GraphText = {
  nodes: {
    'box-aaaa': { type: 'objects/primitive', params: { color: [0.9, 0.6, 0.1, 1], sizeM: [0.4, 0.3, 0.2] } },
    'transform-aaaa': { type: 'objects/transform', params: { positionM: [0, 0.5, 0] } },
    'outer-aaaa': { type: 'objects/transform', params: { rotationRad: [0, Math.PI / 2, 0], scale: 0.5 } },
    'lamp-aaaa': { type: 'light/point' },
    'place-aaaa': { type: 'value/make-vector3' },
    'sun-aaaa': { type: 'light/directional' },
    'scene-aaaa': { type: 'layer/scene' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: [
    'box-aaaa.objects -> transform-aaaa.objects',
    'transform-aaaa.objects -> outer-aaaa.objects',
    'outer-aaaa.objects -> scene-aaaa.objects',
    'place-aaaa.vector -> lamp-aaaa.positionM',
    'lamp-aaaa.lights -> scene-aaaa.lights',
    'sun-aaaa.lights -> scene-aaaa.lights',
    'scene-aaaa.layer -> screen-aaaa.layer',
  ],
  places: {
    'box-aaaa': [0, 0],
    'transform-aaaa': [210, 0],
    'outer-aaaa': [420, 0],
    'place-aaaa': [0, 260],
    'lamp-aaaa': [210, 260],
    'sun-aaaa': [420, 260],
    'scene-aaaa': [630, 0],
    'screen-aaaa': [820, 0],
  },
};

/** With the Transform selected, before anything was moved. */
let rest: RgbaImage;
const open = useOneEditor(GRAPH, { colorScheme: 'dark' }, async () => {
  await open.editor.settled();
  await open.editor.rewind();
});

const { frameBox, seeAxis, tip, holds, select, numberIn, expectValue, tool, savedParams, undo } = gizmoKit(open);

/** The pixel of an axis in the lower half that is farthest from the others: rings cross. */
async function apart(axis: Axis, others: readonly Axis[]): Promise<Point> {
  const points = await seeAxis(axis);
  const crossing = (await Promise.all(others.map(seeAxis))).flat();
  const middle = points.reduce((sum, { y }) => sum + y, 0) / points.length;
  const distance = (a: Point): number => Math.min(...crossing.map((b) => Math.hypot(a.x - b.x, a.y - b.y)));
  return points.filter(({ y }) => y > middle).reduce((best, point) => (distance(point) > distance(best) ? point : best));
}

test('dragging an arrow moves the thing under the pointer, in the picture and in the inspector, as one step', async () => {
  const { page, editor } = open;
  await select('transform');
  await holds('move');
  rest = await editor.restingImage();
  // Outside, a quarter turn about y makes z of x, and half the size half the way.
  const up = await tip('y', ({ y }) => -y);
  await page.mouse.move(up.x, up.y);
  await page.mouse.down();
  await page.mouse.move(up.x, up.y - 20, { steps: 4 });
  await expectValue('Position Y', (value) => value > 0.51);
  const half = await numberIn('Position Y');
  await page.mouse.move(up.x, up.y - 40, { steps: 4 });
  await expectValue('Position Y', (value) => value > half + 0.01);
  await page.mouse.up();
  await page.mouse.move(up.x + 150, up.y - 60);
  await editor.imageOtherThan(rest);
  // The arrow went along with the pointer, so that the place is right although another Transform comes after.
  const after = await tip('y', ({ y }) => -y);
  expect(Math.abs(up.y - 40 - after.y)).toBeLessThan(4);
  const { positionM } = (await savedParams('transform-aaaa')) as { positionM: number[] };
  expect(positionM[0]).toBe(0);
  expect(positionM[1]).toBeCloseTo(await numberIn('Position Y'), 3);
  await undo();
  expect(await savedParams('transform-aaaa')).toEqual({ positionM: [0, 0.5, 0] });
  await editor.imageSameAs(rest, 'gizmo-undone');
});

test('Escape in the middle of a drag leaves everything as it was, and nothing to undo', async () => {
  const { page, editor } = open;
  const up = await tip('y', ({ y }) => -y);
  await page.mouse.move(up.x, up.y);
  await page.mouse.down();
  await page.mouse.move(up.x, up.y - 30, { steps: 4 });
  await expectValue('Position Y', (value) => value > 0.51);
  await page.keyboard.press('Escape');
  await expectValue('Position Y', (value) => value === 0.5);
  await page.mouse.move(up.x, up.y - 60, { steps: 3 });
  await page.mouse.up();
  await page.mouse.move(up.x + 150, up.y - 60);
  expect(await savedParams('transform-aaaa')).toEqual({ positionM: [0, 0.5, 0] });
  await editor.imageSameAs(rest, 'gizmo-escaped');
  // The step before was undone; it is still there to be done again.
  await page.locator('.canvas').focus();
  expect(await page.getByRole('button', { name: 'Undo' }).isDisabled()).toBe(true);
});

test('Ctrl snaps to tenths of a meter, rings turn by 15°, boxes resize by tenths; keys change between them', async () => {
  const { page } = open;
  const up = await tip('y', ({ y }) => -y);
  await page.mouse.move(up.x, up.y);
  await page.mouse.down();
  await page.keyboard.down('Control');
  await page.mouse.move(up.x, up.y - 25, { steps: 5 });
  await expectValue('Position Y', (value) => value > 0.55);
  await page.mouse.up();
  await page.keyboard.up('Control');
  const height = await numberIn('Position Y');
  // Along the world's axis, of which the outer Transform makes half.
  expect(Math.abs((height / 2) * 10 - Math.round((height / 2) * 10))).toBeLessThan(1e-3);
  await undo();

  await page.keyboard.press('Shift+X');
  await page.keyboard.press('e');
  await tool(/^Rotate Transform/)
    .and(page.locator('[aria-pressed="true"]'))
    .waitFor();
  await holds('rotate');
  const ring = await apart('y', ['x', 'z']);
  await page.mouse.move(ring.x, ring.y);
  await page.mouse.down();
  await page.mouse.move(ring.x + 40, ring.y, { steps: 6 });
  await expectValue('Rotation Y', (value) => value !== 0);
  await page.mouse.up();
  const angle = await numberIn('Rotation Y');
  expect(Math.abs(angle / 15 - Math.round(angle / 15))).toBeLessThan(1e-3);
  expect([await numberIn('Rotation X'), await numberIn('Rotation Z')]).toEqual([0, 0]);
  await undo();

  await page.keyboard.press('s');
  await tool(/^Scale Transform/)
    .and(page.locator('[aria-pressed="true"]'))
    .waitFor();
  await holds('scale');
  const top = await tip('y', ({ y }) => -y);
  await page.mouse.move(top.x, top.y);
  await page.mouse.down();
  await page.mouse.move(top.x, top.y - 40, { steps: 6 });
  await expectValue('Scale', (value) => value > 1.05);
  await page.mouse.up();
  const scale = await numberIn('Scale');
  expect(Math.abs(scale * 10 - Math.round(scale * 10))).toBeLessThan(1e-6);
  await undo();
  expect(await savedParams('transform-aaaa')).toEqual({ positionM: [0, 0.5, 0] });
  await page.keyboard.press('Shift+X');
  await page.keyboard.press('w');
});

test('a click on an object selects the node that made it, again what places it, and keys go on working', async () => {
  const { page, editor } = open;
  await holds('move');
  const [left, right] = [await tip('x', ({ x }) => -x), await tip('x', ({ x }) => x)];
  const body = { x: (left.x + right.x) / 2, y: (left.y + right.y) / 2 };
  const frame = await frameBox();
  await select('screen');
  await page.mouse.click(body.x, body.y);
  await editor.inspector.getByRole('heading', { name: 'Primitive' }).waitFor();
  // It has a size of its own and is moved by what comes after it.
  await tool(/^Move Transform/).waitFor();
  await tool(/^Scale Primitive/).waitFor();
  await page.mouse.click(frame.x + frame.width - 30, frame.y + 60);
  await page.mouse.click(body.x, body.y);
  await editor.inspector.getByRole('heading', { name: 'Transform' }).waitFor();
  // The preview has the focus now, and what is pressed is for the editor all the same.
  await page.keyboard.press('e');
  await tool(/^Rotate/)
    .and(page.locator('[aria-pressed="true"]'))
    .waitFor();
  await page.keyboard.press('g');
  await tool(/^Move/).and(page.locator('[aria-pressed="true"]')).waitFor();
  await page.keyboard.press('x');
  await tool(/^Local space/)
    .and(page.locator('[aria-pressed="true"]'))
    .waitFor();
  await page.keyboard.press('x');
});

test('a connected param disables the tool, and its tooltip says why', async () => {
  const { page } = open;
  await select('lamp');
  const move = tool(/^Move: “Position” of Point light is connected/);
  await move.waitFor();
  expect(await move.getAttribute('aria-disabled')).toBe('true');
  await move.hover();
  await page.locator('.tooltip').getByText('“Position” of Point light is connected. Disconnect it to use the gizmo.').waitFor();
  await select('screen');
  await page.getByRole('toolbar', { name: 'Gizmo' }).waitFor({ state: 'detached' });
  // The sun has no place, and can be turned.
  await select('sun');
  await page.keyboard.press('e');
  await holds('rotate');
  const ring = await tip('y', ({ y }) => y);
  const before = await numberIn('Azimuth');
  await page.mouse.move(ring.x, ring.y);
  await page.mouse.down();
  await page.mouse.move(ring.x + 30, ring.y, { steps: 5 });
  await expectValue('Azimuth', (value) => value !== before);
  await page.mouse.up();
  await undo();
  await expectValue('Azimuth', (value) => value === before);
  await page.keyboard.press('w');
});

test('the first drag of an object without a Transform adds one, as one step', async () => {
  const { page, editor } = open;
  await select('outer');
  await editor
    .node('transform')
    .locator('.node-title')
    .click({ modifiers: ['Shift'] });
  await page.keyboard.press('Delete');
  await editor.wire(['box-aaaa', 'objects'], ['scene-aaaa', 'objects']);
  const before = await saveGraphs(open);
  await select('box');
  await tool(/^Move Transform/).waitFor();
  await holds('move');
  const up = await tip('y', ({ y }) => -y);
  await page.mouse.move(up.x, up.y);
  await page.mouse.down();
  await page.mouse.move(up.x, up.y - 40, { steps: 6 });
  const added = editor.node('transform');
  await added.waitFor();
  await page.mouse.move(up.x, up.y - 60, { steps: 6 });
  await page.mouse.up();
  // The arrow went along with the pointer, and so did the box that it moves.
  const after = await tip('y', ({ y }) => -y);
  expect(Math.abs(up.y - 60 - after.y)).toBeLessThan(6);
  const { positionM } = (await savedParams(await editor.nodeId('transform'))) as { positionM: number[] };
  expect(positionM).toEqual([0, expect.any(Number), 0]);
  expect(positionM[1]).toBeGreaterThan(0.05);
  await undo();
  expect(await saveGraphs(open)).toEqual(before);
  for (let step = 0; step < 2; step++) await undo();
  await editor.node('outer').waitFor();
});

test('in an emulated room of two views it stands in the left one, while all plays', async () => {
  const { page, editor } = open;
  await editor.press('Headset');
  await chooseOption(page.getByRole('combobox', { name: 'Preview source' }), 'room/studio');
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await editor.settled();
  await select('transform');
  const frame = await frameBox();
  await holds('move');
  const points = await seeAxis('y');
  for (const { x } of points) expect(x).toBeLessThan(frame.x + frame.width / 2);
  const up = await tip('y', ({ y }) => -y);
  await page.mouse.move(up.x, up.y);
  await page.mouse.down();
  await page.mouse.move(up.x, up.y - 12, { steps: 6 });
  await expectValue('Position Y', (value) => value > 0.505);
  await page.mouse.up();
  await undo();
  expect(await savedParams('transform-aaaa')).toEqual({ positionM: [0, 0.5, 0] });
});
