import { expect, test } from '@jest/globals';
import { type GraphText, useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

/** A magenta ball in the sun, which a tap places. */
const PLACED: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'ball-aaaa': { type: 'objects/primitive', params: { shape: 'sphere', color: [1, 0, 1, 1] } },
    'sun-aaaa': { type: 'light/directional' },
    'place-aaaa': { type: 'objects/place', params: { mode: 'once' } },
    'scene-aaaa': { type: 'layer/scene' },
    'over-aaaa': { type: 'operator/over' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: [
    'ball-aaaa.objects -> place-aaaa.objects',
    'place-aaaa.objects -> scene-aaaa.objects',
    'sun-aaaa.lights -> scene-aaaa.lights',
    'scene-aaaa.layer -> over-aaaa.top',
    'video-aaaa.layer -> over-aaaa.bottom',
    'over-aaaa.layer -> screen-aaaa.layer',
  ],
  places: {
    'video-aaaa': [0, 0],
    'ball-aaaa': [0, 160],
    'sun-aaaa': [240, 320],
    'place-aaaa': [240, 160],
    'scene-aaaa': [480, 160],
    'over-aaaa': [720, 0],
    'screen-aaaa': [960, 0],
  },
};

const open = useOneEditor(PLACED, {});

async function magentaPixels(): Promise<number> {
  const { data } = await open.editor.picture();
  let count = 0;
  for (let i = 0; i < data.length; i += 4) {
    const [red = 0, green = 0, blue = 0] = data.subarray(i, i + 3);
    if (red > 120 && blue > 120 && green < Math.min(red, blue) / 3) count++;
  }
  return count;
}

test('what a tap places in the preview stays while the recorded room repeats', async () => {
  const box = await open.page.locator('.stage-frame').boundingBox();
  if (!box) throw new Error('There is no preview.');
  await open.editor.settled();
  expect(await magentaPixels()).toBe(0);
  await open.page.mouse.move(box.x + box.width * 0.4, box.y + box.height * 0.85);
  await open.page.mouse.down();
  await eventually(async () => expect(await open.editor.frame()).toBeGreaterThan(1));
  await open.page.mouse.up();
  await eventually(async () => expect(await magentaPixels()).toBeGreaterThan(50));
  const placedAt = await open.editor.frame();
  await eventually(async () => expect(await open.editor.frame()).toBeGreaterThan(placedAt + 100));
  expect(await magentaPixels()).toBeGreaterThan(50);
});
