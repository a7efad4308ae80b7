import { describe, expect, test } from '@jest/globals';
import { loadProject } from '../../../export/graph/load.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { undo } from '../document/apply.ts';
import { layoutOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { itemIds } from '../editor/item-ids.ts';
import { selectOnly } from '../editor/selection.ts';
import { filesOf } from '../files/files.ts';
import { tidy } from './arrange.ts';
import { addNodeFromPalette, deleteSelection } from './edit-graph.ts';
import { addFrame, addNote, boxOfItem, contentOf, editItemText, moveAll, resizeItem } from './layout-items.ts';
import { createSubgraph, openSubgraph } from './subgraphs.ts';

function add(editor: Editor, x: number, y: number): string {
  const definition = editor.document.getState().library.definition('filter/sepia');
  const id = definition ? addNodeFromPalette(editor, { definition, port: null }, { x, y }, null) : null;
  if (id === null) throw new Error('The node was not added.');
  return id;
}

const itemsOf = (editor: Editor) => itemIds(layoutOf(editor.document.getState()));
const placeOf = (editor: Editor, id: string) => layoutOf(editor.document.getState()).nodes[id];

test('the border of a subgraph keeps its place in the layout until the whole graph is tidied up', async () => {
  const { editor } = await openTestEditor();
  selectOnly(editor.selection, [add(editor, 100, 100), add(editor, 500, 100)]);
  expect(createSubgraph(editor)).toBe(true);
  const name = Object.keys(editor.document.getState().project.graphs).find((graph) => graph !== 'main') ?? '';
  openSubgraph(editor, name);
  const { project, layout } = filesOf(editor);
  moveAll(editor, { 'border:outputs': { x: 900.4, y: 40 } });
  moveAll(editor, { 'border:inputs': { x: -300, y: 0 } });
  expect(filesOf(editor).project).toBe(project);
  const read = loadProject({ project, layout: filesOf(editor).layout, sources: {} }).output;
  expect(read?.layout[name]?.borders).toEqual({ inputs: { x: -300, y: 0 }, outputs: { x: 900, y: 40 } });
  await tidy(editor);
  expect(layoutOf(editor.document.getState()).borders).toBeUndefined();
  for (let step = 0; step < 3; step++) undo(editor);
  expect(filesOf(editor).layout).toBe(layout);
});

describe('a frame', () => {
  test('goes around the selected nodes, and takes them along, with what else lies in it', async () => {
    const { editor } = await openTestEditor();
    const [inside, outside] = [add(editor, 100, 100), add(editor, 900, 100)];
    selectOnly(editor.selection, [inside]);
    addFrame(editor, { x: 0, y: 0 });
    const [frame = ''] = itemsOf(editor);
    addNote(editor, { x: 100, y: 110 });
    resizeItem(editor, frame, { x: 60, y: 20, width: 400, height: 300 });
    const content = contentOf(editor, frame);
    expect(Object.keys(content).sort()).toEqual([inside, itemsOf(editor)[1]].sort());
    const before = filesOf(editor);
    moveAll(editor, { [frame]: { x: 160, y: 20 }, [inside]: { x: 200, y: 100 } });
    expect(placeOf(editor, inside)).toEqual({ x: 200, y: 100 });
    expect(placeOf(editor, outside)).toEqual({ x: 900, y: 100 });
    expect(boxOfItem(layoutOf(editor.document.getState()), frame)).toMatchObject({ x: 160, y: 20, width: 400, height: 300 });
    undo(editor);
    expect(filesOf(editor)).toEqual(before);
  });

  test('stands where it is asked for while nothing is selected; it is named and deleted without touching the picture', async () => {
    const { editor } = await openTestEditor();
    const { project } = filesOf(editor);
    addFrame(editor, { x: 8, y: 16 });
    const [frame = ''] = itemsOf(editor);
    editItemText(editor, frame, 'Wa');
    editItemText(editor, frame, 'Water');
    expect(boxOfItem(layoutOf(editor.document.getState()), frame)).toMatchObject({ x: 8, y: 16, title: 'Water' });
    expect(filesOf(editor).project).toBe(project);
    selectOnly(editor.selection, [], [], [frame]);
    deleteSelection(editor);
    expect(itemsOf(editor)).toEqual([]);
    undo(editor);
    undo(editor);
    expect(boxOfItem(layoutOf(editor.document.getState()), frame)).toMatchObject({ title: 'Frame' });
    undo(editor);
    expect(editor.selection.getState().items.size).toBe(0);
  });
});
