import { expect, test } from '@jest/globals';
import { Matrix4, Object3D } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { ObjectList } from '../../kit/scene-lists.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test('marks objects as phantoms, and only on its own wire', () => {
  const source: ObjectList = {
    version: 1,
    items: [{ key: 'a', root: new Object3D(), worldFromObject: new Matrix4(), role: 'virtual', castsShadow: true, receivesShadow: false }],
  };
  const { ctx, set } = fakeContext(definition, { inputs: { objects: [source] } });
  const node = create(ctx);
  node.update({} as never);
  const [phantom] = ctx.outputs.objects.items;
  expect(phantom).toMatchObject({ role: 'phantom', castsShadow: false, receivesShadow: true });
  set('castShadow', true);
  set('receiveShadow', false);
  node.update({} as never);
  expect(phantom).toMatchObject({ role: 'phantom', castsShadow: true, receivesShadow: false });
  expect(source.items[0]).toMatchObject({ role: 'virtual', castsShadow: true, receivesShadow: false });
});
