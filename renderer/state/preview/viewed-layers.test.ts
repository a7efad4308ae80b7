import { expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import type { Editor } from '../editor/editor.ts';
import { layerName, layerTitle } from '../editor/layer-names.ts';
import { selectOnly } from '../editor/selection.ts';
import { createThumbnailWatchers, resetViewer } from '../editor/viewer.ts';
import { addNodeFromPalette, connect } from '../graph/edit-graph.ts';
import { createSubgraph, openSubgraph } from '../graph/subgraphs.ts';
import { compareSelected, pinSelected, viewedLayers } from './viewed-layers.ts';

function add(editor: Editor, type: string): string {
  const definition = editor.document.getState().library.definition(type);
  const id = definition && addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null);
  if (!id) throw new Error(`${type} was not added.`);
  return id;
}

test('a layer in a subgraph is called as the compiler calls it, by the way to it', async () => {
  const { editor } = await openTestEditor();
  const sepia = add(editor, 'filter/sepia');
  expect(createSubgraph(editor)).toBe(true);
  const [outer] = editor.selection.getState().nodes;
  openSubgraph(editor, 'subgraph');
  expect(layerName(editor.document.getState(), sepia, 'layer')).toBe(`${outer}/${sepia}.layer`);
  expect(layerTitle(editor.document.getState(), `${outer}/${sepia}.layer`)).toBe('Sepia');
  expect(layerTitle(editor.document.getState(), null)).toBe('Output');
});

test('what is looked at is kept by the program: pins, both sides of a wipe, pictures on nodes, and the screen’s layer for a probe', async () => {
  const { editor } = await openTestEditor();
  const video = add(editor, 'source/camera-video');
  const sepia = add(editor, 'filter/sepia');
  const screen = add(editor, 'output/screen');
  connect(editor, { node: sepia, port: 'layer' }, { node: screen, port: 'layer' });
  expect(viewedLayers(editor)).toEqual([]);
  selectOnly(editor.selection, [video]);
  pinSelected(editor);
  selectOnly(editor.selection, [sepia]);
  compareSelected(editor);
  expect(editor.viewer.getState()).toMatchObject({ left: `${video}.layer`, right: `${sepia}.layer`, split: 0.5 });
  expect(viewedLayers(editor)).toEqual([`${sepia}.layer`, `${video}.layer`].sort());
  resetViewer(editor.viewer);
  editor.viewer.setState({ probing: true });
  expect(viewedLayers(editor)).toEqual([`${sepia}.layer`]);
  resetViewer(editor.viewer);
  expect(viewedLayers(editor)).toEqual([]);
  const stop = editor.thumbnails.watch('x.layer', () => {});
  expect(editor.thumbnails.wanted()).toEqual(['x.layer']);
  stop();
  expect(editor.thumbnails.wanted()).toEqual([]);
  // What gives no layer cannot be shown, and says so.
  selectOnly(editor.selection, [screen]);
  pinSelected(editor);
  expect(editor.viewer.getState().left).toBeNull();
  expect(editor.ui.getState().toasts).toHaveLength(1);
});

test('a picture that nobody waits for any more is closed', () => {
  const pictures = createThumbnailWatchers();
  let closed = 0;
  const picture = { close: () => closed++ } as unknown as ImageBitmap;
  const seen: ImageBitmap[] = [];
  const stop = pictures.watch('a', (next) => void seen.push(next));
  pictures.deliver('a', picture);
  stop();
  pictures.deliver('a', picture);
  expect([seen.length, closed]).toEqual([1, 1]);
});
