import { test } from '@jest/globals';
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
  await page.getByRole('combobox', { name: 'Where the picture comes from' }).selectOption('room/studio');
  await editor.settled();
  const before = await editor.rewind();
  const frame = page.frames().find((candidate) => candidate !== page.mainFrame());
  await frame?.evaluate(() => {
    const extension = document.querySelector<HTMLCanvasElement>('#picture')?.getContext('webgl2')?.getExtension('WEBGL_lose_context');
    (globalThis as Losing).lost = extension ?? null;
    extension?.loseContext();
  });
  await page.getByText('The graphics device was lost').waitFor();
  await frame?.evaluate(() => (globalThis as Losing).lost?.restoreContext());
  await page.getByText('The graphics device was lost').waitFor({ state: 'detached' });
  await editor.pictureSameAs(before);
});
