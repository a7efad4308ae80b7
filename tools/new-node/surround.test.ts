import { describe, expect, test } from '@jest/globals';
import type { Project } from '../../export/graph/project.ts';
import { validateProject } from '../../export/graph/validate/validate.ts';
import { printWire } from '../../export/graph/wires.ts';
import { type InputPort, libraryOf, type NodeDefinition, type OutputPort } from '../../nodes/kit/definition.ts';
import type { WireType } from '../../nodes/kit/wire-types.ts';
import { surround } from './surround.ts';

function input(type: WireType, required = true): InputPort {
  return { type, label: type, doc: type, required };
}

function output(type: WireType): OutputPort {
  return type === 'layer' ? { type, label: type, doc: type, domain: 'view', depth: false } : { type, label: type, doc: type };
}

function node(
  type: string,
  inputs: Record<string, InputPort>,
  outputs: Record<string, OutputPort>,
  more: Partial<NodeDefinition> = {},
): NodeDefinition {
  return { type, version: 1, title: type, doc: type, inputs, outputs, params: {}, lowering: { kind: 'source' }, ...more };
}

const NODES = [
  node('objects/box', {}, { objects: output('objects') }),
  node('objects/turn', { objects: input('objects') }, { objects: output('objects') }),
  node('layer/scene', { objects: input('objects'), lights: input('lights', false) }, { layer: output('layer') }),
  node(
    'source/camera',
    {},
    { layer: output('layer') },
    {
      needs: [{ capability: 'camera-image', required: false, when: 'always', why: 'to see', without: 'black' }],
    },
  ),
  node('source/file', {}, { layer: output('layer') }),
  node(
    'filter/tint',
    { inputImage: input('layer') },
    { layer: output('layer') },
    {
      params: { amount: { type: 'number', stage: 'uniform', label: 'A', doc: 'A.', default: 0 } },
    },
  ),
  node('value/time', {}, { time: output('number') }),
  node('output/screen', { layer: input('layer') }, {}, { lowering: { kind: 'present' } }),
];

const LIBRARY = libraryOf(NODES, {});

function wires(project: Project): string[] {
  return project.graphs.main?.wires.map(printWire) ?? [];
}

describe('the smallest project around a node', () => {
  test.each(NODES.map(({ type }) => type))('the project around %s has no problems', (type) => {
    expect(validateProject(surround(LIBRARY, type, 'Try'), LIBRARY)).toEqual([]);
  });

  test('a filter is connected to the cheapest source and to the output', () => {
    expect(wires(surround(LIBRARY, 'filter/tint', 'Try'))).toEqual([
      'tint-x1.layer -> screen-x1.layer',
      'file-x1.layer -> tint-x1.inputImage',
    ]);
  });

  test('a number is connected to a param of a visible node', () => {
    expect(wires(surround(LIBRARY, 'value/time', 'Try'))).toContain('time-x1.time -> tint-x1.amount');
  });

  test('optional inputs are not connected', () => {
    const { graphs } = surround(LIBRARY, 'objects/turn', 'Try');
    expect(Object.keys(graphs.main?.nodes ?? {})).toEqual(['turn-x1', 'box-x1', 'scene-x1', 'screen-x1']);
  });

  test('without a chain to the output the node is alone', () => {
    const alone = libraryOf(
      NODES.filter(({ type }) => type === 'objects/box'),
      {},
    );
    expect(surround(alone, 'objects/box', 'Try').graphs.main).toMatchObject({ nodes: { 'box-x1': { type: 'objects/box' } }, wires: [] });
  });
});
