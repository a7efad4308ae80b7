import { describe, expect, test } from '@jest/globals';
import { Box3, type Mesh, type MeshStandardMaterial, Vector3 } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { ParamValue } from '../../kit/definition.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

const SHAPES = definition.params.shape.options.map(({ value }) => value);

function make(params: Record<string, ParamValue>) {
  const { ctx, set } = fakeContext(definition, { params });
  const node = create(ctx);
  node.update({} as never);
  const [item] = ctx.outputs.objects.items;
  if (!item) throw new Error('no object');
  const mesh = item.root as Mesh;
  return { node, item, mesh, material: mesh.material as MeshStandardMaterial, set, list: ctx.outputs.objects };
}

describe('objects/primitive', () => {
  test.each(SHAPES)('a %s fills its size around the origin', (shape) => {
    const { mesh } = make({ shape, sizeM: [2, 1, 0.5] });
    const size = new Box3().setFromBufferAttribute(mesh.geometry.getAttribute('position') as never).applyMatrix4(mesh.matrixWorld);
    const height = { plane: 0, torus: 0.2 }[shape as string] ?? 1;
    const round = (v: Vector3): number[] => v.toArray().map((x) => Math.round(x * 1e4) / 1e4 + 0);
    expect(round(size.getSize(new Vector3()))).toEqual([2, height, 0.5]);
    expect(round(size.getCenter(new Vector3()))).toEqual([0, 0, 0]);
  });

  test('colors are sRGB and light is linear', () => {
    const { material } = make({ color: [0.5, 1, 0, 1] });
    // IEC 61966-2-1: ((0.5 + 0.055) / 1.055) ^ 2.4.
    expect(material.color.r).toBeCloseTo(0.21404, 5);
    expect([material.color.g, material.color.b, material.transparent]).toEqual([1, 0, false]);
  });

  test('every uniform param applies without a new object', () => {
    const { node, item, mesh, material, set, list } = make({});
    const { version } = list;
    set('color', [1, 1, 1, 0.25]);
    set('roughness', 0.1);
    set('metalness', 1);
    set('sizeM', [3, 3, 3]);
    set('castShadow', false);
    node.update({} as never);
    expect([material.transparent, material.opacity, material.roughness, material.metalness]).toEqual([true, 0.25, 0.1, 1]);
    expect([item.root, item.castsShadow, list.version]).toEqual([mesh, false, version]);
    expect(mesh.matrixWorld.elements[0]).toBe(3);
  });

  test('a plane faces up and shows both sides', () => {
    const { mesh } = make({ shape: 'plane' });
    expect(new Vector3().fromBufferAttribute(mesh.geometry.getAttribute('normal') as never, 0).y).toBeCloseTo(1, 12);
    expect(make({ shape: 'plane' }).material.side).not.toBe(make({ shape: 'box' }).material.side);
  });

  test('disposes its resources', () => {
    const { node, mesh, material } = make({});
    const freed: string[] = [];
    mesh.geometry.addEventListener('dispose', () => freed.push('geometry'));
    material.addEventListener('dispose', () => freed.push('material'));
    node.dispose();
    expect(freed).toEqual(['geometry', 'material']);
  });
});
