import { expect, test } from '@jest/globals';
import type { Locator } from 'playwright-core';
import { centerOf, type Point } from '../../tools/lib/center-of.ts';
import { Hand } from '../support/hand.ts';
import { type GraphText, saveGraphs, useEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';
import { holdRests, rest } from '../support/rest.ts';

const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'gaussian-blur-aaaa': { type: 'filter/gaussian-blur' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: ['video-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'gaussian-blur-aaaa': [260, 160], 'screen-aaaa': [520, 0] },
};
/** From 100 px apart to 180. */
const SPREAD = 1.8;

interface View extends Point {
  readonly zoom: number;
}

/** In the page: how the canvas is moved and scaled. */
function viewOf(): View {
  const element = document.querySelector('.react-flow__viewport');
  const { e: x, f: y, a: zoom } = new DOMMatrix(element ? getComputedStyle(element).transform : '');
  return { x, y, zoom };
}

/** Of a pinch. */
const STEPS = 8;
const openEditor = useEditor();

async function spot(locator: Locator): Promise<[x: number, y: number]> {
  const { x, y } = await centerOf(locator);
  return [x, y];
}

test('fingers move the view, nodes and wires, and resting ones ask for the menu', async () => {
  const open = await openEditor(GRAPH, { size: { width: 1024, height: 768 }, hasTouch: true, before: holdRests });
  const { page, editor } = open;
  const hand = await Hand.on(page);
  // Views glide to where they come to rest.
  const expectView = ({ x, y, zoom }: View) =>
    eventually(async () => {
      const now = await page.evaluate(viewOf);
      expect(Math.hypot(now.x - x, now.y - y)).toBeLessThan(2);
      expect(Math.abs(now.zoom / zoom - 1)).toBeLessThan(0.02);
    });
  const title = (node: string) => editor.node(node).locator('.node-title');

  // One finger moves the view.
  const empty = await editor.emptyPlace();
  const before = await page.evaluate(viewOf);
  await hand.drag(empty, { x: empty.x + 60, y: empty.y - 40 });
  const moved = { ...before, x: before.x + 60, y: before.y - 40 };
  await expectView(moved);

  // Two spread, and what is between them grows; what was in their middle stays there.
  const right = { x: empty.x + 100, y: empty.y };
  await hand.put(empty, right);
  for (let step = 1; step <= STEPS; step++) await hand.slide({ ...empty, x: empty.x - 5 * step }, { ...right, x: right.x + 5 * step });
  await hand.lift();
  const pane = await page.locator('.react-flow__pane').boundingBox();
  const middle = { x: empty.x + 50 - (pane?.x ?? 0), y: empty.y - (pane?.y ?? 0) };
  await expectView({
    x: middle.x + (moved.x - middle.x) * SPREAD,
    y: middle.y + (moved.y - middle.y) * SPREAD,
    zoom: moved.zoom * SPREAD,
  });
  await page.keyboard.press('f');
  await expectView(before);

  // A node goes with the finger on it, and a wire is drawn from port to port.
  const blur = await centerOf(title('gaussian-blur'));
  await hand.drag(blur, { x: blur.x, y: blur.y + 80 });
  const below = await centerOf(title('gaussian-blur'));
  // Nodes snap to the grid.
  expect(Math.abs(below.x - blur.x)).toBeLessThan(10);
  expect(below.y - blur.y).toBeGreaterThan(40);
  await hand.drag(
    await centerOf(editor.port('video-aaaa', 'layer', 'source')),
    await centerOf(editor.port('gaussian-blur-aaaa', 'inputImage', 'target')),
  );
  await page.getByRole('group', { name: 'Wire from Camera video to Gaussian blur' }).waitFor();

  // A finger that rests asks for the menu: of a node, and of the canvas. Lifted, it leaves it there.
  const menu = page.getByRole('menu', { name: 'Actions' });
  await hand.put(await centerOf(title('gaussian-blur')));
  await rest(page);
  await menu.getByRole('menuitemcheckbox', { name: 'Mute' }).waitFor();
  await hand.lift();
  const mute = await centerOf(menu.getByRole('menuitemcheckbox', { name: 'Mute' }));
  await page.touchscreen.tap(mute.x, mute.y);
  await page.locator('.node-muted').waitFor();
  await menu.waitFor({ state: 'detached' });
  const free = await editor.emptyPlace();
  await hand.put(free);
  await rest(page);
  await menu.getByRole('menuitem', { name: /^Add node/ }).waitFor();
  await hand.lift();
  const add = await centerOf(menu.getByRole('menuitem', { name: /^Add node/ }));
  await page.touchscreen.tap(add.x, add.y);
  await page.getByRole('combobox', { name: 'Search nodes' }).waitFor();
  await page.keyboard.press('Escape');

  // A number is turned like a dial, in spite of the panel that scrolls, and no hovering mouse goes on with it.
  await page.touchscreen.tap(...(await spot(title('gaussian-blur'))));
  const radius = editor.inspector.getByRole('textbox', { name: 'Radius', exact: true });
  const dial = await centerOf(radius);
  const still = Number(await radius.inputValue());
  await hand.drag(dial, { x: dial.x + 60, y: dial.y + 3 });
  await eventually(async () => expect(Number(await radius.inputValue())).toBeGreaterThan(still + 1));
  const turned = await radius.inputValue();
  await page.mouse.move(dial.x + 20, dial.y);
  await page.mouse.move(dial.x - 20, dial.y);
  expect(await radius.inputValue()).toBe(turned);

  // All of it is in the project.
  const { main } = await saveGraphs(open);
  expect(main?.wires).toContain('video-aaaa.layer -> gaussian-blur-aaaa.inputImage');
  expect(main?.nodes['gaussian-blur-aaaa']).toMatchObject({ muted: true });
});

test('what the browser takes the finger away from stays where it is', async () => {
  const key = (timeS: number, value: number) => ({ timeS, value, easing: 'linear' as const });
  const blur = { type: 'filter/gaussian-blur', params: { radius: { track: { repeat: 'once' as const, keys: [key(0, 1), key(1, 4)] } } } };
  const nodes = { ...GRAPH.nodes, 'gaussian-blur-aaaa': blur };
  const { page, editor } = await openEditor({ ...GRAPH, nodes }, { size: { width: 1440, height: 900 }, hasTouch: true });
  const hand = await Hand.on(page);
  /** Drags it by 40 px, loses the finger, and points at it with a mouse that no button is pressed of. */
  const drop = async (handle: Locator): Promise<[dropped: Point, after: Point]> => {
    const from = await centerOf(handle);
    await hand.put(from);
    for (let step = 1; step <= STEPS; step++) await hand.slide({ x: from.x - 5 * step, y: from.y });
    await eventually(async () => expect((await centerOf(handle)).x).toBeLessThan(from.x - 20));
    await hand.lose();
    const dropped = await centerOf(handle);
    await page.mouse.move(dropped.x, dropped.y);
    for (let step = 1; step <= STEPS; step++) await page.mouse.move(dropped.x + step, dropped.y);
    return [dropped, await centerOf(handle)];
  };

  const [border, borderAfter] = await drop(page.getByRole('separator', { name: 'Width of preview and inspector' }));
  expect(borderAfter).toEqual(border);

  await page.touchscreen.tap(...(await spot(editor.node('gaussian-blur').locator('.node-title'))));
  await page.keyboard.press('Shift+T');
  const [dropped, after] = await drop(page.getByRole('button', { name: /^Keyframe 2, / }));
  expect(after).toEqual(dropped);
});
