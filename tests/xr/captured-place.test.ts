import { resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { useBrowser } from '../support/browser.ts';
import { pixelAt } from '../support/image.ts';
import { type ServedExport, serveProject } from '../support/project-page.ts';
import { eyesOf } from './eyes.ts';
import { openXrPage } from './xr-page.ts';

/** Layer of both eyes, px. */
const [WIDTH, HEIGHT] = [1280, 640];
/** The captured ball of the example, in the space `local-floor`. Meters. */
const BALL = { center: [0, 1, -1.2], radius: 0.2 } as const;
/** Edges of photographs and of the mesh differ by this much. */
const EDGE_PX = 3;

const chromium = useBrowser();
let served: ServedExport;
beforeAll(async () => {
  served = await serveProject(resolve('nodes/source/capture-mesh/example'));
});
afterAll(() => served.close());

test('a captured ball stands at its place for both eyes of a headset, and hides the block behind it', async () => {
  const xr = await openXrPage(chromium.browser, served.url, { device: 'headset' }, { width: WIDTH, height: HEIGHT });
  await xr.setPose({ position: [0, BALL.center[1], 0.1] });
  await xr.enter();
  await xr.page.waitForLoadState('networkidle');
  await xr.step(3);
  const eyes = await eyesOf(xr, WIDTH);
  const layer = await xr.readLayer();
  expect(eyes).toHaveLength(2);
  for (const { position, clipFromView, left, width } of eyes) {
    const [p0 = 1, , , , , p5 = 1, , , p8 = 0, p9 = 0] = clipFromView;
    const aheadM = position[2] - BALL.center[2];
    const centerX = left + (width / 2) * (1 + (p0 * (BALL.center[0] - position[0])) / aheadM - p8);
    const centerY = (HEIGHT / 2) * (1 - (p5 * (BALL.center[1] - position[1])) / aheadM + p9);
    // The silhouette of a ball is that of its tangents.
    const radiusPx = ((width / 2) * p0 * BALL.radius) / Math.sqrt(aheadM ** 2 - BALL.radius ** 2);
    const seen = { ball: 0, empty: 0, block: 0, blockOnBall: 0 };
    for (let y = 0; y < HEIGHT; y++) {
      for (let x = left; x < left + width; x++) {
        const [red = 0, , blue = 0, alpha] = pixelAt(layer, x, y);
        const away = Math.hypot(x + 0.5 - centerX, y + 0.5 - centerY);
        const isBlock = blue > red + 40;
        if (isBlock) seen.block++;
        if (isBlock && away < radiusPx - EDGE_PX) seen.blockOnBall++;
        if (away < radiusPx - EDGE_PX && alpha === 255) seen.ball++;
        // Above the board there is nothing but the ball and, on its right, the block.
        if (away > radiusPx + EDGE_PX && away < radiusPx + 20 && y < centerY && x < centerX && alpha === 0) seen.empty++;
      }
    }
    expect(seen.ball / (Math.PI * (radiusPx - EDGE_PX) ** 2)).toBeGreaterThan(0.99);
    expect(seen.empty / ((Math.PI / 4) * ((radiusPx + 20) ** 2 - (radiusPx + EDGE_PX) ** 2))).toBeGreaterThan(0.98);
    expect(seen.block).toBeGreaterThan(500);
    expect(seen.blockOnBall).toBe(0);
  }
  expect(xr.errors).toEqual([]);
  await xr.close();
});
