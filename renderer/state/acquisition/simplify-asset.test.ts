import { expect, test } from '@jest/globals';
import { putAsset } from '../../../export/graph/commands/asset-commands.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { runCommand } from '../commands/app-commands.ts';
import { apply } from '../document/apply.ts';
import { cancelExport } from '../files/export-page.ts';
import { handleHostEvents } from '../start.ts';
import { simplifyAsset } from './simplify-asset.ts';

const STATUE = { path: 'assets/statue.glb', kind: 'model', credit: 'Somebody', licence: 'MIT' } as const;
const REQUEST = { id: 'statue-1', program: 'blender', executable: '', triangles: 1000 } as const;

async function withStatue() {
  const opened = await openTestEditor();
  const { editor } = opened;
  apply(editor, 'Add', putAsset(editor.document.getState().project, { id: 'statue-1', asset: STATUE }));
  editor.ui.setState({ dialog: { kind: 'simplify', id: 'statue-1' } });
  return { ...opened, assets: () => editor.document.getState().project.assets };
}

test('the result is a new asset of the same author, which undo removes', async () => {
  const { editor, host, assets } = await withStatue();
  expect(await simplifyAsset(editor, { ...REQUEST, replaces: false })).toBe(true);
  const simple = { ...STATUE, path: 'assets/statue-simple.glb' };
  expect(Object.values(assets())).toEqual([STATUE, simple]);
  expect(host.calls.find(({ method }) => method === 'simplify.run')?.input).toMatchObject({
    path: STATUE.path,
    executable: null,
    triangles: 1000,
  });
  const { dialog, toasts, exporting, bottom } = editor.ui.getState();
  expect([dialog, exporting, bottom]).toEqual([null, null, 'assets']);
  expect(toasts.at(-1)).toMatchObject({ text: 'Added statue-simple.glb.', detail: '1,000 triangles instead of 5,000.' });
  runCommand(editor, 'edit.undo');
  expect(Object.values(assets())).toEqual([STATUE]);
});

test('the result replaces the asset, and undo brings it back', async () => {
  const { editor, assets } = await withStatue();
  expect(await simplifyAsset(editor, { ...REQUEST, replaces: true })).toBe(true);
  expect(assets()).toEqual({ 'statue-1': { ...STATUE, path: 'assets/statue-simple.glb' } });
  runCommand(editor, 'edit.undo');
  expect(assets()).toEqual({ 'statue-1': STATUE });
});

test('a failure stays in the dialog with what the program printed, and a cancel changes nothing', async () => {
  const { editor, host, assets } = await withStatue();
  const stop = handleHostEvents(editor);
  const { handle } = editor.document.getState().open ?? { handle: '' };
  host.refuse('simplify.run', 'SCR078', 'Blender ended.');
  const failed = simplifyAsset(editor, { ...REQUEST, replaces: false });
  host.emit({ kind: 'tool-log', handle, lines: ['Blender 3.4.1', 'Out of memory'] });
  expect(await failed).toBe(false);
  expect(editor.ui.getState()).toMatchObject({
    ...{ dialog: { kind: 'simplify' }, exporting: null, toasts: [] },
    toolRun: { dialog: 'simplify', step: 'read', lines: ['Blender 3.4.1', 'Out of memory'], error: { code: 'SCR078' } },
  });

  host.answer('simplify.run', async () => {
    await cancelExport(editor);
    return { path: null, before: 0, after: 0 };
  });
  expect(await simplifyAsset(editor, { ...REQUEST, replaces: true })).toBe(false);
  expect(host.calls.some(({ method }) => method === 'tool.cancel')).toBe(true);
  expect(assets()).toEqual({ 'statue-1': STATUE });
  stop();
});
