import { expect, test } from '@jest/globals';
import { decode } from 'fast-png';
import type { FakeHost } from '../../../tests/support/fake-host.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { undo } from '../document/apply.ts';
import { graphOf } from '../editor/document.ts';
import { addFiles } from './add-files.ts';

const TWO = ['0 0 0', '1 0 0', '0 1 0', '1 1 0', '0 0 1', '1 0 1', '0 1 1', '1 1 1'];

const dropped = (text: string) => ({
  name: 'Warm look.cube',
  arrayBuffer: async () => new TextEncoder().encode(text).buffer as ArrayBuffer,
});

function importedBytes({ calls }: FakeHost): Uint8Array {
  const [input] = calls.flatMap(({ method, input }) => (method === 'asset.import' ? [input] : []));
  return (input as { readonly bytes: Uint8Array }).bytes;
}

test('a dropped color table becomes a picture and the operator that grades by it, in one step', async () => {
  const { editor, host } = await openTestEditor();
  await addFiles(editor, [dropped(['LUT_3D_SIZE 2', ...TWO].join('\n'))], { x: 10, y: 20 });
  const { project } = editor.document.getState();
  const [[asset, { path, kind }] = ['', { path: '', kind: '' }]] = Object.entries(project.assets);
  expect([path, kind]).toEqual(['assets/Warm look.png', 'image']);
  const { width, height, data } = decode(importedBytes(host));
  expect([width, height, [...data.slice(4, 8)]]).toEqual([4, 2, [255, 0, 0, 255]]);
  const { nodes, wires } = graphOf(editor.document.getState());
  const [picture = '', table = ''] = editor.selection.getState().nodes;
  expect(nodes[picture]).toMatchObject({ type: 'source/image-file', params: { file: { value: asset } } });
  expect(nodes[table]).toMatchObject({ type: 'operator/color-lut', params: { size: { value: 2 }, columns: { value: 2 } } });
  expect(wires).toContainEqual({ from: { node: picture, port: 'layer' }, to: { node: table, port: 'table' } });
  undo(editor);
  expect(editor.document.getState().project.assets).toEqual({});
});

test('a table that is broken changes nothing, and says on which line', async () => {
  const { editor, host } = await openTestEditor();
  await addFiles(editor, [dropped(['LUT_3D_SIZE 2', ...TWO.slice(1), 'red'].join('\n'))], { x: 0, y: 0 });
  expect(host.calls.map(({ method }) => method)).not.toContain('asset.import');
  expect(editor.document.getState().project.assets).toEqual({});
  expect(editor.ui.getState().toasts).toMatchObject([
    { tone: 'error', text: 'Warm look.cube, line 9: The table has 7 entries, but its size requires 8.' },
  ]);
});
