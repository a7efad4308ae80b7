import { describe, expect, test } from '@jest/globals';
import { compile } from '../../export/compiler/compile.ts';
import { describeProgram } from '../../export/compiler/describe.ts';
import { loadProject } from '../../export/graph/load.ts';
import { LIBRARY } from '../support/library.ts';
import { projectText } from '../support/project-kit.ts';

type Nodes = Parameters<typeof projectText>[0]['nodes'];

function compiled(nodes: Nodes, wires: readonly string[]): ReturnType<typeof compile> {
  const box = {
    'box-0000': 'objects/primitive',
    'scene-0000': ['layer/scene', { encoding: 'scene' }],
    'screen-0000': 'output/screen',
  } as const;
  const project = projectText({ nodes: { ...box, ...nodes }, wires: ['box-0000.objects -> scene-0000.objects', ...wires] });
  const loaded = loadProject({ project, layout: null, sources: {} });
  if (!loaded.output) throw new Error(JSON.stringify(loaded.diagnostics));
  return compile({ project: loaded.output, library: LIBRARY });
}

describe('layers of different encodings', () => {
  test('are refused at an input that shows display layers, with the remedy', () => {
    const { output, diagnostics } = compiled({}, ['scene-0000.layer -> screen-0000.layer']);
    expect(output).toBeNull();
    expect(diagnostics).toEqual([
      {
        code: 'SCR048',
        severity: 'error',
        nodeId: 'screen-0000',
        port: 'layer',
        message: 'Input “Layer” of screen-0000 needs a display layer, but scene-0000.layer is a scene layer.',
        fix: 'Insert “Tone map” into the wire.',
      },
    ]);
  });

  test('are refused in a composite, at the second', () => {
    const { diagnostics } = compiled({ 'video-0000': 'source/camera-video', 'over-0000': 'operator/over', 'map-0000': 'filter/tone-map' }, [
      'scene-0000.layer -> over-0000.top',
      'video-0000.layer -> over-0000.bottom',
      'over-0000.layer -> map-0000.inputImage',
      'map-0000.layer -> screen-0000.layer',
    ]);
    expect(diagnostics).toMatchObject([{ code: 'SCR048', nodeId: 'over-0000', port: 'bottom', fix: 'Insert “To scene” into the wire.' }]);
  });

  test('are converted by nodes, and scene layers have twice the bytes', () => {
    const { output, diagnostics } = compiled({ 'blur-0000': 'filter/gaussian-blur', 'map-0000': 'filter/tone-map' }, [
      'scene-0000.layer -> blur-0000.inputImage',
      'blur-0000.layer -> map-0000.inputImage',
      'map-0000.layer -> screen-0000.layer',
    ]);
    expect(diagnostics).toEqual([]);
    if (!output) throw new Error('It was not compiled.');
    const formats = output.resources.flatMap((resource) => (resource.kind === 'target' ? [`${resource.id} ${resource.format}`] : []));
    expect(formats.sort()).toEqual(['blur-0000.across rgba16f', 'blur-0000.layer scene16f', 'scene-0000.layer scene16f']);
    expect(describeProgram(output)).toContain('blur-0000.layer: 1920×1080, scene16f, 15.8 MiB');
  });
});
