import { expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { undo } from '../document/apply.ts';
import { graphOf } from '../editor/document.ts';
import { selectOnly, soleNode } from '../editor/selection.ts';
import { addNodeFromPalette } from '../graph/edit-graph.ts';
import { startFilter } from '../graph/first-steps.ts';
import { newFilter } from './new-filter.ts';

test('a new filter lies between the camera and the output, with its shader open; one undo removes it', async () => {
  const { editor } = await openTestEditor();
  startFilter(editor, { x: 0, y: 0 });
  const before = editor.document.getState().project;
  const node = newFilter(editor) ?? '';
  const { nodes, wires } = graphOf(editor.document.getState());
  expect(nodes[node]?.type).toBe('filter/my-filter');
  expect(wires.map(({ from, to }) => `${nodes[from.node]?.type} -> ${nodes[to.node]?.type}`).sort()).toEqual([
    'filter/my-filter -> output/screen',
    'source/camera-video -> filter/my-filter',
  ]);
  expect(editor.ui.getState().bottom).toBe('code');

  // The second comes after the first, with a name of its own.
  selectOnly(editor.selection, [node]);
  const next = newFilter(editor) ?? '';
  expect(graphOf(editor.document.getState()).nodes[next]?.type).toBe('filter/my-filter-2');
  undo(editor);
  undo(editor);
  expect(editor.document.getState().project).toEqual(before);
});

test('a new filter continues the selected node, also one that is not connected', async () => {
  const { editor } = await openTestEditor();
  startFilter(editor, { x: 0, y: 0 });
  const { library } = editor.document.getState();
  const definition = library.definition('source/image-file');
  if (!definition) throw new Error('There is no node type Image.');
  const image = addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 400 }, null) ?? '';
  expect(soleNode(editor.selection.getState())).toBe(image);
  const node = newFilter(editor) ?? '';
  const { nodes, wires } = graphOf(editor.document.getState());
  expect(wires.map(({ from, to }) => `${nodes[from.node]?.type} -> ${nodes[to.node]?.type}`).sort()).toEqual([
    'source/camera-video -> output/screen',
    'source/image-file -> filter/my-filter',
  ]);
  expect(nodes[node]?.type).toBe('filter/my-filter');
});
