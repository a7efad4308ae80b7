import { expect, test } from '@jest/globals';
import { centerOf, type Point } from '../../tools/lib/center-of.ts';
import { type GraphText, useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

const GRAPH: GraphText = {
  nodes: { 'video-aaaa': { type: 'source/camera-video' }, 'screen-aaaa': { type: 'output/screen' } },
  wires: ['video-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'screen-aaaa': [300, 0] },
};

const open = useOneEditor(GRAPH, {}, async () => {
  await open.editor.hold();
});

interface View {
  readonly at: Point;
  readonly zoom: number;
}

/** Place of a node in the window, and the zoom of the canvas. */
async function view(): Promise<View> {
  const zoom = await open.page.locator('.react-flow__viewport').evaluate((element) => new DOMMatrix(getComputedStyle(element).transform).a);
  return { at: await centerOf(open.editor.node('video')), zoom };
}

interface Step {
  readonly deltaX?: number;
  readonly deltaY: number;
  readonly deltaMode?: number;
  readonly ctrlKey?: boolean;
}

/** Sends wheel events at a point without a pause, as a device does. All belong to one gesture. */
async function scroll(at: Point, steps: readonly Step[]): Promise<void> {
  await open.page.evaluate(
    ({ x, y, all }) => {
      const target = document.elementFromPoint(x, y);
      for (const step of all) {
        target?.dispatchEvent(new WheelEvent('wheel', { bubbles: true, cancelable: true, clientX: x, clientY: y, ...step }));
      }
    },
    { ...at, all: steps },
  );
}

/** Waits until the next event begins another gesture. */
const pause = () => open.page.waitForTimeout(400);

async function expectView(expected: View): Promise<void> {
  await eventually(async () => {
    const { at, zoom } = await view();
    expect(zoom).toBeCloseTo(expected.zoom, 3);
    expect(Math.hypot(at.x - expected.at.x, at.y - expected.at.y)).toBeLessThan(1);
  });
}

/** The view after a zoom about a point by a factor. */
function zoomed({ at, zoom }: View, about: Point, factor: number): View {
  return { zoom: zoom * factor, at: { x: about.x + (at.x - about.x) * factor, y: about.y + (at.y - about.y) * factor } };
}

test('the first notch of a wheel zooms to the pointer, the first pixels of a trackpad pan by as much as the fingers move', async () => {
  const about = await open.editor.emptyPlace();
  const before = await view();
  await scroll(about, [{ deltaY: 100 }]);
  const smaller = zoomed(before, about, 2 ** -0.2);
  await expectView(smaller);
  await pause();
  await scroll(about, [{ deltaX: 3, deltaY: 2 }, { deltaX: 10, deltaY: 8 }, { deltaY: 60 }, { deltaX: 2, deltaY: 5 }]);
  const panned = { zoom: smaller.zoom, at: { x: smaller.at.x - 15, y: smaller.at.y - 75 } };
  await expectView(panned);
  await pause();
  await scroll(about, [{ deltaY: -100 }]);
  const larger = zoomed(panned, about, 2 ** 0.2);
  await expectView(larger);
  // Firefox reports lines.
  await pause();
  await scroll(about, [{ deltaY: 3, deltaMode: 1 }]);
  await expectView(zoomed(larger, about, 2 ** -0.15));
});

test('a pinch and Ctrl with the wheel zoom to the pointer, up to the limits, and not the page', async () => {
  const { page } = open;
  const about = await open.editor.emptyPlace();
  const before = await view();
  await pause();
  await scroll(about, [
    { deltaY: -2.5, ctrlKey: true },
    { deltaY: -2.5, ctrlKey: true },
  ]);
  const pinched = zoomed(before, about, 2 ** 0.1);
  await expectView(pinched);
  await page.mouse.move(about.x, about.y);
  await page.keyboard.down('Control');
  await page.mouse.wheel(0, 100);
  await page.keyboard.up('Control');
  const notched = zoomed(pinched, about, 2 ** -0.2);
  await expectView(notched);
  expect(await page.evaluate(() => window.devicePixelRatio)).toBe(1);
  await scroll(about, Array(20).fill({ deltaY: -400, ctrlKey: true }));
  await expectView(zoomed(notched, about, 2.5 / notched.zoom));
});

test('with the preference to pan, a wheel pans and Ctrl still zooms', async () => {
  const { page } = open;
  await page.keyboard.press('f');
  const about = await open.editor.emptyPlace();
  for (const words of ['Scrolling zooms.', 'Scrolling pans. Hold Ctrl to zoom.']) {
    await page.keyboard.press('Control+k');
    await page.getByRole('combobox', { name: 'Command' }).fill('wheel');
    await page.keyboard.press('Enter');
    await page.getByText(words, { exact: true }).waitFor();
  }
  await pause();
  const before = await view();
  await scroll(about, [{ deltaY: 100 }]);
  const panned = { zoom: before.zoom, at: { x: before.at.x, y: before.at.y - 100 } };
  await expectView(panned);
  await scroll(about, [{ deltaY: 100, ctrlKey: true }]);
  await expectView(zoomed(panned, about, 2 ** -0.2));
});
