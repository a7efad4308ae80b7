import { describe, expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { undo } from '../document/apply.ts';
import { layoutOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { itemIds } from '../editor/item-ids.ts';
import { selectOnly } from '../editor/selection.ts';
import { filesOf } from '../files/files.ts';
import { addNodeFromPalette, deleteSelection } from './edit-graph.ts';
import { addFrame, addNote, boxOfItem, contentOf, editItemText, moveAll, resizeItem } from './layout-items.ts';

function add(editor: Editor, x: number, y: number): string {
  const definition = editor.document.getState().library.definition('filter/sepia');
  const id = definition ? addNodeFromPalette(editor, { definition, port: null }, { x, y }, null) : null;
  if (id === null) throw new Error('The node was not added.');
  return id;
}

const itemsOf = (editor: Editor) => itemIds(layoutOf(editor.document.getState()));
const placeOf = (editor: Editor, id: string) => layoutOf(editor.document.getState()).nodes[id];

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
