import { describe, expect, test } from '@jest/globals';
import { LIBRARY } from '../../tests/support/library.ts';
import { projectText } from '../../tests/support/project-kit.ts';
import { convertLayers, misfittingWires } from './commands/convert-layers.ts';
import { createEncodingLookup } from './encoding-lookup.ts';
import { loadProject } from './load.ts';
import type { Project } from './project.ts';
import { printWire } from './wires.ts';

const SCENE = ['layer/scene', { encoding: 'scene' }] as const;

function project(nodes: Parameters<typeof projectText>[0]['nodes'], wires: readonly string[]): Project {
  const { output, diagnostics } = loadProject({ project: projectText({ nodes, wires }), layout: null, sources: {} });
  if (!output) throw new Error(JSON.stringify(diagnostics));
  return output;
}

const wiresOf = (made: Project): string[] => (made.graphs.main?.wires ?? []).map(printWire).sort();
const makeId = (before: Project, type: string): string => `${type.split('/')[1]}-${Object.keys(before.graphs.main?.nodes ?? {}).length}000`;
const convert = (made: Project, first: Project['graphs'][string]['wires'] = []): Project =>
  convertLayers(made, { library: LIBRARY, graph: 'main', first, except: [], makeId }).project;

describe('the encoding of a layer', () => {
  test('is that of the Scene, and stays through filters for either', () => {
    const made = project({ 'scene-0000': SCENE, 'blur-0000': 'filter/gaussian-blur', 'sepia-0000': 'filter/sepia' }, [
      'scene-0000.layer -> blur-0000.inputImage',
      'blur-0000.layer -> sepia-0000.inputImage',
    ]);
    const lookup = createEncodingLookup(made, LIBRARY, 'main');
    expect(['scene-0000', 'blur-0000', 'sepia-0000'].map((node) => lookup.outputOf({ node, port: 'layer' }))).toEqual([
      'scene',
      'scene',
      'display',
    ]);
    expect(misfittingWires(made, LIBRARY, 'main').map(printWire)).toEqual(['blur-0000.layer -> sepia-0000.inputImage']);
  });

  test('of a display Scene is as it always was', () => {
    const made = project({ 'scene-0000': 'layer/scene', 'blur-0000': 'filter/gaussian-blur', 'screen-0000': 'output/screen' }, [
      'scene-0000.layer -> blur-0000.inputImage',
      'blur-0000.layer -> screen-0000.layer',
    ]);
    expect(createEncodingLookup(made, LIBRARY, 'main').outputOf({ node: 'blur-0000', port: 'layer' })).toBe('display');
    expect(convert(made)).toBe(made);
  });
});

describe('converting', () => {
  test('puts a Tone map before what shows display layers', () => {
    const made = convert(
      project({ 'scene-0000': SCENE, 'blur-0000': 'filter/gaussian-blur', 'screen-0000': 'output/screen' }, [
        'scene-0000.layer -> blur-0000.inputImage',
        'blur-0000.layer -> screen-0000.layer',
      ]),
    );
    expect(wiresOf(made)).toEqual([
      'blur-0000.layer -> tone-map-3000.inputImage',
      'scene-0000.layer -> blur-0000.inputImage',
      'tone-map-3000.layer -> screen-0000.layer',
    ]);
  });

  test('of two layers converts the one that was connected last', () => {
    const nodes = { 'scene-0000': SCENE, 'video-0000': 'source/camera-video', 'over-0000': 'operator/over' };
    const wires = ['scene-0000.layer -> over-0000.top', 'video-0000.layer -> over-0000.bottom'];
    const made = project(nodes, wires);
    const [top, bottom] = ['top', 'bottom'].map((port) => made.graphs.main?.wires.find(({ to }) => to.port === port));
    if (!top || !bottom) throw new Error('There are two wires.');
    expect(wiresOf(convert(made, [top]))).toContain('scene-0000.layer -> tone-map-3000.inputImage');
    expect(wiresOf(convert(made, [bottom]))).toContain('video-0000.layer -> to-scene-3000.inputImage');
  });
});
