import { expect, test } from '@jest/globals';
import { frameOf } from '../../tools/lib/frame-of.ts';
import { chooseOption, chosenValue } from '../support/choose-option.ts';
import { useEditor } from '../support/open-editor.ts';

const openEditor = useEditor();

type Losing = typeof globalThis & { lost?: WEBGL_lose_context | null };

test('the preview of an emulated room comes back after the graphics device was lost, in the same session', async () => {
  const { page, editor } = await openEditor({
    nodes: { 'video-aaaa': { type: 'source/camera-video' }, 'screen-aaaa': { type: 'output/screen' } },
    wires: ['video-aaaa.layer -> screen-aaaa.layer'],
    places: { 'video-aaaa': [0, 0], 'screen-aaaa': [520, 0] },
  });
  await editor.settled();
  const source = page.getByRole('combobox', { name: 'Preview source' });
  await chooseOption(source, 'room/studio');
  await editor.settled();
  const before = await editor.rewind();
  const frame = await frameOf(page);
  const canLose = await frame.evaluate(() => {
    const extension = document.querySelector<HTMLCanvasElement>('#picture')?.getContext('webgl2')?.getExtension('WEBGL_lose_context');
    (globalThis as Losing).lost = extension ?? null;
    extension?.loseContext();
    return extension !== null && extension !== undefined;
  });
  expect(canLose).toBe(true);
  await page.getByText('The graphics device was lost').waitFor();
  await frame.evaluate(() => (globalThis as Losing).lost?.restoreContext());
  await page.getByText('The graphics device was lost').waitFor({ state: 'detached' });
  const isLost = () => document.querySelector<HTMLCanvasElement>('#picture')?.getContext('webgl2')?.isContextLost();
  expect(await frame.evaluate(isLost)).toBe(false);
  expect(await chosenValue(source)).toBe('room/studio');
  await editor.imageSameAs(before);
});
