import { expect, test } from '@jest/globals';
import { newProject } from '../../../export/graph/new-project.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { openPath } from '../files/files.ts';
import { playDevice } from './play-device.ts';
import { previewSource } from './preview-source.ts';

async function roomEditor() {
  const { editor } = await openTestEditor(newProject('Test'));
  await openPath(editor, '/project');
  const room = { id: 'room/a', title: 'A', kind: 'room', url: null } as const;
  editor.preview.setState({ sources: [{ id: 'recorded/b', title: 'B', kind: 'recorded', url: '/b' }, room], sourceId: 'recorded/b' });
  return editor;
}

test('a headset is played in an emulated room that refuses what the headset lacks', async () => {
  const editor = await roomEditor();
  expect(playDevice(editor.preview, { kind: 'quest', tier: 'ar' })).toBe(true);
  const source = previewSource(editor);
  expect(source).toMatchObject({ kind: 'room', device: 'headset', views: 2, tier: 'ar' });
  expect(source).toHaveProperty('refuse', expect.arrayContaining(['camera-access', 'light-estimation', 'dom-overlay']));
});

test('a device without AR is played with the camera of this computer', async () => {
  const editor = await roomEditor();
  playDevice(editor.preview, { kind: 'iphone', tier: 'camera' });
  expect(previewSource(editor)).toMatchObject({ kind: 'camera' });
  expect(editor.preview.getState().frame).toBe('phone');
});

test('nothing changes where no room is installed', async () => {
  const editor = await roomEditor();
  editor.preview.setState({ sources: [], sourceId: 'orbit' });
  expect(playDevice(editor.preview, { kind: 'vision-pro', tier: 'authored-vr' })).toBe(false);
  expect(editor.preview.getState()).toMatchObject({ sourceId: 'orbit', deviceKind: null });
});
