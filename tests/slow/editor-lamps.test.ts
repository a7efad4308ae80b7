import { readFileSync } from 'node:fs';
import { mkdir } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { chooseOption } from '../support/choose-option.ts';
import { type GraphText, saveGraphs, useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

const ROOM = readFileSync(join(import.meta.dirname, '../../nodes/light/from-panorama/example/assets/room.hdr'));
const OUTPUT = join(import.meta.dirname, '../output/lamps');

const GRAPH: GraphText = {
  nodes: {
    'box-aaaa': { type: 'objects/primitive' },
    'room-aaaa': { type: 'source/panorama', params: { file: 'room' } },
    'lamps-aaaa': { type: 'light/from-panorama', params: { lamps: 2, visible: true } },
    'scene-aaaa': { type: 'layer/scene' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: [
    'room-aaaa.environment -> lamps-aaaa.environment',
    'box-aaaa.objects -> scene-aaaa.objects',
    'lamps-aaaa.lights -> scene-aaaa.lights',
    'scene-aaaa.layer -> screen-aaaa.layer',
  ],
  places: { 'box-aaaa': [0, 0], 'room-aaaa': [0, 200], 'lamps-aaaa': [210, 200], 'scene-aaaa': [420, 0], 'screen-aaaa': [630, 0] },
  assets: { room: { path: 'assets/room.hdr', kind: 'environment' } },
  assetFiles: { 'room.hdr': ROOM },
};

const open = useOneEditor(GRAPH, { size: { width: 1440, height: 1400 } }, async () => {
  await mkdir(OUTPUT, { recursive: true });
  await open.editor.settled();
  await open.editor.node('lamps').locator('.node-title').click();
});

const section = () => open.editor.inspector.getByRole('region', { name: 'Lamps' });
const mark = (lamp: number) => section().getByRole('button', { name: `Lamp ${lamp}`, exact: true });
const keep = (name: string) => section().screenshot({ path: join(OUTPUT, `${name}.png`) });

async function savedParams(): Promise<Readonly<Record<string, unknown>>> {
  return (await saveGraphs(open)).main?.nodes['lamps-aaaa']?.params ?? {};
}

/** Where a mark stands, in parts of the panorama. */
async function place(lamp: number): Promise<{ x: number; y: number }> {
  const [box, picture] = [await mark(lamp).boundingBox(), await section().locator('.lamps-image').boundingBox()];
  if (!box || !picture) throw new Error('The mark is shown.');
  return { x: (box.x + box.width / 2 - picture.x) / picture.width, y: (box.y + box.height / 2 - picture.y) / picture.height };
}

test('the inspector shows the panorama with the window and the lamp at their centers', async () => {
  await mark(2).waitFor();
  await keep('found');
  // The window in the left wall, and the lamp on the ceiling to the right (`tools/examples/lit-room.ts`).
  const theta = (x: number, z: number) => Math.atan2(x, -z) / (2 * Math.PI) + 0.5;
  expect((await place(1)).x).toBeCloseTo(theta(-2, -0.2), 1);
  expect((await place(2)).x).toBeCloseTo(theta(1.3, -1.2), 1);
  expect((await place(2)).y).toBeCloseTo(0.5 - Math.atan2(1.4, Math.hypot(1.3, 1.2)) / Math.PI, 1);
  expect(await section().locator('polygon').count()).toBe(2);
});

test('the preview shows the panorama behind the box', async () => {
  await eventually(async () => {
    const { data, width, height } = await open.editor.picture();
    // Its walls and its ceiling are gray and brighter than nothing.
    for (const x of [0.1, 0.9]) {
      const at = (Math.floor(height * 0.3) * width + Math.floor(width * x)) * 4;
      expect(Math.min(...data.slice(at, at + 3))).toBeGreaterThan(30);
    }
  });
});

test('a lamp that is dragged stays where it is dropped, for the project too; undo lets it go', async () => {
  const from = await mark(2).boundingBox();
  if (!from) throw new Error('The mark is shown.');
  const at = { x: from.x + from.width / 2, y: from.y + from.height / 2 };
  const before = await place(2);
  await open.page.mouse.move(at.x, at.y);
  await open.page.mouse.down();
  await open.page.mouse.move(at.x - 20, at.y + 5, { steps: 3 });
  await open.page.mouse.move(at.x - 40, at.y + 10, { steps: 3 });
  await open.page.mouse.up();
  await eventually(async () => expect((await place(2)).x).toBeLessThan(before.x - 0.05));
  await keep('dragged');
  expect(await savedParams()).toMatchObject({ lamp2Pinned: true, lamp2AzimuthRad: expect.any(Number) });
  await open.page.locator('.canvas').focus();
  await open.page.keyboard.press('Control+z');
  await eventually(async () => expect((await place(2)).x).toBeCloseTo(before.x, 3));
  expect(await savedParams()).toEqual({ lamps: 2, visible: true });
});

test('the steps of “Brightest areas” and the histogram with the threshold can be looked at', async () => {
  await open.editor.inspector.getByRole('combobox', { name: 'Method', exact: true }).click();
  await open.page.getByRole('option', { name: 'Brightest areas' }).click();
  const steps = section().getByRole('combobox', { name: 'Step of the search' });
  await steps.waitFor();
  const names = ['Panorama', ...[1, 2].flatMap((n) => [`${n}: Gray`, `${n}: Threshold`, `${n}: Median`])];
  await steps.click();
  expect(await section().getByRole('option').allTextContents()).toEqual(names);
  await steps.press('Escape');
  for (const label of ['1: Gray', '1: Threshold', '2: Threshold', '2: Median']) {
    await chooseOption(steps, names.indexOf(label));
    await section().getByRole('img', { name: 'Histogram' }).waitFor();
    await keep(label.replace(': ', '-').toLowerCase());
  }
  // The brightest of what the first iteration left: the window.
  expect(await section().locator('figcaption').textContent()).toMatch(
    /^Brightest 106, mean 17\.3, ratio 6\.14\. Above 93 % \(level 99\): 1\.63 %/,
  );
});
