import { expect, test } from '@jest/globals';
import { categoryLabel } from '../../../nodes/kit/categories.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { undo } from '../document/apply.ts';
import { graphOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { filesOf } from '../files/files.ts';
import { isBlank, startFilter, startObject } from './first-steps.ts';

function typedWires(editor: Editor): string[] {
  const { nodes, wires } = graphOf(editor.document.getState());
  return wires.map(({ from, to }) => `${nodes[from.node]?.type} -> ${nodes[to.node]?.type}.${to.port}`).sort();
}

test('a filter: the camera is connected to the output once, and the palette asks what goes between, filters first', async () => {
  const { editor } = await openTestEditor();
  expect(isBlank(editor.document.getState())).toBe(true);
  startFilter(editor, { x: 0, y: 0 });
  startFilter(editor, { x: 0, y: 0 });
  expect(typedWires(editor)).toEqual(['source/camera-video -> output/screen.layer']);
  expect(editor.ui.getState().palette?.first).toBe(categoryLabel('filter/sepia'));
  expect(editor.ui.getState().palette?.wire).toMatch(/^camera-video-\w+\.layer -> screen-\w+\.layer$/);
  expect(isBlank(editor.document.getState())).toBe(true);
});

test('an object: it stands in a lit scene over the camera, and one undo removes all of it', async () => {
  const { editor } = await openTestEditor();
  const before = filesOf(editor);
  expect(startObject(editor)).toMatch(/^primitive-/);
  expect(typedWires(editor)).toEqual([
    'layer/scene -> operator/over.top',
    'light/directional -> layer/scene.lights',
    'objects/primitive -> objects/transform.objects',
    'objects/transform -> layer/scene.objects',
    'operator/over -> output/screen.layer',
    'source/camera-video -> operator/over.bottom',
  ]);
  expect(isBlank(editor.document.getState())).toBe(false);
  undo(editor);
  expect(filesOf(editor)).toEqual(before);
});
