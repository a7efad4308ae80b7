import { afterEach, describe, expect, test } from '@jest/globals';
import { centerOf } from '../../tools/lib/center-of.ts';
import { frameOf } from '../../tools/lib/frame-of.ts';
import { type GraphText, useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'sepia-aaaa': { type: 'filter/sepia' },
    'gaussian-blur-aaaa': { type: 'filter/gaussian-blur' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: [
    'video-aaaa.layer -> sepia-aaaa.inputImage',
    'sepia-aaaa.layer -> gaussian-blur-aaaa.inputImage',
    'gaussian-blur-aaaa.layer -> screen-aaaa.layer',
  ],
  places: { 'video-aaaa': [0, 0], 'sepia-aaaa': [400, 0], 'gaussian-blur-aaaa': [800, 0], 'screen-aaaa': [1400, 300] },
};

const open = useOneEditor(GRAPH, { size: { width: 1440, height: 900 }, colorScheme: 'dark', panels: 'usual' });

/** The room of the preview beside its rail. A recording fills it in one direction. */
async function previewBox() {
  const box = await open.page.locator('.stage-room').boundingBox();
  if (!box) throw new Error('The preview has no box.');
  return box;
}

/** Width of the rail with frames and tools, left of the image. */
const RAIL_PX = 33;

const canvasBox = async () => {
  const box = await open.page.locator('.canvas').boundingBox();
  if (!box) throw new Error('The canvas has no box.');
  return box;
};

/** How many nodes the canvas shows whole. */
async function nodesInView(): Promise<number> {
  const canvas = await canvasBox();
  const boxes = await Promise.all((await open.page.locator('.react-flow__node').all()).map((node) => node.boundingBox()));
  const isWithin = (start: number, length: number, from: number, size: number) => start >= from && start + length <= from + size;
  return boxes.filter(
    (box) => box && isWithin(box.x, box.width, canvas.x, canvas.width) && isWithin(box.y, box.height, canvas.y, canvas.height),
  ).length;
}

/** What the middle of the canvas shows, in canvas units, and the zoom. */
async function middle() {
  const { width, height } = await canvasBox();
  const [zoom = 0, x = 0, y = 0] = await open.page
    .locator('.react-flow__viewport')
    .evaluate((element) => [new DOMMatrix(getComputedStyle(element).transform)].flatMap(({ a, e, f }) => [a, e, f]));
  return { x: (width / 2 - x) / zoom, y: (height / 2 - y) / zoom, zoom };
}

/** Pans the canvas up by the middle button. */
async function panUp(byPx: number): Promise<void> {
  const { x, y, height } = await canvasBox();
  const before = await middle();
  await open.page.mouse.move(x + 40, y + height - 60);
  await open.page.mouse.down({ button: 'middle' });
  await open.page.mouse.move(x + 40, y + height - 60 - byPx, { steps: 4 });
  await open.page.mouse.up({ button: 'middle' });
  await eventually(async () => expect((await middle()).y - before.y).toBeCloseTo(byPx / before.zoom, 0));
}

async function run(command: string): Promise<void> {
  await open.page.keyboard.press('Control+k');
  await open.page.keyboard.type(command);
  await open.page.keyboard.press('Enter');
}

describe('the layout of the window', () => {
  afterEach(() => run('Dock preview right'));

  test('gives the preview 40 % of the width, and no label is below 11 px in the view that fits the graph', async () => {
    expect((await previewBox()).width).toBeGreaterThanOrEqual(1440 * 0.4);
    await run('Fit graph to view');
    const heights = await open.page.locator('.node-title, .port-label').evaluateAll((labels) =>
      labels
        .filter((label) => getComputedStyle(label).display !== 'none')
        .map((label) => {
          const zoom = label.getBoundingClientRect().height / (label as HTMLElement).offsetHeight;
          return Number.parseFloat(getComputedStyle(label).fontSize) * zoom;
        }),
    );
    expect(heights.length).toBeGreaterThanOrEqual(4);
    expect(Math.min(...heights)).toBeGreaterThanOrEqual(10.9);
  });

  test('shows a recording in its own shape', async () => {
    const box = await open.page.locator('iframe[title="Preview"]').boundingBox();
    // Whole pixels.
    expect(Math.abs((box?.width ?? 0) - (box?.height ?? 0) * (4 / 3))).toBeLessThan(1.5);
  });

  test('gives an upright phone nearly the whole height beside the inspector, without loading its page again', async () => {
    const frame = await frameOf(open.page);
    await frame.evaluate(() => Object.assign(window, { upright: true }));
    await open.page.getByRole('button', { name: 'Phone, portrait' }).click();
    const phone = open.page.locator('.stage-device');
    await eventually(async () => expect((await phone.boundingBox())?.height).toBeGreaterThan(900 * 0.8));
    const box = await phone.boundingBox();
    expect(((box?.width ?? 0) / (box?.height ?? 1)) * (19.5 / 9)).toBeCloseTo(1, 1);
    const inspector = await open.editor.inspector.boundingBox();
    expect(inspector?.x).toBeGreaterThanOrEqual((box?.x ?? 0) + (box?.width ?? 0));
    expect(inspector?.width).toBeGreaterThanOrEqual(260);
    expect(await frame.evaluate(() => 'upright' in window)).toBe(true);
    await open.page.getByRole('button', { name: 'Fit to panel' }).click();
    await eventually(async () => expect((await previewBox()).width).toBeGreaterThanOrEqual(1440 * 0.4));
  });

  test('docks the preview left and below without loading its page again, and fits the graph', async () => {
    const frame = await frameOf(open.page);
    await frame.evaluate(() => Object.assign(window, { mark: true }));
    await run('Dock preview left');
    await eventually(async () => expect((await previewBox()).x).toBe(RAIL_PX));
    expect((await canvasBox()).x).toBeGreaterThan(500);
    await run('Dock preview below');
    await eventually(async () => expect((await previewBox()).y).toBeGreaterThan(300));
    expect((await canvasBox()).width).toBe(1440);
    const canvas = await canvasBox();
    await eventually(async () => {
      for (const node of await open.page.locator('.react-flow__node').all()) {
        const box = await node.boundingBox();
        expect(box && box.y + box.height <= canvas.y + canvas.height).toBe(true);
      }
    });
    expect(await frame.evaluate(() => 'mark' in window)).toBe(true);
  });

  test('the bottom panel leaves in view what was: a graph that was fitted whole, else what was in the middle', async () => {
    await run('Fit graph to view');
    await eventually(async () => expect(await nodesInView()).toBe(4));
    const tall = (await canvasBox()).height;
    await run('Timeline');
    await eventually(async () => expect((await canvasBox()).height).toBeLessThan(tall - 100));
    await eventually(async () => expect(await nodesInView()).toBe(4));
    await run('Timeline');
    await eventually(async () => expect((await canvasBox()).height).toBe(tall));

    await open.editor.node('sepia').click();
    await run('Show the selection');
    await eventually(async () => expect((await middle()).zoom).toBeGreaterThan(0.9));
    // The view is still on its way.
    await centerOf(open.editor.node('sepia'));
    const before = await middle();
    const isKept = () =>
      eventually(async () => {
        const now = await middle();
        for (const axis of ['x', 'y', 'zoom'] as const) expect(Math.abs(now[axis] - before[axis])).toBeLessThan(1);
      });
    await run('Timeline');
    await eventually(async () => expect((await canvasBox()).height).toBeLessThan(tall - 100));
    await isKept();
    await run('Timeline');
    await eventually(async () => expect((await canvasBox()).height).toBe(tall));
    await isKept();
    await run('Fit graph to view');
  });

  test('undo and redo show the graph again where none of it is in view, and else leave the view', async () => {
    const { page, editor } = open;
    await run('Fit graph to view');
    await eventually(async () => expect(await nodesInView()).toBe(4));
    const heightOf = async () => (await centerOf(editor.node('screen'))).y;
    await editor.node('screen').click();
    const start = await heightOf();
    await page.keyboard.press('ArrowDown');
    await eventually(async () => expect(await heightOf()).toBeGreaterThan(start + 2));

    // The output is still in view.
    await panUp(300);
    const before = await middle();
    await page.keyboard.press('Control+z');
    await eventually(async () => expect(await heightOf()).toBeCloseTo(start - 300, 0));
    expect(await middle()).toEqual(before);

    await panUp(400);
    expect(await nodesInView()).toBe(0);
    await page.keyboard.press('Control+Shift+z');
    await eventually(async () => expect(await nodesInView()).toBe(4));
    const lower = await heightOf();
    await page.keyboard.press('Control+z');
    await eventually(async () => expect(await heightOf()).toBeLessThan(lower - 2));
  });

  test.each([
    ['short', 0],
    ['long', 120],
  ])('a view on its way to the whole graph arrives there although the canvas is resized meanwhile, with %s frames', async (_, busyMs) => {
    const { page, editor } = open;
    await editor.node('sepia').click();
    await run('Show the selection');
    await eventually(async () => expect((await middle()).zoom).toBeGreaterThan(0.9));
    // With reduced motion, the view would arrive at once.
    await page.emulateMedia({ reducedMotion: 'no-preference' });
    await page.locator('.canvas').hover();
    await page.locator('.canvas').evaluate(async (canvas, frameMs) => {
      canvas.dispatchEvent(new KeyboardEvent('keydown', { key: 'f', bubbles: true }));
      for (let frames = 0; frames < 3; frames++) {
        const endMs = performance.now() + frameMs;
        while (performance.now() < endMs);
        await new Promise(requestAnimationFrame);
      }
      // Timers that are due run first.
      await new Promise((done) => setTimeout(done));
      document.querySelector<HTMLElement>('.app')?.style.setProperty('width', '1100px');
    }, busyMs);
    await eventually(async () => expect((await canvasBox()).width).toBeLessThan(700));
    await eventually(async () => expect(await nodesInView()).toBe(4));
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await page.locator('.app').evaluate((app) => app.style.removeProperty('width'));
    await eventually(async () => expect(await nodesInView()).toBe(4));
  });

  test('fills the window with the preview, with the graph over it, until Escape', async () => {
    await open.page.locator('.canvas').hover();
    await open.page.keyboard.press('v');
    await eventually(async () => expect((await previewBox()).width).toBe(1440 - RAIL_PX));
    await open.page.keyboard.press('Escape');
    await eventually(async () => expect((await previewBox()).width).toBeLessThan(700));
    await open.page.keyboard.press('Shift+v');
    await eventually(async () => expect((await canvasBox()).width).toBe(1440));
    expect((await previewBox()).width).toBe(1440 - RAIL_PX);
    // The graph is above the preview.
    await open.editor.node('sepia').click();
    await open.editor.inspector.getByText('Sepia').first().waitFor();
    await open.page.keyboard.press('Escape');
    await eventually(async () => expect((await canvasBox()).width).toBeLessThan(1000));
  });

  test('a slider gives up the focus after a drag, so that the next key is a command of the canvas', async () => {
    await open.editor.node('sepia').click();
    const slider = open.editor.inspector.getByRole('slider').first();
    const box = await slider.boundingBox();
    if (!box) throw new Error('There is no slider.');
    await open.editor.drag({ x: box.x + box.width - 8, y: box.y + box.height / 2 }, { x: box.x + 30, y: box.y + box.height / 2 });
    await open.page.keyboard.press('m');
    await open.page.locator('.node-muted').waitFor();
    await open.page.keyboard.press('m');
    await open.page.locator('.node-muted').waitFor({ state: 'detached' });
    // A slider that keys have reached keeps its own keys.
    await slider.focus();
    const before = await slider.inputValue();
    await open.page.keyboard.press('ArrowRight');
    expect(await slider.inputValue()).not.toBe(before);
  });

  test('a key means what the panel under the pointer says', async () => {
    const play = open.page.getByRole('toolbar', { name: 'Transport' }).getByRole('button', { name: /^(Play|Pause)$/ });
    await open.editor.node('sepia').click();
    const before = await play.getAttribute('aria-label');
    await open.page.locator('.transport-time').hover();
    await open.page.keyboard.press('Space');
    await eventually(async () => expect(await play.getAttribute('aria-label')).not.toBe(before));
    await open.page.locator('.canvas').hover({ position: { x: 20, y: 20 } });
    await open.editor.inspector.getByRole('slider').first().focus();
    await open.page.keyboard.press('m');
    await open.page.locator('.node-muted').waitFor();
    await open.page.keyboard.press('m');
    await open.page.locator('.node-muted').waitFor({ state: 'detached' });
  });
});
