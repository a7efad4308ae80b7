import { mkdirSync, writeFileSync } from 'node:fs';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { useBrowser } from '../support/browser.ts';
import { encodeImage, pixelAt, type RgbaImage } from '../support/image.ts';
import type { ProjectText } from '../support/project-kit.ts';
import { type ServedExport, serveProjectText } from '../support/project-page.ts';
import { openXrPage, readCapture } from '../xr/xr-page.ts';

const chromium = useBrowser();
const livingRoom = await readCapture('living_room');

/** A ball of glass a meter before the eyes, before a red box, over the camera image, hidden by the room. */
const PROJECT: ProjectText = {
  title: 'Glass on a headset',
  nodes: {
    'video-a1': 'source/camera-video',
    'ball-a1': ['objects/primitive', { shape: 'sphere', sizeM: [0.4, 0.4, 0.4] }],
    'place-a1': ['objects/transform', { positionM: [-1, 1.5, 0] }],
    'box-a1': ['objects/primitive', { shape: 'box', sizeM: [0.2, 0.2, 0.2], color: [1, 0, 0, 1] }],
    'back-a1': ['objects/transform', { positionM: [-1.8, 1.5, 0] }],
    'glass-a1': ['technique/glass', { thicknessM: 0.4 }],
    'clear-a1': 'objects/apply-technique',
    'sun-b2': ['light/directional', { castShadow: false }],
    'scene-c3': ['layer/scene', { shadows: false }],
    'depth-c3': 'world/depth',
    'hide-c3': 'layer/depth-occlusion',
    'over-c3': 'operator/over',
    'screen-d4': 'output/screen',
  },
  wires: [
    'ball-a1.objects -> place-a1.objects',
    'place-a1.objects -> clear-a1.objects',
    'glass-a1.technique -> clear-a1.technique',
    'video-a1.layer -> glass-a1.behind',
    'box-a1.objects -> back-a1.objects',
    'clear-a1.objects -> scene-c3.objects',
    'back-a1.objects -> scene-c3.objects',
    'sun-b2.lights -> scene-c3.lights',
    'scene-c3.layer -> hide-c3.layer',
    'depth-c3.depth -> hide-c3.depth',
    'hide-c3.layer -> over-c3.top',
    'video-a1.layer -> over-c3.bottom',
    'over-c3.layer -> screen-d4.layer',
  ],
};

let served: ServedExport;
beforeAll(async () => {
  served = await serveProjectText(PROJECT, {});
});
afterAll(() => served.close());

/** Red pixels in a part of a picture. */
function reds(image: RgbaImage, fromX: number, toX: number): number {
  let count = 0;
  for (let y = 0; y < image.height; y++) {
    for (let x = fromX; x < toX; x++) {
      const [r, g, b, a] = pixelAt(image, x, y);
      if (a > 100 && r > g + 50 && r > b + 50) count++;
    }
  }
  return count;
}

test('both eyes of a headset see a box through a ball of glass before it', async () => {
  const xr = await openXrPage(
    chromium.browser,
    served.url,
    { room: livingRoom, device: 'headset', extra: ['camera-access'] },
    { width: 640, height: 480 },
  );
  await xr.enter();
  await xr.setPose({ position: [0, 1.5, 0], quaternion: [0, Math.SQRT1_2, 0, Math.SQRT1_2] });
  await xr.step(3);
  const layer = await xr.readLayer();
  const seen = await xr.readComposite();
  mkdirSync('tests/output/glass', { recursive: true });
  writeFileSync('tests/output/glass/headset-layer.png', encodeImage(layer));
  writeFileSync('tests/output/glass/headset.png', encodeImage(seen));
  const half = layer.width / 2;
  const [left, right] = [reds(layer, 0, half), reds(layer, half, layer.width)];
  expect(left).toBeGreaterThan(300);
  expect(Math.abs(right - left)).toBeLessThan(left / 4);
  expect(xr.errors).toEqual([]);
  await xr.close();
});
