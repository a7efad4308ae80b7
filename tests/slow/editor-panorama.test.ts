import { mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { chooseOption } from '../support/choose-option.ts';
import { encodeImage, type RgbaImage } from '../support/image.ts';
import { type GraphText, useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

const OUTPUT = join(import.meta.dirname, '../output/panorama');

/** The panorama behind a ball: where it is right, it covers the room by itself. */
const GRAPH: GraphText = {
  nodes: {
    'ball-aaaa': { type: 'objects/primitive', params: { shape: 'sphere', sizeM: [0.4, 0.4, 0.4], roughness: 0.05, metalness: 1 } },
    'place-aaaa': { type: 'objects/transform', params: { positionM: [0, 1.4, -0.6] } },
    'capture-aaaa': { type: 'source/panorama-capture', params: {} },
    'around-aaaa': { type: 'light/environment', params: { visible: true } },
    'scene-aaaa': { type: 'layer/scene' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: [
    'capture-aaaa.environment -> around-aaaa.environment',
    'ball-aaaa.objects -> place-aaaa.objects',
    'place-aaaa.objects -> scene-aaaa.objects',
    'around-aaaa.lights -> scene-aaaa.lights',
    'scene-aaaa.layer -> screen-aaaa.layer',
  ],
  places: {
    'ball-aaaa': [0, 0],
    'place-aaaa': [210, 0],
    'capture-aaaa': [0, 200],
    'around-aaaa': [210, 200],
    'scene-aaaa': [420, 0],
    'screen-aaaa': [630, 0],
  },
};

const open = useOneEditor(GRAPH, {}, async () => {
  await chooseOption(open.page.getByRole('combobox', { name: 'Preview source' }), 'room/studio');
  await open.editor.settled();
  await open.editor.node('capture').locator('.node-title').click();
});

async function keep(name: string, picture: RgbaImage): Promise<void> {
  await mkdir(OUTPUT, { recursive: true });
  await writeFile(join(OUTPUT, `${name}.png`), encodeImage(picture));
}

/** Mean difference of pixels, in bytes, left and right of the ball. */
function differenceBeside(a: RgbaImage, b: RgbaImage): number {
  let sum = 0;
  let count = 0;
  for (let y = 0; y < a.height; y++) {
    for (let x = 0; x < a.width; x++) {
      if (x > a.width * 0.2 && x < a.width * 0.8) continue;
      for (let c = 0; c < 3; c++) sum += Math.abs((a.data[(y * a.width + x) * 4 + c] ?? 0) - (b.data[(y * b.width + x) * 4 + c] ?? 0));
      count += 3;
    }
  }
  return sum / count;
}

test('one click takes the panorama of the emulated room; behind the objects it is where the room is', async () => {
  const { editor, page } = open;
  // The choice of a room changes the shape of the preview, and its image follows.
  const before = await editor.restingImage();
  await keep('before', before);
  await editor.inspector.getByRole('button', { name: 'Take panorama in the preview' }).click();
  await page.getByText(/The panorama of the room is made of \d+ photos/).waitFor();
  await eventually(async () => {
    const after = await editor.picture();
    await keep('after', after);
    // The ball reflects the room now.
    let changed = 0;
    for (let i = 0; i < after.data.length; i += 4) if (Math.abs((after.data[i] ?? 0) - (before.data[i] ?? 0)) > 40) changed++;
    expect(changed).toBeGreaterThan(500);
    expect(differenceBeside(before, after)).toBeLessThan(12);
  });
});
