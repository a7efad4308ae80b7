import { expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { addNodeFromPalette } from '../graph/edit-graph.ts';
import { bindExpression } from '../params/bind-params.ts';
import { gizmoTargetOf } from './gizmo-target.ts';

test('a shape whose rotation has an expression keeps the handle of its center alone', async () => {
  const { editor } = await openTestEditor();
  const definition = editor.document.getState().library.definition('generator/shape-mask');
  const shape = definition ? addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null) : null;
  const handles = () => gizmoTargetOf(editor.document.getState(), shape, [], 'move').target?.handles;
  expect(handles()).toEqual({ center: 'center', size: 'size', angle: 'rotation', feather: 'feather' });
  bindExpression(editor, shape ?? '', 'rotation', 'time');
  expect(handles()).toEqual({ center: 'center' });
});
