import { expect, test } from '@jest/globals';
import { newProject } from '../../../export/graph/new-project.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { undo } from '../document/apply.ts';
import { graphOf, isDirty } from '../editor/document.ts';
import { addNodeFromPalette } from '../graph/edit-graph.ts';
import { handleHostEvents } from '../start.ts';
import { editHere } from './external-changes.ts';
import { save } from './files.ts';

const SHADER = `/*{ "ISFVSN": "2", "INPUTS": [ { "NAME": "inputImage", "TYPE": "image" }, { "NAME": "much", "TYPE": "float" } ] }*/
void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage) * much; }
`;

async function withShader() {
  const project = { ...newProject('Test'), sources: { 'edge.fs': SHADER } };
  const { editor, host } = await openTestEditor(project);
  handleHostEvents(editor);
  const definition = editor.document.getState().library.definition('filter/edge');
  const node = definition && addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null);
  if (!node || !(await save(editor))) throw new Error('The project was not made.');
  const text = () => editor.document.getState().project.sources['edge.fs'];
  const open = () => editor.document.getState().open;
  const write = (next: string | null, before: string | null = text() ?? null) =>
    host.emit({
      kind: 'shaders-changed-outside',
      handle: open()?.handle ?? '',
      from: open()?.revision ?? '',
      revision: `${open()?.revision}+`,
      shaders: [{ file: 'edge.fs', before, text: next }],
    });
  return { editor, node, text, write, open, dirty: () => isDirty(editor.document.getState()) };
}

test('a shader saved by another program is taken over, read only until it is taken back, and the folder has it already', async () => {
  const { editor, text, write, dirty, open } = await withShader();
  const revision = open()?.revision;
  write(`${SHADER}// outside\n`);
  expect(text()).toContain('// outside');
  expect([dirty(), open()?.revision]).toEqual([false, `${revision}+`]);
  expect(editor.ui.getState().outside).toEqual(['edge.fs']);
  // However often the file is saved outside, one undo restores what it was.
  write(`${SHADER}// outside, twice\n`);
  undo(editor);
  expect([text(), dirty()]).toEqual([SHADER, true]);
  editHere(editor, 'edge.fs');
  expect(editor.ui.getState().outside).toEqual([]);
});

test('a header changed outside changes the ports here, which is not saved yet', async () => {
  const { editor, node, write, dirty } = await withShader();
  editor.document.getState();
  write(SHADER.replaceAll('much', 'strength'));
  const { library } = editor.document.getState();
  expect(Object.keys(library.definition('filter/edge')?.params ?? {})).toEqual(['strength']);
  expect(graphOf(editor.document.getState()).nodes[node]?.type).toBe('filter/edge');
  expect(dirty()).toBe(false);
});

test('with unsaved changes of its own, the person is asked; with others, they stay', async () => {
  const { editor, text, write, dirty } = await withShader();
  undo(editor);
  expect(dirty()).toBe(true);
  write(`${SHADER}// outside\n`);
  expect([text()?.includes('// outside'), dirty(), editor.ui.getState().dialog]).toEqual([true, true, null]);
  write(`${SHADER}// more\n`, SHADER);
  expect(editor.ui.getState().dialog).toEqual({ kind: 'changed-outside' });
});
