import { expect, test } from '@jest/globals';
import { createManualClock } from '../../export/runtime/clock.ts';
import { createRenderResolution } from './render-resolution.ts';

const PANEL = { innerWidth: 600, innerHeight: 400, devicePixelRatio: 1 };

/** Draws frames that take `costS` at full size, in proportion to their pixels, as far as the display of 60 Hz lets them. */
function draw(of: ReturnType<typeof make>, frames: number, costS: number): void {
  const fullPx = 1620 * 1080;
  for (let i = 0; i < frames; i++) {
    const [width, height] = of.resolution.sizePx();
    of.resolution.begin();
    of.resolution.end();
    of.clock.advance(Math.max(1 / 60, (costS * width * height) / fullPx));
  }
}

function make(surface = { ...PANEL }) {
  const clock = createManualClock();
  const resolution = createRenderResolution(surface, clock, () => {});
  return { clock, resolution, surface };
}

const after = async (of: ReturnType<typeof make>, delayS: number) => {
  of.clock.advance(delayS);
  await Promise.resolve();
  await Promise.resolve();
};

test('renders with the chosen short side in the shape of the panel, whatever its size', () => {
  const { resolution, surface } = make();
  expect(resolution.sizePx()).toEqual([600, 400]);
  resolution.setSize('auto');
  expect(resolution.sizePx()).toEqual([1620, 1080]);
  Object.assign(surface, { innerWidth: 200, innerHeight: 400 });
  resolution.setSize(720);
  expect(resolution.sizePx()).toEqual([720, 1440]);
  // The CPU would draw 1080p far too slowly.
  resolution.setSize('auto');
  resolution.setSoftware(true);
  expect(resolution.sizePx()).toEqual([200, 400]);
});

test('a drag that would be slow lowers the resolution to 30 frames per second, and the full one returns after it', async () => {
  const made = make();
  const { resolution } = made;
  resolution.setSize(1080);
  draw(made, 10, 0.1);
  expect(resolution.sizePx()).toEqual([1620, 1080]);
  resolution.setDragging('editor', true);
  draw(made, 10, 0.1);
  const [width] = resolution.sizePx();
  expect((0.1 * width * width) / 1620 ** 2).toBeLessThan(1 / 30);
  resolution.setDragging('editor', false);
  await after(made, 0.2);
  expect(resolution.sizePx()).toEqual([1620, 1080]);
  // The next drag begins with it.
  resolution.setDragging('preview', true);
  expect(resolution.sizePx()[0]).toBe(width);
});

test('a drag whose frames take long for another reason than their pixels keeps its resolution', () => {
  const made = make();
  made.resolution.setSize(1080);
  made.resolution.setDragging('editor', true);
  for (let i = 0; i < 40; i++) {
    made.resolution.begin();
    made.resolution.end();
    made.clock.advance(0.1);
  }
  expect(made.resolution.sizePx()).toEqual([1620, 1080]);
});

test('a fast drag, a video and an image that depends on earlier ones keep the full resolution', () => {
  const made = make();
  const { resolution } = made;
  resolution.setSize(1080);
  resolution.setDragging('editor', true);
  draw(made, 20, 0.02);
  expect(resolution.sizePx()).toEqual([1620, 1080]);
  draw(made, 20, 0.2);
  expect(resolution.sizePx()[0]).toBeLessThan(1620);
  resolution.setFixed(true);
  expect(resolution.sizePx()).toEqual([1620, 1080]);
  resolution.setFixed(false);
  resolution.follow({ resources: [{ kind: 'target', lifetime: 'persistent' }] } as never);
  expect(resolution.sizePx()).toEqual([1620, 1080]);
});
