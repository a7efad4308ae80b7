import { describe, expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { redo, undo } from '../document/apply.ts';
import { graphOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { selectOnly } from '../editor/selection.ts';
import { filesOf } from '../files/files.ts';
import { addNodeFromPalette, connect } from './edit-graph.ts';
import {
  createSubgraph,
  leaveSubgraph,
  makeUnique,
  openSubgraph,
  renameSubgraph,
  selectedSubgraph,
  setPortExposed,
  ungroupSelected,
} from './subgraphs.ts';

function add(editor: Editor, type: string): string {
  const definition = editor.document.getState().library.definition(type);
  const id = definition ? addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null) : null;
  if (id === null) throw new Error(`${type} was not added.`);
  return id;
}

/** Sepia → blur → edges, of which the first two are put into a subgraph; it is selected. */
async function packed() {
  const { editor } = await openTestEditor();
  const [sepia, blur, edges] = ['filter/sepia', 'filter/gaussian-blur', 'filter/sobel-edges'].map((type) => add(editor, type));
  if (!sepia || !blur || !edges) throw new Error('Nodes are missing.');
  connect(editor, { node: sepia, port: 'layer' }, { node: blur, port: 'inputImage' });
  connect(editor, { node: blur, port: 'layer' }, { node: edges, port: 'inputImage' });
  const before = filesOf(editor);
  selectOnly(editor.selection, [sepia, blur]);
  createSubgraph(editor);
  return { editor, sepia, blur, edges, before };
}

const typesOf = (editor: Editor) =>
  Object.values(graphOf(editor.document.getState()).nodes)
    .map(({ type }) => type)
    .sort();

describe('subgraphs', () => {
  test('are made of the selection, opened, left and undone from within', async () => {
    const { editor, before } = await packed();
    expect(typesOf(editor)).toEqual(['filter/sobel-edges', 'graph/subgraph']);
    expect(selectedSubgraph(editor)).toBe('subgraph');
    openSubgraph(editor, 'subgraph');
    expect(typesOf(editor)).toEqual(['filter/gaussian-blur', 'filter/sepia']);
    expect(editor.document.getState().trail).toEqual(['main']);
    leaveSubgraph(editor);
    expect(selectedSubgraph(editor)).toBe('subgraph');
    openSubgraph(editor, 'subgraph');
    undo(editor);
    expect(editor.document.getState()).toMatchObject({ graph: 'main', trail: [] });
    expect(filesOf(editor)).toEqual(before);
    redo(editor);
    expect(typesOf(editor)).toEqual(['filter/sobel-edges', 'graph/subgraph']);
  });

  test('are node types of the palette under their names, and follow a new name', async () => {
    const { editor } = await packed();
    openSubgraph(editor, 'subgraph');
    renameSubgraph(editor, 'subgraph', 'Soft  Löok 2');
    const { graph, library } = editor.document.getState();
    expect(graph).toBe('soft-look-2');
    expect(library.definition(`graph/${graph}`)?.title).toBe('Soft look 2');
    leaveSubgraph(editor);
    expect(typesOf(editor)).toContain(`graph/${graph}`);
    expect(renameSubgraph(editor, graph, '!!')).toBe(false);
  });

  test('show ports and values of their nodes outside', async () => {
    const { editor, sepia } = await packed();
    openSubgraph(editor, 'subgraph');
    setPortExposed(editor, 'inputs', { node: sepia, port: 'amount' }, true);
    setPortExposed(editor, 'inputs', { node: sepia, port: 'inputImage' }, true);
    const face = () => editor.document.getState().library.definition('graph/subgraph');
    expect(Object.keys(face()?.params ?? {})).toEqual(['amount']);
    expect(Object.keys(face()?.inputs ?? {})).toEqual(['inputImage']);
    setPortExposed(editor, 'inputs', { node: sepia, port: 'amount' }, false);
    expect(Object.keys(face()?.params ?? {})).toEqual([]);
  });

  test('are made independent, so that a change of one leaves the others', async () => {
    const { editor } = await packed();
    makeUnique(editor);
    expect(typesOf(editor)).toContain('graph/subgraph-2');
    expect(Object.keys(editor.document.getState().project.graphs)).toContain('subgraph');
    expect(graphOf(editor.document.getState()).wires).toHaveLength(1);
  });

  test('are unpacked where they stood', async () => {
    const { editor } = await packed();
    ungroupSelected(editor);
    expect(typesOf(editor)).toEqual(['filter/gaussian-blur', 'filter/sepia', 'filter/sobel-edges']);
    expect(editor.selection.getState().nodes.size).toBe(2);
    expect(graphOf(editor.document.getState()).wires).toHaveLength(2);
  });
});
