import { expect, test } from '@jest/globals';
import { loadProject } from '../../../export/graph/load.ts';
import { projectText } from '../../../tests/support/project-kit.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { undo } from '../document/apply.ts';
import { graphOf, nodeOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { filesOf } from '../files/files.ts';
import { connect } from './edit-graph.ts';

type Nodes = Parameters<typeof projectText>[0]['nodes'];

async function open(nodes: Nodes, wires: readonly string[] = []): Promise<Editor> {
  const { output } = loadProject({ project: projectText({ nodes, wires }), layout: null, sources: {} });
  if (!output) throw new Error('The project is not read.');
  return (await openTestEditor(output)).editor;
}

const wiresOf = (editor: Editor) => {
  const typeOf = (id: string) => nodeOf(editor.document.getState(), id)?.type.split('/')[1];
  return graphOf(editor.document.getState())
    .wires.map(({ from, to }) => `${typeOf(from.node)} > ${typeOf(to.node)}.${to.port}`)
    .sort();
};

const SCENE = ['layer/scene', { encoding: 'scene' }] as const;

test('a wire from a scene layer to the screen gets a Tone map, and one undo takes both away', async () => {
  const editor = await open({ 'scene-0000': SCENE, 'screen-0000': 'output/screen' });
  const before = filesOf(editor);
  connect(editor, { node: 'scene-0000', port: 'layer' }, { node: 'screen-0000', port: 'layer' });
  expect(wiresOf(editor)).toEqual(['scene > tone-map.inputImage', 'tone-map > screen.layer']);
  undo(editor);
  expect(filesOf(editor)).toEqual(before);
});

test('the camera under a scene layer gets To scene', async () => {
  const nodes = {
    'scene-0000': SCENE,
    'over-0000': 'operator/over',
    'map-0000': 'filter/tone-map',
    'video-0000': 'source/camera-video',
    'screen-0000': 'output/screen',
  } as const;
  const editor = await open(nodes, [
    'scene-0000.layer -> over-0000.top',
    'over-0000.layer -> map-0000.inputImage',
    'map-0000.layer -> screen-0000.layer',
  ]);
  connect(editor, { node: 'video-0000', port: 'layer' }, { node: 'over-0000', port: 'bottom' });
  expect(wiresOf(editor)).toEqual([
    'camera-video > to-scene.inputImage',
    'over > tone-map.inputImage',
    'scene > over.top',
    'to-scene > over.bottom',
    'tone-map > screen.layer',
  ]);
});
