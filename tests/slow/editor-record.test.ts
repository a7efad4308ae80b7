import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { readSessionFile } from '../../export/runtime/sessions/recorded/read-session-file.ts';
import { type GraphText, useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';
import { loadSession, quantile, worldPoints } from '../unit/sessions-kit.ts';

/** A magenta ball, which a tap places. */
const PLACED: GraphText = {
  nodes: {
    'ball-aaaa': { type: 'objects/primitive', params: { shape: 'sphere', color: [1, 0, 1, 1] } },
    'sun-aaaa': { type: 'light/directional' },
    'place-aaaa': { type: 'objects/place', params: { mode: 'once', reticle: false } },
    'video-aaaa': { type: 'source/camera-video' },
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
    'ball-aaaa': [0, 160],
    'sun-aaaa': [240, 320],
    'place-aaaa': [240, 160],
    'video-aaaa': [0, 0],
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

async function choose(item: string): Promise<void> {
  await open.page.getByRole('button', { name: 'Preview options' }).click();
  await open.page.getByRole('menu', { name: 'Preview options' }).getByText(item).click();
}

test('what a visitor of an emulated room does is recorded with the room, and a replay does it again', async () => {
  const { page, editor, project } = open;
  const source = page.getByRole('combobox', { name: 'Preview source' });
  await source.selectOption('room/studio');
  await editor.settled();
  const box = await page.locator('.stage-frame').boundingBox();
  if (!box) throw new Error('There is no preview.');
  const later = async (frames: number) => {
    const from = await editor.frame();
    await eventually(async () => expect(await editor.frame()).toBeGreaterThan(from + frames));
  };
  expect(await magentaPixels()).toBe(0);
  await choose('Record session');
  await later(3);
  await page.mouse.click(box.x + box.width * 0.5, box.y + box.height * 0.8);
  await later(6);
  await editor.press('Stop recording the session');
  const told = page.getByText(/^(Recorded “Recording 1”|The session could not|Nothing was recorded)/);
  await told.waitFor();
  expect(await told.textContent()).toBe('Recorded “Recording 1”. Choose it as the preview source to replay it.');
  expect(await magentaPixels()).toBeGreaterThan(50);

  const folder = join(project, 'sessions/recording-1');
  const { output: file, diagnostics } = readSessionFile(JSON.parse(await readFile(join(folder, 'session.json'), 'utf8')));
  expect(diagnostics).toEqual([]);
  const pointers = file?.frames.flatMap(({ input }) => input?.pointers ?? []).filter(({ by }) => by === 'screen');
  expect([pointers?.[0]?.phase, pointers?.at(-1)?.phase, pointers?.filter(({ tapped }) => tapped).length]).toEqual(['start', 'end', 1]);
  expect(file?.surfaces?.map(({ label }) => label)).toContain('floor');
  // Depth, camera and pose agree: what is low in the images is the floor.
  const points = worldPoints(await loadSession(folder, 8), 8);
  const floor = points.filter(({ point, normal }) => normal[1] > 0.98 && point[1] < 0.05).map(({ point }) => Math.abs(point[1]));
  expect(floor.length).toBeGreaterThan(50);
  expect(
    quantile(
      [...floor].sort((a, b) => a - b),
      0.9,
    ),
  ).toBeLessThan(0.016);

  await source.selectOption('project/recording-1');
  await editor.settled();
  expect(await page.locator('.stage-notice').count()).toBe(0);
  await eventually(async () => expect(await magentaPixels()).toBeGreaterThan(50));
});
