import { expect, test } from '@jest/globals';
import { openTestEditor } from '../../tests/support/test-editor.ts';
import { addNodeFromPalette, connect } from './edit-graph.ts';
import type { Editor } from './editor.ts';
import { compareSelected, createLayerPictures, layerName, layerTitle, lookAtNothing, lookedAt, pinSelected } from './looks.ts';
import { selectOnly } from './selection.ts';
import { makeSubgraph, openSubgraph } from './subgraphs.ts';

function add(editor: Editor, type: string): string {
  const definition = editor.document.getState().library.definition(type);
  const id = definition && addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null);
  if (!id) throw new Error(`${type} was not added.`);
  return id;
}

test('a layer in a subgraph is called as the compiler calls it, by the way to it', async () => {
  const { editor } = await openTestEditor();
  const sepia = add(editor, 'filter/sepia');
  expect(makeSubgraph(editor)).toBe(true);
  const [outer] = editor.selection.getState().nodes;
  openSubgraph(editor, 'subgraph');
  expect(layerName(editor.document.getState(), sepia, 'layer')).toBe(`${outer}/${sepia}.layer`);
  expect(layerTitle(editor.document.getState(), `${outer}/${sepia}.layer`)).toBe('Sepia');
  expect(layerTitle(editor.document.getState(), null)).toBe('Screen');
});

test('what is looked at is kept by the program: pins, both sides of a wipe, pictures on nodes, and the screen’s layer for a probe', async () => {
  const { editor } = await openTestEditor();
  const video = add(editor, 'source/camera-video');
  const sepia = add(editor, 'filter/sepia');
  const screen = add(editor, 'output/screen');
  connect(editor, { node: sepia, port: 'layer' }, { node: screen, port: 'layer' });
  expect(lookedAt(editor)).toEqual([]);
  selectOnly(editor.selection, [video]);
  pinSelected(editor);
  selectOnly(editor.selection, [sepia]);
  compareSelected(editor);
  expect(editor.look.getState()).toMatchObject({ left: `${video}.layer`, right: `${sepia}.layer`, split: 0.5 });
  expect(lookedAt(editor)).toEqual([`${sepia}.layer`, `${video}.layer`].sort());
  lookAtNothing(editor.look);
  editor.look.setState({ probing: true });
  expect(lookedAt(editor)).toEqual([`${sepia}.layer`]);
  lookAtNothing(editor.look);
  const stop = editor.pictures.layers.watch('x.layer', () => {});
  expect(lookedAt(editor)).toEqual(['x.layer']);
  stop();
  expect(lookedAt(editor)).toEqual([]);
  // What gives no layer cannot be shown, and says so.
  selectOnly(editor.selection, [screen]);
  pinSelected(editor);
  expect(editor.look.getState().left).toBeNull();
  expect(editor.ui.getState().toasts).toHaveLength(1);
});

test('a picture that nobody waits for any more is closed', () => {
  const pictures = createLayerPictures();
  let closed = 0;
  const picture = { close: () => closed++ } as unknown as ImageBitmap;
  const seen: ImageBitmap[] = [];
  const stop = pictures.watch('a', (next) => void seen.push(next));
  pictures.deliver('a', picture);
  stop();
  pictures.deliver('a', picture);
  expect([seen.length, closed]).toEqual([1, 1]);
});
