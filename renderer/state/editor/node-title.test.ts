import { expect, test } from '@jest/globals';
import { newProject } from '../../../export/graph/new-project.ts';
import type { Project } from '../../../export/graph/project.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { createCanvasProjection } from '../../canvas/project-canvas.ts';
import { duplicateSelection } from '../clipboard/clipboard.ts';
import { historySteps } from '../document/apply.ts';
import { diagnosticWithTitles, withTitles } from '../document/message-titles.ts';
import { listAssets, namesOfUses } from '../files/asset-rows.ts';
import { addAssetToGraph } from '../files/edit-assets.ts';
import { findNodes } from '../graph/find.ts';
import { graphOf, layoutOf, titleOf } from './document.ts';
import type { Editor } from './editor.ts';
import { layerTitle } from './layer-names.ts';
import { selectOnly } from './selection.ts';

const EXPOSED = { inputs: [], outputs: [] };
const PROJECT: Project = {
  ...newProject('Test'),
  graphs: {
    main: {
      nodes: {
        'file-aaaa': { type: 'source/image-file', version: 1, params: { file: { value: 'cup' } } },
        'blur-aaaa': { type: 'filter/gaussian-blur', version: 1, params: {} },
        'look-aaaa': { type: 'graph/soft-look', version: 1, params: {} },
      },
      wires: [],
      exposed: EXPOSED,
    },
    'soft-look': { nodes: {}, wires: [], exposed: EXPOSED },
  },
  assets: {
    cup: { path: 'assets/cup.png', kind: 'image' },
    hall: { path: 'assets/hall.capture/capture.json', kind: 'capture' },
  },
};

/** The name that each place of the editor gives a node. */
function namesOf(editor: Editor, id: string): Readonly<Record<string, string | undefined>> {
  const state = editor.document.getState();
  const { nodes } = createCanvasProjection()({
    graph: graphOf(state),
    layout: layoutOf(state),
    library: state.library,
    assets: state.project.assets,
    selectedNodes: new Set(),
    selectedWires: new Set(),
    expanded: new Set(),
    dragged: {},
    problems: new Map(),
  });
  const diagnostic = { code: 'SCR015', severity: 'error', message: `${id} is alone.`, fix: `Connect ${id}.` } as const;
  const { message, fix } = diagnosticWithTitles(state, diagnostic);
  selectOnly(editor.selection, [id]);
  duplicateSelection(editor);
  const step = historySteps(editor.document.getState().history).at(-1);
  return {
    head: nodes.find((node) => node.id === id)?.data.title,
    inspector: titleOf(state, id),
    history: step?.label.replace('Duplicate ', ''),
    diagnostic: message.replace(' is alone.', ''),
    fix: fix?.replace(/^Connect (.*)\.$/, '$1'),
    place: withTitles(state, id),
    found: findNodes(state, id).find(({ node }) => node === id)?.title,
    layer: layerTitle(state, `${id}.layer`),
  };
}

test.each([
  ['file-aaaa', 'cup.png'],
  ['blur-aaaa', 'Gaussian blur'],
  ['look-aaaa', 'Soft look'],
])('%s is called %s everywhere', async (id, name) => {
  const { editor } = await openTestEditor(PROJECT);
  const names = namesOf(editor, id);
  expect(names).toEqual(Object.fromEntries(Object.keys(names).map((place) => [place, name])));
});

test('an asset lists the nodes that use it by their names, and a node found by its type is listed by its name', async () => {
  const { editor } = await openTestEditor(PROJECT);
  const cup = listAssets(editor.document.getState()).rows.find(({ id }) => id === 'cup');
  expect(namesOfUses(editor.document.getState(), cup?.uses ?? [])).toEqual(['cup.png']);
  expect(findNodes(editor.document.getState(), 'image').map(({ title }) => title)).toEqual(['cup.png']);
});

test('the step that adds a node from an asset has the name of the node', async () => {
  const { editor } = await openTestEditor(PROJECT);
  const id = (await addAssetToGraph(editor, 'hall', { x: 0, y: 900 })) ?? '';
  expect(titleOf(editor.document.getState(), id)).toBe('hall');
  expect(historySteps(editor.document.getState().history).at(-1)?.label).toBe('Add hall');
});
