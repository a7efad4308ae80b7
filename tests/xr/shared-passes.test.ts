import { readdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import type { Page } from 'playwright-core';
import { useBrowser } from '../support/browser.ts';
import { encodeImage, pixelAt, type RgbaImage } from '../support/image.ts';
import { type ServedExport, serveProjectText } from '../support/project-page.ts';
import { openXrPage, readCapture } from './xr-page.ts';

const chromium = useBrowser();
const livingRoom = await readCapture('living_room');

/** Stripes of 12 pixels, which the blur reads beside each pixel; nothing of the room. */
const STRIPES = `/*{ "ISFVSN": "2", "INPUTS": [] }*/
void main() {
  gl_FragColor = mod(gl_FragCoord.x, 24.0) < 12.0 ? vec4(1.0, 0.5, 0.0, 1.0) : vec4(0.0, 0.0, 1.0, 1.0);
}`;

let shared: ServedExport;
let unshared: ServedExport;

beforeAll(async () => {
  const serve = () =>
    serveProjectText(
      {
        title: 'Blurred stripes over the room',
        nodes: {
          'stripes-a1b2': 'generator/stripes',
          'blur-a1b2': ['filter/gaussian-blur', { radius: 3 }],
          'camera-a1b2': 'source/camera-video',
          'mix-a1b2': ['operator/over', { opacity: 0.5 }],
          'screen-a1b2': 'output/screen',
        },
        wires: [
          'stripes-a1b2.layer -> blur-a1b2.inputImage',
          'blur-a1b2.layer -> mix-a1b2.top',
          'camera-a1b2.layer -> mix-a1b2.bottom',
          'mix-a1b2.layer -> screen-a1b2.layer',
        ],
      },
      { 'shaders/stripes.fs': new TextEncoder().encode(STRIPES) },
    );
  [shared, unshared] = await Promise.all([serve(), serve()]);
  expect(await unshare(unshared.folder)).toBeGreaterThan(0);
});
afterAll(() => Promise.all([shared.close(), unshared.close()]));

/** Removes the marks of shared passes from an exported page. Returns their number. */
async function unshare(folder: string): Promise<number> {
  let count = 0;
  for (const name of await readdir(folder)) {
    if (!/\.(js|html|json)$/.test(name)) continue;
    const text = await readFile(join(folder, name), 'utf8');
    const changed = text.replace(/"?sameForViews"?:(true|!0),?/g, () => {
      count++;
      return '';
    });
    if (changed !== text) await writeFile(join(folder, name), changed);
  }
  return count;
}

/** Page code: notes the framebuffer of each draw. */
const WATCH_DRAWS = `{
  const { prototype } = WebGL2RenderingContext;
  const { drawArrays } = prototype;
  globalThis.targets = [];
  prototype.drawArrays = function (...args) {
    globalThis.targets.push(this.getParameter(this.DRAW_FRAMEBUFFER_BINDING));
    return drawArrays.apply(this, args);
  };
}`;

/** Draws of the next frame, by target: the session's own has a draw per view. */
function drawsOfFrame(page: Page): Promise<number[]> {
  return page.evaluate(async () => {
    const { targets } = globalThis as unknown as { readonly targets: unknown[] };
    targets.length = 0;
    await scrimEmulator?.current?.stepFrame();
    const counts = new Map<unknown, number>();
    for (const target of targets) counts.set(target, (counts.get(target) ?? 0) + 1);
    return [...counts.values()];
  });
}

interface Seen {
  readonly draws: readonly number[];
  readonly layer: RgbaImage;
}

async function see({ url }: ServedExport): Promise<Seen> {
  const options = { room: livingRoom, device: 'headset', extra: ['camera-access'] } as const;
  const xr = await openXrPage(chromium.browser, url, options, { width: 480, height: 240 }, WATCH_DRAWS);
  await xr.enter();
  const draws = await drawsOfFrame(xr.page);
  const layer = await xr.readLayer();
  expect(xr.errors).toEqual([]);
  await xr.close();
  return { draws, layer };
}

test('passes that look the same to both eyes are drawn once per frame, and both eyes see what they would see without that', async () => {
  const once = await see(shared);
  const each = await see(unshared);
  // The stripes and their blur along x have a target of their own each; the last pass blurs along y and mixes on the screen, for each eye.
  expect(once.draws).toEqual([1, 1, 2]);
  expect(each.draws).toEqual([2, 2, 2]);
  expect(once.layer).toEqual(each.layer);
  const half = once.layer.width / 2;
  const rednessAt = (x: number): number => {
    const [red, , blue] = pixelAt(once.layer, x, 120);
    return red - blue;
  };
  for (const eyeX of [0, half])
    for (let x = 6; x < half - 12; x += 24) expect(rednessAt(eyeX + x)).toBeGreaterThan(rednessAt(eyeX + x + 12) + 40);
});

test('effects of an image file have the size of the file and are drawn once for both eyes, which then fit it to their views', async () => {
  const image = { width: 64, height: 32, data: Uint8Array.from({ length: 64 * 32 * 4 }, (_, i) => (i % 4 === 3 ? 255 : (i * 37) % 256)) };
  const served = await serveProjectText(
    {
      title: 'A blurred file over the room',
      nodes: {
        'file-a1b2': ['source/image-file', { file: 'photo' }],
        'blur-a1b2': ['filter/gaussian-blur', { radius: { expression: '3 + frame % 2' } }],
        'camera-a1b2': 'source/camera-video',
        'sepia-a1b2': 'filter/sepia',
        'mix-a1b2': ['operator/over', { opacity: 0.5 }],
        'screen-a1b2': 'output/screen',
      },
      wires: [
        'file-a1b2.layer -> blur-a1b2.inputImage',
        'blur-a1b2.layer -> mix-a1b2.top',
        'camera-a1b2.layer -> sepia-a1b2.inputImage',
        'sepia-a1b2.layer -> mix-a1b2.bottom',
        'mix-a1b2.layer -> screen-a1b2.layer',
      ],
      assets: { photo: { path: 'assets/photo.png', kind: 'image' } },
    },
    { 'assets/photo.png': encodeImage(image) },
  );
  const options = { room: livingRoom, device: 'headset', extra: ['camera-access'] } as const;
  const xr = await openXrPage(chromium.browser, served.url, options, { width: 480, height: 240 }, WATCH_DRAWS);
  await xr.enter();
  const draws = await drawsOfFrame(xr.page);
  expect(xr.errors).toEqual([]);
  await xr.close();
  await served.close();
  // Across and along. Each eye has a camera image of its own: its filter and the mix are one pass on the screen.
  expect(draws).toEqual([1, 1, 2]);
});
