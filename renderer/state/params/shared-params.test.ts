import { expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { endGesture, undo } from '../document/apply.ts';
import { graphOf, nodeOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { filesOf } from '../files/files.ts';
import { addNodeFromPalette, connect } from '../graph/edit-graph.ts';
import { editParam } from './edit-params.ts';
import { editShared, sharedParams } from './shared-params.ts';

function add(editor: Editor, type: string): string {
  const definition = editor.document.getState().library.definition(type);
  const id = definition && addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null);
  if (!id) throw new Error(`${type} was not added.`);
  return id;
}

function sharedBy(editor: Editor, nodes: readonly string[]) {
  const state = editor.document.getState();
  return sharedParams(graphOf(state), state.library, nodes);
}

const names = (editor: Editor, nodes: readonly string[]) => sharedBy(editor, nodes).map(({ name }) => name);

test('a param of several nodes is edited by one undo step', async () => {
  const { editor } = await openTestEditor();
  const nodes = [add(editor, 'filter/sepia'), add(editor, 'filter/sepia'), add(editor, 'filter/sepia')];
  editParam(editor, nodes[1] ?? '', 'amount', 0.2);
  endGesture(editor);
  const [amount] = sharedBy(editor, nodes);
  expect(amount).toMatchObject({ name: 'amount', mixed: true });
  if (!amount) return;
  const before = filesOf(editor);
  for (const value of [0.4, 0.5]) editShared(editor, nodes, amount, value);
  endGesture(editor);
  expect(nodes.map((id) => nodeOf(editor.document.getState(), id)?.params.amount)).toEqual(nodes.map(() => ({ value: 0.5 })));
  expect(sharedBy(editor, nodes)[0]).toMatchObject({ value: 0.5, mixed: false });
  undo(editor);
  expect(filesOf(editor)).toEqual(before);
});

test('an edit of one part of a vector keeps the others of each node', async () => {
  const { editor } = await openTestEditor();
  const nodes = [add(editor, 'objects/transform'), add(editor, 'objects/transform')] as const;
  editParam(editor, nodes[0], 'positionM', [1, 0, -2]);
  editParam(editor, nodes[1], 'positionM', [-1, 3, -4]);
  endGesture(editor);
  const position = sharedBy(editor, nodes).find(({ name }) => name === 'positionM');
  if (!position) throw new Error('The nodes do not share their position.');
  const before = filesOf(editor);
  for (const y of [0.2, 0.5]) editShared(editor, nodes, position, [1, y, -2]);
  endGesture(editor);
  expect(nodes.map((id) => nodeOf(editor.document.getState(), id)?.params.positionM)).toEqual([
    { value: [1, 0.5, -2] },
    { value: [-1, 0.5, -4] },
  ]);
  undo(editor);
  expect(filesOf(editor)).toEqual(before);
});

test('only params of the same kind with plain values are shared', async () => {
  const { editor } = await openTestEditor();
  const [sepia, other, number] = [add(editor, 'filter/sepia'), add(editor, 'filter/sepia'), add(editor, 'value/number')];
  expect(names(editor, [sepia, other])).toContain('amount');
  expect(names(editor, [sepia, number])).toEqual([]);
  expect(names(editor, [sepia])).toEqual([]);
  const output = Object.keys(editor.document.getState().library.definition('value/number')?.outputs ?? {})[0] ?? '';
  expect(connect(editor, { node: number, port: output }, { node: other, port: 'amount' })).toBe(true);
  expect(names(editor, [sepia, other])).not.toContain('amount');
});
