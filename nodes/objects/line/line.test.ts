import { describe, expect, test } from '@jest/globals';
import { Box3, type Mesh, type MeshBasicMaterial, Vector3 } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { createPose, writePose } from '../../kit/pose.ts';
import { setFromAngles } from '../../kit/rigid.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function start() {
  const poses = { from: createPose(), to: createPose() };
  const { ctx, set } = fakeContext(definition, { params: { widthM: 0.02 }, inputs: poses });
  const node = create(ctx);
  const list = ctx.outputs.objects;
  const matrix = new Float32Array(16);
  const put = (name: 'from' | 'to', at: readonly number[] | null) => {
    if (at) setFromAngles(matrix, at, [1, 2, 3]);
    writePose(poses[name], at && matrix, 0);
  };
  /** Center and size of its box in world space; null without a line. */
  const seen = () => {
    node.update({} as never);
    const [item] = list.items;
    if (!item) return null;
    const { geometry } = item.root as Mesh;
    const box = new Box3().setFromBufferAttribute(geometry.getAttribute('position') as never).applyMatrix4(item.worldFromObject);
    const round = (v: Vector3) => v.toArray().map((x) => Math.round(x * 1e4) / 1e4 + 0);
    return [round(box.getCenter(new Vector3())), round(box.getSize(new Vector3()))];
  };
  const line = () => {
    const [item] = list.items;
    if (!item) throw new Error('There is no line.');
    const { geometry, material } = item.root as Mesh;
    return { item, geometry, material: material as MeshBasicMaterial };
  };
  return { node, list, put, seen, set, line };
}

describe('objects/line', () => {
  test.each([
    ['along x', [3, 1, 2], [2, 1, 2], [2, 0.02, 0.02]],
    ['along z', [1, 1, -2], [1, 1, 0], [0.02, 0.02, 4]],
    ['up', [1, 2, 2], [1, 1.5, 2], [0.02, 1, 0.02]],
    ['down', [1, 0, 2], [1, 0.5, 2], [0.02, 1, 0.02]],
  ])('reaches from pose to pose in its width: %s', (_name, to, center, size) => {
    const { put, seen } = start();
    put('from', [1, 1, 2]);
    put('to', to);
    expect(seen()).toEqual([center, size]);
  });

  test('is not there while a pose is invalid, between poses at one position, and without a width', () => {
    const { list, put, seen, set } = start();
    expect(seen()).toBe(null);
    put('from', [1, 1, 2]);
    expect(seen()).toBe(null);
    put('to', [1, 1, 2]);
    expect(seen()).toBe(null);
    put('to', [1, 1, 3]);
    expect(seen()).not.toBe(null);
    const { version } = list;
    put('to', [1, 1, 4]);
    seen();
    // A line that moves is the same object.
    expect(list.version).toBe(version);
    put('from', null);
    expect([seen(), list.version]).toEqual([null, version + 1]);
    put('from', [1, 1, 2]);
    set('widthM', 0);
    expect(seen()).toBe(null);
  });

  test('has its color, which is sRGB, and is transparent with alpha', () => {
    const { put, seen, set, line } = start();
    put('from', [0, 0, 0]);
    put('to', [1, 0, 0]);
    set('color', [0.5, 1, 0, 0.25]);
    set('castShadow', true);
    seen();
    const { item, material } = line();
    // IEC 61966-2-1: ((0.5 + 0.055) / 1.055) ^ 2.4.
    expect(material.color.r).toBeCloseTo(0.21404, 5);
    expect([material.opacity, material.transparent, item.castsShadow]).toEqual([0.25, true, true]);
  });

  test('releases its geometry and material', () => {
    const { node, put, seen, line } = start();
    put('from', [0, 0, 0]);
    put('to', [1, 0, 0]);
    seen();
    const { geometry, material } = line();
    let released = 0;
    for (const each of [geometry, material]) each.addEventListener('dispose', () => released++);
    node.dispose();
    expect(released).toBe(2);
  });
});
