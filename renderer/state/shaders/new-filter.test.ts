import { expect, test } from '@jest/globals';
import { printWire } from '../../../export/graph/wires.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { undo } from '../document/apply.ts';
import { graphOf } from '../editor/document.ts';
import { selectOnly, soleNode } from '../editor/selection.ts';
import { addNodeFromPalette } from '../graph/edit-graph.ts';
import { startFilter } from '../graph/first-steps.ts';
import { editParam } from '../params/edit-params.ts';
import { canDuplicateFilter, duplicateFilter, newFilter } from './new-filter.ts';

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

test('a duplicated filter is one of the project in the place of the selected one, with its values and wires and its shader open', async () => {
  const { editor } = await openTestEditor();
  expect(canDuplicateFilter(editor)).toBe(false);
  startFilter(editor, { x: 0, y: 0 });
  const { library } = editor.document.getState();
  const definition = library.definition('filter/sepia');
  const [wire] = graphOf(editor.document.getState()).wires.map(printWire);
  if (!definition || wire === undefined) throw new Error('There is no sepia, or no wire for it.');
  const sepia = addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 400 }, null, wire) ?? '';
  editParam(editor, sepia, 'amount', 0.25);
  const before = editor.document.getState().project;

  expect(canDuplicateFilter(editor)).toBe(true);
  expect(duplicateFilter(editor)).toBe(sepia);
  const after = editor.document.getState();
  expect(after.project.sources).toEqual({ 'sepia-2.fs': library.shader('filters/sepia.fs') });
  expect(graphOf(after).nodes[sepia]).toMatchObject({ type: 'filter/sepia-2', params: { amount: { value: 0.25 } } });
  expect(graphOf(after).wires).toEqual(before.graphs[after.graph]?.wires);
  expect(editor.ui.getState().bottom).toBe('code');

  // One of the project is duplicated, too.
  duplicateFilter(editor);
  expect(graphOf(editor.document.getState()).nodes[sepia]?.type).toBe('filter/sepia-3');
  undo(editor);
  undo(editor);
  expect(editor.document.getState().project).toEqual(before);
});
