import { expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { undo } from '../document/apply.ts';
import { nodeOf } from '../editor/document.ts';
import { addNodeFromPalette } from '../graph/edit-graph.ts';
import { editParam } from './edit-params.ts';
import { scaleToLength, standOnFloor } from './true-size.ts';

test('a capture gets its true size from a known length and its floor, each with an undo step of its own', async () => {
  const { editor } = await openTestEditor();
  const definition = editor.document.getState().library.definition('source/capture');
  const id = definition && addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null);
  if (!id) throw new Error('The node was not added.');
  const params = () => nodeOf(editor.document.getState(), id)?.params;
  editParam(editor, id, 'positionM', [1, 0.5, 2]);
  // A door of 2 m that is 0.5 m high in the reconstruction.
  expect(scaleToLength(editor, id, 0.5, 2)).toBe(true);
  expect(params()?.scale).toEqual({ value: 4 });
  expect(scaleToLength(editor, id, 2, 1)).toBe(true);
  expect(params()?.scale).toEqual({ value: 2 });
  expect(standOnFloor(editor, id, -1.2)).toBe(true);
  expect(params()?.positionM).toEqual({ value: [1, 1.7, 2] });
  undo(editor);
  undo(editor);
  expect(params()).toMatchObject({ scale: { value: 4 }, positionM: { value: [1, 0.5, 2] } });
  // The param has no larger values.
  expect(scaleToLength(editor, id, 0.001, 1)).toBe(true);
  expect(params()?.scale).toEqual({ value: 10 });
});
