import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { encode } from 'fast-png';
import { decode as decodeJpeg } from 'jpeg-js';
import { readSessionFile } from '../../export/runtime/sessions/recorded/read-session-file.ts';
import type { SessionFile } from '../../export/runtime/sessions/session-format.ts';
import { chooseOption } from '../support/choose-option.ts';
import { useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';
import { ballPixels, PLACED_BALL } from '../support/placed-ball.ts';
import { loadSession, quantile, worldPoints } from '../unit/sessions-kit.ts';

const open = useOneEditor(PLACED_BALL, { size: { width: 1024, height: 768 } });

const GRAY = encode({ width: 320, height: 240, channels: 3, data: new Uint8Array(320 * 240 * 3).fill(120) });

async function choose(item: string): Promise<void> {
  await open.page.getByRole('button', { name: 'Preview options' }).click();
  await open.page.getByRole('menu', { name: 'Preview options' }).getByText(item).click();
}

interface Place {
  /** Of the click, as shares of the preview. */
  readonly click: readonly [x: number, y: number];
  /** After the click, while the recording goes on. */
  readonly afterwards?: () => Promise<void>;
}

let recordings = 0;

/** Records a tap in the source that is chosen, and replays it. Returns the session's file and its folder. */
async function recordTap({ click: [x, y], afterwards }: Place) {
  const { page, editor, project } = open;
  const number = ++recordings;
  const box = await page.locator('.stage-frame').boundingBox();
  if (!box) throw new Error('There is no preview.');
  const later = async (frames: number) => {
    const from = await editor.frame();
    await eventually(async () => expect(await editor.frame()).toBeGreaterThan(from + frames));
  };
  expect(await ballPixels(editor)).toBe(0);
  await choose('Record session');
  await later(3);
  await page.mouse.click(box.x + box.width * x, box.y + box.height * y);
  await later(6);
  await afterwards?.();
  await later(2);
  await editor.press('Stop recording the session');
  const told = page.getByText(new RegExp(`^(Recorded “Recording ${number}”|The session could not|Nothing was recorded)`));
  await told.waitFor();
  expect(await told.textContent()).toBe(`Recorded “Recording ${number}”. Choose it as the preview source to replay it.`);
  expect(await ballPixels(editor)).toBeGreaterThan(50);

  const folder = join(project, `sessions/recording-${number}`);
  const { output: file, diagnostics } = readSessionFile(JSON.parse(await readFile(join(folder, 'session.json'), 'utf8')));
  expect(diagnostics).toEqual([]);
  if (!file) throw new Error('There is no session.');
  await chooseOption(page.getByRole('combobox', { name: 'Preview source' }), `project/recording-${number}`);
  await editor.settled();
  expect(await page.locator('.stage-notice').count()).toBe(0);
  await eventually(async () => expect(await ballPixels(open.editor)).toBeGreaterThan(50));
  return { file, folder };
}

/** The first and last phase of what pointed, and the number of taps. */
function pressOf({ frames }: SessionFile, kind: string) {
  const pointers = frames.flatMap(({ input }) => input?.pointers ?? []).filter(({ by, phase }) => by === kind && phase !== 'hover');
  return [pointers[0]?.phase, pointers.at(-1)?.phase, pointers.filter(({ tapped }) => tapped).length];
}

test('what a visitor of an emulated room does is recorded with the room, and a replay does it again', async () => {
  const { page, editor } = open;
  await chooseOption(page.getByRole('combobox', { name: 'Preview source' }), 'room/studio');
  await editor.settled();
  const drift = async () => {
    await page.keyboard.press('Shift+KeyV');
    await page.keyboard.press('KeyC');
  };
  const { file, folder } = await recordTap({ click: [0.5, 0.8], afterwards: drift });
  expect(pressOf(file, 'screen')).toEqual(['start', 'end', 1]);
  expect(file.surfaces?.map(({ label }) => label)).toContain('floor');
  // The visitor stood still: where world space drifts and is re-centered, the recording stays in the room.
  const first = file.frames[0]?.worldFromCamera ?? [];
  for (const { worldFromCamera } of file.frames) expect(worldFromCamera).toEqual(first.map((x) => expect.closeTo(x, 4)));
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
});

test('over a camera the image that is seen is recorded, and around an orbit black, and the same tap places again', async () => {
  const { page, editor } = open;
  const source = page.getByRole('combobox', { name: 'Preview source' });
  const chooser = page.waitForEvent('filechooser');
  await chooseOption(source, 'still');
  await (await chooser).setFiles({ name: 'gray.png', mimeType: 'image/png', buffer: Buffer.from(GRAY) });
  await editor.settled();
  const camera = await recordTap({ click: [0.5, 0.8] });
  expect(pressOf(camera.file, 'mouse')).toEqual(['start', 'end', 1]);
  const { data } = decodeJpeg(await readFile(join(camera.folder, camera.file.frames[0]?.color ?? '')));
  expect([...data.subarray(0, 3)].map((x) => Math.abs(x - 120) < 8)).toEqual([true, true, true]);

  await chooseOption(source, 'orbit');
  await editor.settled();
  const orbit = await recordTap({ click: [0.5, 0.6] });
  expect(pressOf(orbit.file, 'mouse')).toEqual(['start', 'end', 1]);
  expect(new Set(orbit.file.frames.map(({ color }) => color)).size).toBe(1);

  await choose('Record session');
  await page.getByText('The preview replays a recording. Choose a room, a camera or orbit as its source to record a session.').waitFor();
});
