import { expect, test } from '@jest/globals';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { undo } from '../document/apply.ts';
import { graphOf, nodeOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { filesOf } from '../files/files.ts';
import { addNodeFromPalette, connect } from '../graph/edit-graph.ts';
import { editParam } from '../params/edit-params.ts';
import { quickFixOf } from './quick-fixes.ts';

function add(editor: Editor, type: string): string {
  const definition = editor.document.getState().library.definition(type);
  const id = definition ? addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null) : null;
  if (id === null) throw new Error(`${type} was not added.`);
  return id;
}

const problem = (code: Diagnostic['code'], more: Partial<Diagnostic> = {}): Diagnostic => ({
  code,
  severity: 'error',
  message: '',
  ...more,
});

test('a node that does nothing is deleted, and undo brings it back', async () => {
  const { editor } = await openTestEditor();
  const id = add(editor, 'filter/sepia');
  const before = filesOf(editor);
  const fix = quickFixOf(editor, problem('SCR021', { nodeId: id }));
  expect(fix?.label).toBe('Delete Sepia');
  fix?.run(editor);
  expect(nodeOf(editor.document.getState(), id)).toBeUndefined();
  undo(editor);
  expect(filesOf(editor)).toEqual(before);
});

test('a value that does not fit goes back to the definition’s', async () => {
  const { editor } = await openTestEditor();
  const id = add(editor, 'filter/gaussian-blur');
  const untouched = nodeOf(editor.document.getState(), id)?.params;
  editParam(editor, id, 'radius', 7);
  quickFixOf(editor, problem('SCR018', { nodeId: id, port: 'radius' }))?.run(editor);
  expect(nodeOf(editor.document.getState(), id)?.params).toEqual(untouched);
});

test('a screen is added where there is none, and only there', async () => {
  const { editor } = await openTestEditor();
  const screens = () => Object.values(graphOf(editor.document.getState()).nodes).filter(({ type }) => type === 'output/screen').length;
  for (const id of Object.keys(graphOf(editor.document.getState()).nodes))
    quickFixOf(editor, problem('SCR021', { nodeId: id }))?.run(editor);
  expect(screens()).toBe(0);
  quickFixOf(editor, problem('SCR017'))?.run(editor);
  expect(screens()).toBe(1);
  expect(quickFixOf(editor, problem('SCR017'))).toBeNull();
});

test('what only the person can decide has no fix', async () => {
  const { editor } = await openTestEditor();
  expect(quickFixOf(editor, problem('SCR014', { nodeId: add(editor, 'filter/sepia') }))).toBeNull();
  expect(quickFixOf(editor, problem('SCR021', { nodeId: 'nobody-aaaa' }))).toBeNull();
});

test('a scene layer is converted when it is connected to what shows display layers, and by the fix', async () => {
  const { editor } = await openTestEditor();
  const [scene, sepia] = [add(editor, 'layer/scene'), add(editor, 'filter/sepia')];
  const wiresTo = (node: string) => graphOf(editor.document.getState()).wires.filter(({ to }) => to.node === node);
  connect(editor, { node: scene, port: 'layer' }, { node: sepia, port: 'inputImage' });
  expect(wiresTo(sepia).map(({ from }) => from.node)).toEqual([scene]);
  editParam(editor, scene, 'encoding', 'scene');
  const fix = quickFixOf(editor, problem('SCR048', { nodeId: sepia, port: 'inputImage' }));
  expect(fix?.label).toBe('Insert Tone map');
  fix?.run(editor);
  const [fixed] = wiresTo(sepia);
  expect(nodeOf(editor.document.getState(), fixed?.from.node ?? '')?.type).toBe('filter/tone-map');
  undo(editor);
  expect(wiresTo(sepia).map(({ from }) => from.node)).toEqual([scene]);

  const blur = add(editor, 'filter/posterize');
  connect(editor, { node: scene, port: 'layer' }, { node: blur, port: 'inputImage' });
  const [made] = wiresTo(blur);
  expect(nodeOf(editor.document.getState(), made?.from.node ?? '')?.type).toBe('filter/tone-map');
  // What did not fit before stays as it is.
  expect(wiresTo(sepia).map(({ from }) => from.node)).toEqual([scene]);
});
