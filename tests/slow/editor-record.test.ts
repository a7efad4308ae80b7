import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { readSessionFile } from '../../export/runtime/sessions/recorded/read-session-file.ts';
import { useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';
import { ballPixels, PLACED_BALL } from '../support/placed-ball.ts';
import { loadSession, quantile, worldPoints } from '../unit/sessions-kit.ts';

const open = useOneEditor(PLACED_BALL, {});

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
  expect(await ballPixels(open.editor)).toBe(0);
  await choose('Record session');
  await later(3);
  await page.mouse.click(box.x + box.width * 0.5, box.y + box.height * 0.8);
  await later(6);
  await editor.press('Stop recording the session');
  const told = page.getByText(/^(Recorded “Recording 1”|The session could not|Nothing was recorded)/);
  await told.waitFor();
  expect(await told.textContent()).toBe('Recorded “Recording 1”. Choose it as the preview source to replay it.');
  expect(await ballPixels(open.editor)).toBeGreaterThan(50);

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
  await eventually(async () => expect(await ballPixels(open.editor)).toBeGreaterThan(50));
});
