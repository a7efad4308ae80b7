import { expect, test } from '@jest/globals';
import { BoxGeometry, ConeGeometry, CylinderGeometry, PlaneGeometry, SphereGeometry, TorusGeometry } from 'three';
import { programUse } from '../../export/bundle/program-use.ts';
import { hasBorder } from '../../export/runtime/scenes/materials/edges/simplify.ts';
import { weldTriangles } from '../../export/runtime/scenes/volumes/mesh-shape.ts';
import { compileText } from '../support/compile-project.ts';
import { projectText } from '../support/project-kit.ts';

type Nodes = Parameters<typeof projectText>[0]['nodes'];

/** Which edges a project draws that applies a technique to the output of `made-a`, through a transform. */
function edgesDrawn(technique: string, nodes: Nodes, others: readonly string[] = []): string {
  const text = projectText({
    nodes: {
      'technique-a': technique,
      'move-a': 'objects/transform',
      'styled-a': 'objects/apply-technique',
      'light-a': 'light/directional',
      'scene-a': 'layer/scene',
      'screen-a': 'output/screen',
      ...nodes,
    },
    wires: [
      'made-a.objects -> move-a.objects',
      'move-a.objects -> styled-a.objects',
      'technique-a.technique -> styled-a.technique',
      'styled-a.objects -> scene-a.objects',
      'light-a.lights -> scene-a.lights',
      'scene-a.layer -> screen-a.layer',
      ...others,
    ],
    assets: { robot: { path: 'robot.glb', kind: 'model' } },
  });
  return programUse(compileText(text)).techniqueEdges;
}

const MODEL = { 'made-a': ['source/model', { model: 'robot' }] } as const;

test('a page of closed shapes and models with Toon or Gooch draws edges of open models only', () => {
  expect(edgesDrawn('technique/toon', MODEL)).toBe('of open models');
  expect(edgesDrawn('technique/gooch', { 'made-a': ['objects/primitive', { shape: 'torus' }] })).toBe('of open models');
  expect(edgesDrawn('technique/toon', { 'made-a': ['objects/primitive', { shape: 'plane' }] })).toBe('all');
  expect(edgesDrawn('technique/toon', { 'made-a': ['objects/text-3d', { text: 'a' }] })).toBe('all');
  expect(edgesDrawn('technique/loose-lines', MODEL)).toBe('all');
  expect(edgesDrawn('technique/charcoal', MODEL)).toBe('none');
});

test('an open shape that no technique draws does not matter', () => {
  const plane: Nodes = { ...MODEL, 'plane-a': ['objects/primitive', { shape: 'plane' }] };
  expect(edgesDrawn('technique/toon', plane, ['plane-a.objects -> scene-a.objects'])).toBe('of open models');
  expect(edgesDrawn('technique/toon', plane, ['plane-a.objects -> styled-a.objects'])).toBe('all');
});

test.each([
  ['box', new BoxGeometry(1, 1, 1), false],
  ['sphere', new SphereGeometry(0.5, 48, 32), false],
  ['plane', new PlaneGeometry(1, 1), true],
  ['cylinder', new CylinderGeometry(0.5, 0.5, 1, 64), false],
  ['cone', new ConeGeometry(0.5, 1, 64), false],
  ['torus', new TorusGeometry(0.4, 0.1, 24, 64), false],
])('the runtime finds a border of a %s where the export does', (_, geometry, expected) => {
  const { triangles, vertices } = weldTriangles(geometry, () => true);
  expect(hasBorder(triangles, vertices.length)).toBe(expected);
});
