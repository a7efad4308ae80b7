import { expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { addNodeFromPalette } from '../graph/edit-graph.ts';
import { hideCamera, toggleCamera } from './untouched-camera.ts';
import { pinLayer, viewedLayers } from './viewed-layers.ts';

test('shows the camera while the key is held, and then what was shown before', async () => {
  const { editor } = await openTestEditor();
  const definition = editor.document.getState().library.definition('source/camera-video');
  const camera = definition && addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null);
  pinLayer(editor.viewer, 'sepia-aaaa.layer');
  toggleCamera(editor);
  expect(editor.viewer.getState().left).toBe(`${camera}.layer`);
  // The program keeps the layer also where no wire leads from it to the screen.
  expect(viewedLayers(editor)).toEqual([`${camera}.layer`]);
  hideCamera(editor);
  hideCamera(editor);
  expect(editor.viewer.getState()).toMatchObject({ left: 'sepia-aaaa.layer', beforeCamera: null });
});

test('says so where the project does not show the camera', async () => {
  const { editor } = await openTestEditor();
  toggleCamera(editor);
  expect(editor.viewer.getState().left).toBeNull();
  expect(editor.ui.getState().toasts.map(({ text }) => text)).toEqual(['“Test” does not show the camera.']);
});
