import { describe, expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { undo } from '../document/apply.ts';
import { graphOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { selectOnly } from '../editor/selection.ts';
import { filesOf } from '../files/files.ts';
import { addNodeFromPalette } from './edit-graph.ts';
import { addFromLibrary, librarySubgraphs, removeFromLibrary, saveToLibrary, titleProblem, usesInWords } from './subgraph-library.ts';
import { createSubgraph, openSubgraph } from './subgraphs.ts';

const PLACE = { x: 0, y: 0 };

/** A sepia in a subgraph “Glow”, which stands in the main graph. */
async function withGlow(): Promise<Editor> {
  const { editor } = await openTestEditor();
  const definition = editor.document.getState().library.definition('filter/sepia');
  const sepia = definition && addNodeFromPalette(editor, { definition, port: null }, PLACE, null);
  if (!sepia) throw new Error('There is no sepia.');
  selectOnly(editor.selection, [sepia]);
  createSubgraph(editor);
  saveToLibrary(editor, 'subgraph', 'Glow');
  return editor;
}

const project = (editor: Editor) => editor.document.getState().project;
const typesOf = (editor: Editor) => Object.values(graphOf(editor.document.getState()).nodes).map(({ type }) => type);

describe('the library of a project', () => {
  test('has the subgraphs under the names that they were given', async () => {
    const editor = await withGlow();
    expect(librarySubgraphs(project(editor))).toEqual(['glow']);
    expect(editor.ui.getState().toasts.at(-1)?.text).toBe('Saved “Glow” to the library of this project.');
    expect(addFromLibrary(editor, 'graph/glow', PLACE)).not.toBeNull();
    expect(typesOf(editor)).toEqual(['graph/glow', 'graph/glow']);
  });

  test('says which names are invalid', async () => {
    const editor = await withGlow();
    selectOnly(editor.selection, Object.keys(graphOf(editor.document.getState()).nodes));
    createSubgraph(editor);
    expect(titleProblem(project(editor), 'subgraph', 'Glow')).toMatch(/already has a subgraph of this name/);
    expect(titleProblem(project(editor), 'glow', 'Glow')).toBeNull();
    expect(titleProblem(project(editor), 'glow', '7')).toMatch(/must begin with a letter/);
  });

  test('says what uses a subgraph, in which graph', async () => {
    const editor = await withGlow();
    expect(usesInWords(project(editor), 'glow')).toBe('1 node in the main graph');
    selectOnly(editor.selection, Object.keys(graphOf(editor.document.getState()).nodes));
    createSubgraph(editor);
    addFromLibrary(editor, 'graph/glow', PLACE);
    addFromLibrary(editor, 'graph/glow', PLACE);
    expect(usesInWords(project(editor), 'glow')).toBe('2 nodes in the main graph and 1 node in “Subgraph”');
  });

  test('lets one go that is used in several graphs, itself open: all are unpacked, in one step', async () => {
    const editor = await withGlow();
    selectOnly(editor.selection, Object.keys(graphOf(editor.document.getState()).nodes));
    createSubgraph(editor);
    addFromLibrary(editor, 'graph/glow', PLACE);
    openSubgraph(editor, 'glow');
    const before = filesOf(editor);
    expect(removeFromLibrary(editor, 'glow')).toBe(true);
    expect(editor.document.getState().graph).toBe('main');
    expect(librarySubgraphs(project(editor))).toEqual(['subgraph']);
    const types = Object.values(project(editor).graphs).flatMap(({ nodes }) => Object.values(nodes).map(({ type }) => type));
    expect(types.sort()).toEqual(['filter/sepia', 'filter/sepia', 'graph/subgraph']);
    undo(editor);
    expect(filesOf(editor)).toEqual(before);
  });
});
