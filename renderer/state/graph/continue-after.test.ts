import { expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { graphOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { continuationOf } from './continue-after.ts';
import { addNodeFromPalette } from './edit-graph.ts';
import { startFilter } from './first-steps.ts';

function definitionOf(editor: Editor, type: string) {
  const definition = editor.document.getState().library.definition(type);
  if (!definition) throw new Error(`There is no node type ${type}.`);
  return definition;
}

function idOf(editor: Editor, type: string): string {
  const { nodes } = graphOf(editor.document.getState());
  return Object.keys(nodes).find((id) => nodes[id]?.type === type) ?? '';
}

test('a filter after the camera goes into its wire, and after an unconnected image is connected to it', async () => {
  const { editor } = await openTestEditor();
  startFilter(editor, { x: 0, y: 0 });
  const halftone = definitionOf(editor, 'filter/halftone');
  expect(continuationOf(editor, idOf(editor, 'source/camera-video'), halftone)).toMatchObject({
    wire: expect.stringMatching(/^camera-video-\w+\.layer -> screen-\w+\.layer$/),
  });
  const image =
    addNodeFromPalette(editor, { definition: definitionOf(editor, 'source/image-file'), port: null }, { x: 0, y: 400 }, null) ?? '';
  expect(continuationOf(editor, image, halftone)).toMatchObject({
    end: { node: image, port: 'layer', side: 'output' },
    port: 'inputImage',
    place: { y: 400 },
  });
});

test('nodes that no output fits stay unconnected: a light after the camera, a filter after a number, anything after the output', async () => {
  const { editor } = await openTestEditor();
  startFilter(editor, { x: 0, y: 0 });
  const camera = idOf(editor, 'source/camera-video');
  expect(continuationOf(editor, camera, definitionOf(editor, 'light/directional'))).toBeNull();
  // The layer of a Scene is optional: it is shown behind glass.
  expect(continuationOf(editor, camera, definitionOf(editor, 'layer/scene'))).toBeNull();
  expect(continuationOf(editor, idOf(editor, 'output/screen'), definitionOf(editor, 'filter/halftone'))).toBeNull();
  const time = addNodeFromPalette(editor, { definition: definitionOf(editor, 'value/time'), port: null }, { x: 0, y: 400 }, null) ?? '';
  expect(continuationOf(editor, time, definitionOf(editor, 'filter/halftone'))).toBeNull();
});
