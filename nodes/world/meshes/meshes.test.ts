import { expect, test } from '@jest/globals';
import { Mesh } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { DetectedMesh, SessionFrame } from '../../kit/session.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

type Scan = { -readonly [K in keyof DetectedMesh]: DetectedMesh[K] };

function scan(id: string, more: Partial<Scan> = {}): Scan {
  return {
    id,
    version: 0,
    label: 'couch',
    worldFromSurface: Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 0, 0, 1),
    positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0),
    indices: Uint32Array.of(0, 1, 2),
    ...more,
  };
}

/** The shadows on them are proved in `tests/slow/real-surfaces.test.ts`. */
test('makes scanned shapes phantoms where they stand, anew when they change, and none of what has no triangle', () => {
  const { ctx, set } = fakeContext(definition);
  const node = create(ctx);
  const { objects } = ctx.outputs;
  const couch = scan('couch');
  const see = (): void => {
    const meshes = [couch, scan('dust', { indices: new Uint32Array(0) })];
    node.update({ surfaces: { planes: [], meshes } } as unknown as SessionFrame);
  };
  see();
  expect(objects.items).toHaveLength(1);
  const [item] = objects.items;
  const geometryOf = (root: unknown) => (root as Mesh).geometry;
  expect([item?.role, item?.root instanceof Mesh, item?.worldFromObject.elements[12]]).toEqual(['phantom', true, 3]);
  expect([...(geometryOf(item?.root).index?.array ?? [])]).toEqual([0, 1, 2]);
  let freed = 0;
  geometryOf(item?.root).addEventListener('dispose', () => freed++);
  set('castShadow', true);
  see();
  expect([objects.items[0] === item, item?.castsShadow, freed]).toEqual([true, true, 0]);
  couch.positions = Float32Array.of(0, 0, 0, 2, 0, 0, 0, 2, 0);
  couch.version++;
  see();
  expect([geometryOf(objects.items[0]?.root).attributes.position?.getX(1), freed]).toEqual([2, 1]);
  node.dispose();
});
