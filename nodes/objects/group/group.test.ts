import { expect, test } from '@jest/globals';
import { Matrix4, Object3D } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { ObjectList } from '../../kit/scene-lists.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function list(...names: string[]): ObjectList {
  const items = names.map((name) => {
    const root = new Object3D();
    root.name = name;
    return { key: name, root, worldFromObject: new Matrix4(), role: 'virtual' as const, castsShadow: true, receivesShadow: true };
  });
  return { version: 1, items };
}

test('holds the objects of all wires in their order', () => {
  const { ctx } = fakeContext(definition, { inputs: { objects: [list('b', 'a'), list('c')] } });
  const node = create(ctx);
  node.update({} as never);
  expect(ctx.outputs.objects.items.map(({ root }) => root.name)).toEqual(['b', 'a', 'c']);
  node.dispose();
});
