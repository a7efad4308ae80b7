import { expect, test } from '@jest/globals';
import type { Point } from '../../tools/lib/center-of.ts';
import { chooseOption } from '../support/choose-option.ts';
import { type Axis, gizmoKit } from '../support/gizmo-kit.ts';
import { type GraphText, useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

/** Three boxes in a row half a meter above the floor, through a filter, and a lamp as bright as a region of the camera image; gray in a shape. */
const GRAPH: GraphText = {
  nodes: {
    'box-aaaa': { type: 'objects/primitive', params: { color: [0.9, 0.6, 0.1, 1], sizeM: [0.2, 0.2, 0.2] } },
    'raised-aaaa': { type: 'objects/transform', params: { positionM: [-0.4, 0.5, 0] } },
    'row-aaaa': { type: 'objects/copies', params: { count: 3, stepM: [0.4, 0, 0] } },
    'viewpoint-aaaa': { type: 'pose/from-values', params: { positionM: [0.1, 0.7, -0.6], rotationRad: [0, Math.PI / 2, 0] } },
    'beside-aaaa': { type: 'pose/offset', params: { offsetM: [0, 0, 0.3] } },
    'ball-aaaa': { type: 'objects/primitive', params: { shape: 'sphere', sizeM: [0.1, 0.1, 0.1] } },
    'there-aaaa': { type: 'objects/at-pose' },
    'sun-aaaa': { type: 'light/directional' },
    'lamp-aaaa': { type: 'light/point' },
    'scene-aaaa': { type: 'layer/scene' },
    'swirl-aaaa': { type: 'filter/swirl', params: { angle: 0.5, radius: 60 } },
    'camera-aaaa': { type: 'source/camera-video' },
    'measure-aaaa': { type: 'layer/measure-mask', params: { regionMin: [0.2, 0.2], regionMax: [0.6, 0.6] } },
    'gray-aaaa': { type: 'filter/grey' },
    'shape-aaaa': { type: 'generator/shape-mask', params: { center: [0.4, 0.4], size: [0.3, 0.2] } },
    'matte-aaaa': { type: 'operator/choose-by-mask' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: [
    'box-aaaa.objects -> raised-aaaa.objects',
    'raised-aaaa.objects -> row-aaaa.objects',
    'row-aaaa.objects -> scene-aaaa.objects',
    'viewpoint-aaaa.pose -> beside-aaaa.pose',
    'beside-aaaa.pose -> there-aaaa.pose',
    'ball-aaaa.objects -> there-aaaa.objects',
    'there-aaaa.objects -> scene-aaaa.objects',
    'sun-aaaa.lights -> scene-aaaa.lights',
    'measure-aaaa.area -> lamp-aaaa.intensityCd',
    'lamp-aaaa.lights -> scene-aaaa.lights',
    'scene-aaaa.layer -> swirl-aaaa.inputImage',
    'camera-aaaa.layer -> measure-aaaa.mask',
    'swirl-aaaa.layer -> gray-aaaa.inputImage',
    'gray-aaaa.layer -> matte-aaaa.inside',
    'swirl-aaaa.layer -> matte-aaaa.outside',
    'shape-aaaa.layer -> matte-aaaa.mask',
    'matte-aaaa.layer -> screen-aaaa.layer',
  ],
  places: {
    'box-aaaa': [0, 0],
    'raised-aaaa': [210, 0],
    'row-aaaa': [420, 0],
    'viewpoint-aaaa': [0, 520],
    'beside-aaaa': [210, 520],
    'ball-aaaa': [210, 690],
    'there-aaaa': [420, 520],
    'sun-aaaa': [420, 260],
    'lamp-aaaa': [210, 260],
    'camera-aaaa': [630, 260],
    'scene-aaaa': [630, 0],
    'swirl-aaaa': [820, 0],
    'measure-aaaa': [820, 260],
    'gray-aaaa': [1030, 0],
    'shape-aaaa': [1030, 260],
    'matte-aaaa': [1240, 0],
    'screen-aaaa': [1450, 0],
  },
};

const open = useOneEditor(GRAPH, { colorScheme: 'dark' }, async () => {
  await open.editor.settled();
  await open.editor.rewind();
});
const { frameBox, seeAxis, hasAxis, tip, holds, select, expectValue, tool, savedParams, undo } = gizmoKit(open);

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

/** The middle of the pixels of a part of the gizmo in the image, which has the color of an axis. */
async function part(color: Axis): Promise<Point> {
  const points = await seeAxis(color);
  const mean = (of: (point: Point) => number) => points.reduce((sum, point) => sum + of(point), 0) / points.length;
  return { x: mean(({ x }) => x), y: mean(({ y }) => y) };
}

test('a filter is placed in the image by its center, its circle and its angle, as one step each', async () => {
  const { page, editor } = open;
  await select('swirl');
  await tool(/^Handles of Swirl/).waitFor();
  await editor.preview.locator('#image-gizmo[data-mode="move"]').waitFor();
  const frame = await frameBox();
  const center = await part('z');
  expect(Math.abs(center.x - frame.x - frame.width / 2)).toBeLessThan(3);
  expect(Math.abs(center.y - frame.y - frame.height / 2)).toBeLessThan(3);
  await page.mouse.move(center.x, center.y);
  await page.mouse.down();
  await page.mouse.move(center.x + frame.width / 5, center.y, { steps: 5 });
  await expectValue('Center X', (value) => value > 0.65);
  await page.keyboard.down('Control');
  await page.mouse.move(center.x + frame.width / 5 + 3, center.y, { steps: 2 });
  await expectValue('Center X', (value) => value === 0.7);
  await page.mouse.up();
  await page.keyboard.up('Control');
  await page.mouse.move(center.x - 80, center.y + 90);
  const moved = await part('z');
  expect(Math.abs(moved.x - center.x - frame.width / 5)).toBeLessThan(3);
  expect((await savedParams('swirl-aaaa')).center).toEqual([0.7, 0.5]);

  const ring = await tip('y', ({ y }) => y);
  await page.mouse.move(ring.x, ring.y);
  await page.mouse.down();
  await page.mouse.move(ring.x, ring.y + 20, { steps: 4 });
  await expectValue('Radius', (value) => value > 75);
  await page.keyboard.press('Escape');
  await expectValue('Radius', (value) => value === 60);
  await page.mouse.up();

  // A quarter turn: the angle's part stands on its circle around the center.
  const arm = await tip('x', ({ x }) => x);
  await page.mouse.move(arm.x, arm.y);
  await page.mouse.down();
  await page.mouse.move(2 * moved.x - arm.x, 2 * moved.y - arm.y, { steps: 12 });
  await expectValue('Angle', (value) => Math.abs(value - (0.5 * 180) / Math.PI) > 170);
  await page.mouse.up();
  for (let step = 0; step < 2; step++) await undo();
  expect(await savedParams('swirl-aaaa')).toEqual({ angle: 0.5, radius: 60 });
});

test('a region is placed by its corners', async () => {
  const { page, editor } = open;
  await select('measure');
  await editor.preview.locator('#image-gizmo[data-mode="move"][data-node="measure-aaaa"]').waitFor();
  await tool(/^Handles of Measure mask/).waitFor();
  const corner = await tip('z', ({ x, y }) => x - y);
  await page.mouse.move(corner.x, corner.y);
  await page.mouse.down();
  const { width } = await frameBox();
  await page.mouse.move(corner.x + width / 10, corner.y, { steps: 4 });
  await expectValue('Region, top right X', (value) => value > 0.68 && value < 0.72);
  await page.mouse.up();
  await undo();
  expect(await savedParams('measure-aaaa')).toEqual({ regionMin: [0.2, 0.2], regionMax: [0.6, 0.6] });
});

test('a shape is resized by a corner while the opposite one stays, rotated, and softened; Shift is fine', async () => {
  const { page, editor } = open;
  await select('shape');
  await editor.preview.locator('#image-gizmo[data-mode="move"][data-node="shape-aaaa"]').waitFor();
  await tool(/^Handles of Shape mask/).waitFor();
  const { width, height } = await frameBox();
  const isTopRight = ({ x, y }: Point) => x - y;
  const isLowLeft = ({ x, y }: Point) => y - x;
  const [corner, opposite] = [await tip('z', isTopRight), await tip('z', isLowLeft)];
  await page.mouse.move(corner.x, corner.y);
  await page.mouse.down();
  await page.mouse.move(corner.x + height / 10, corner.y, { steps: 4 });
  await expectValue('Size X', (value) => Math.abs(value - 0.4) < 0.015);
  await page.keyboard.down('Shift');
  await page.mouse.move(corner.x + height / 5, corner.y, { steps: 4 });
  await expectValue('Size X', (value) => Math.abs(value - 0.41) < 0.015);
  await page.mouse.up();
  await page.keyboard.up('Shift');
  const { size, center } = (await savedParams('shape-aaaa')) as { size: number[]; center: number[] };
  expect(size).toEqual([expect.any(Number), 0.2]);
  expect(center).toEqual([expect.closeTo(0.4 + (((size[0] ?? 0) - 0.3) / 2) * (height / width), 2), 0.4]);
  await page.mouse.move(corner.x - 80, corner.y - 60);
  const still = await tip('z', isLowLeft);
  expect(Math.hypot(still.x - opposite.x, still.y - opposite.y)).toBeLessThan(2);
  await undo();
  expect(await savedParams('shape-aaaa')).toEqual({ center: [0.4, 0.4], size: [0.3, 0.2] });
  const isBack = async () => {
    const { x, y } = await tip('z', isTopRight);
    if (Math.hypot(x - corner.x, y - corner.y) > 2) throw new Error('The corner is not back yet.');
  };
  await eventually(isBack);

  const edge = await tip('y', ({ y }) => y);
  await page.mouse.move(edge.x, edge.y);
  await page.mouse.down();
  await page.mouse.move(edge.x, edge.y + height / 20, { steps: 4 });
  await expectValue('Feather', (value) => Math.abs(value - 0.1) < 0.015);
  await page.mouse.up();
  await undo();
  await eventually(isBack);
  // A quarter turn, counterclockwise.
  const arm = await tip('x', ({ x }) => x);
  const middle = { x: (corner.x + opposite.x) / 2, y: (corner.y + opposite.y) / 2 };
  await page.mouse.move(arm.x, arm.y);
  await page.mouse.down();
  await page.mouse.move(middle.x, middle.y - (arm.x - middle.x), { steps: 12 });
  await expectValue('Rotation', (value) => Math.abs(value - 90) < 5);
  await page.mouse.up();
  await undo();
  expect(await savedParams('shape-aaaa')).toEqual({ center: [0.4, 0.4], size: [0.3, 0.2] });
});

test('a pose is moved and rotated in world space, and an offset along the axes of its pose', async () => {
  const { page } = open;
  await select('viewpoint');
  await tool(/^Move Values to pose/).waitFor();
  await holds('move');
  await open.editor.preview.locator('#gizmo[data-node="viewpoint-aaaa"]').waitFor();
  const up = await tip('y', ({ y }) => -y);
  await page.mouse.move(up.x, up.y);
  await page.mouse.down();
  await page.mouse.move(up.x, up.y - 30, { steps: 4 });
  await expectValue('Position Y', (value) => value > 0.75);
  await page.mouse.up();
  expect((await savedParams('viewpoint-aaaa')).positionM).toEqual([0.1, expect.any(Number), -0.6]);
  await undo();
  const before = await middle();

  await select('beside');
  await open.editor.preview.locator('#gizmo[data-node="beside-aaaa"]').waitFor();
  // A quarter turn about y makes x of z: the gizmo stands to the right of the pose.
  const beside = await middle();
  expect(beside.x - before.x).toBeGreaterThan(20);
  const across = await tip('x', ({ x }) => x);
  await page.mouse.move(across.x, across.y);
  await page.mouse.down();
  await page.mouse.move(across.x + 30, across.y, { steps: 4 });
  await expectValue('Offset Z', (value) => value > 0.35);
  await page.mouse.up();
  await undo();
  expect(await savedParams('beside-aaaa')).toEqual({ offsetM: [0, 0, 0.3] });
});

/** The middle between both arrows of the x axis. */
async function middle(): Promise<Point> {
  const [left, right] = [await tip('x', ({ x }) => -x), await tip('x', ({ x }) => x)];
  return { x: (left.x + right.x) / 2, y: (left.y + right.y) / 2 };
}
