import { afterEach, describe, expect, test } from '@jest/globals';
import { useBrowser } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import { serveProjectText } from '../support/project-page.ts';
import { openXrPage } from './xr-page.ts';

const chromium = useBrowser();

const closing: { close(): Promise<void> }[] = [];
afterEach(async () => {
  for (const each of closing.splice(0).reverse()) await each.close();
});

const WIDTH_PX = 8;

/** An upright line at x and z, on the height of the eyes. */
function lineAt(name: string, x: number, z: number) {
  const ends = { [`${name}-a`]: [x, 0.5, z], [`${name}-b`]: [x, 2.5, z] };
  return {
    nodes: {
      ...Object.fromEntries(Object.entries(ends).map(([id, positionM]) => [id, ['pose/from-values', { positionM }] as const])),
      [`${name}-line`]: ['objects/line', { widthIn: 'pixels', widthPx: WIDTH_PX }] as const,
    },
    wires: [`${name}-a.pose -> ${name}-line.from`, `${name}-b.pose -> ${name}-line.to`, `${name}-line.objects -> scene-x1.objects`],
  };
}

/** Widths of what is drawn in a row of an area, from left to right, in pixels with their shares. */
function widthsIn(picture: RgbaImage, fromX: number, toX: number): number[] {
  const widths: number[] = [];
  let width = 0;
  for (let x = fromX; x <= toX; x++) {
    const covered = x < toX ? (pixelAt(picture, x, Math.floor(picture.height / 2))[3] ?? 0) / 255 : 0;
    if (covered === 0 && width > 0) widths.push(width);
    width = covered === 0 ? 0 : width + covered;
  }
  return widths;
}

describe('a line with a width in pixels', () => {
  test.each([1, 2] as const)('is as wide at 0.7 m as at 20 m, and hidden by what stands before it: %d views', async (views) => {
    const [near, far, hidden] = [lineAt('near-x1', -0.2, -0.7), lineAt('far-x1', 3, -20), lineAt('hidden-x1', 0, -5)];
    const served = await serveProjectText(
      {
        nodes: {
          ...near.nodes,
          ...far.nodes,
          ...hidden.nodes,
          // Before the third line alone.
          'wall-x1': ['objects/primitive', { shape: 'box', sizeM: [0.6, 3, 0.1] }],
          'stand-x1': ['objects/transform', { positionM: [0, 1.5, -3] }],
          'phantom-x1': 'objects/phantom',
          'scene-x1': 'layer/scene',
          'screen-x1': 'output/screen',
        },
        wires: [
          ...near.wires,
          ...far.wires,
          ...hidden.wires,
          'wall-x1.objects -> stand-x1.objects',
          'stand-x1.objects -> phantom-x1.objects',
          'phantom-x1.objects -> scene-x1.objects',
          'scene-x1.layer -> screen-x1.layer',
        ],
      },
      {},
    );
    const xr = await openXrPage(chromium.browser, served.url, { device: 'headset', views }, { width: 400 * views, height: 400 });
    closing.push(served, xr);
    await xr.enter();
    await xr.setPose({ position: [0, 1.5, 0] });
    await xr.step(3);
    const layer = await xr.readLayer();
    for (let eye = 0; eye < views; eye++) {
      const part = layer.width / views;
      const widths = widthsIn(layer, eye * part, (eye + 1) * part);
      expect(widths).toHaveLength(2);
      for (const width of widths) expect(Math.abs(width - WIDTH_PX)).toBeLessThan(0.6);
    }
    expect(xr.errors).toEqual([]);
  });
});
