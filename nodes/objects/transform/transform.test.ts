import { describe, expect, test } from '@jest/globals';
import { Matrix4, Object3D, Vector3 } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { ObjectList } from '../../kit/scene-lists.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

type Params = NonNullable<Parameters<typeof fakeContext<typeof definition>>[1]>['params'];

function listAt(x: number, y: number, z: number): ObjectList {
  const worldFromObject = new Matrix4().makeTranslation(x, y, z);
  return {
    version: 1,
    items: [{ key: 'a', root: new Object3D(), worldFromObject, role: 'virtual', castsShadow: true, receivesShadow: true }],
  };
}

/** Where a point of an object that stands at (1, 0, 0) comes to be. */
function place(point: readonly [number, number, number], params: Params): number[] {
  const { ctx } = fakeContext(definition, { params: params ?? {}, inputs: { objects: [listAt(1, 0, 0)] } });
  create(ctx).update({} as never);
  const [item] = ctx.outputs.objects.items;
  return new Vector3(...point)
    .applyMatrix4(item?.worldFromObject ?? new Matrix4())
    .toArray()
    .map((x) => Math.round(x * 1e9) / 1e9 + 0);
}

const QUARTER = Math.PI / 2;

describe('objects/transform', () => {
  test.each<[string, Params, number[]]>([
    ['leaves things where they are by default', {}, [2, 0, 0]],
    ['moves in meters', { positionM: [0, 2, -3] }, [2, 2, -3]],
    ['sizes about the origin, together with where things stand', { scale: 0.5 }, [1, 0, 0]],
    ['turns to the left about y', { rotationRad: [0, QUARTER, 0] }, [0, 0, -2]],
    ['sizes and turns before it moves', { scale: 2, rotationRad: [0, QUARTER, 0], positionM: [1, 0, 0] }, [1, 0, -4]],
    ['rolls about z before it heads about y', { rotationRad: [0, QUARTER, QUARTER] }, [0, 2, 0]],
    ['rolls about z before it tilts about x', { rotationRad: [QUARTER, 0, QUARTER] }, [0, 0, 2]],
    ['tilts about x before it heads about y', { rotationRad: [QUARTER, QUARTER, QUARTER] }, [2, 0, 0]],
  ])('%s', (_what, params, expected) => {
    expect(place([1, 0, 0], params)).toEqual(expected);
  });

  test('follows its params without a new list', () => {
    const { ctx, set } = fakeContext(definition, { inputs: { objects: [listAt(0, 0, 0)] } });
    const node = create(ctx);
    node.update({} as never);
    const { version, items } = ctx.outputs.objects;
    set('positionM', [0, 1, 0]);
    node.update({} as never);
    expect(ctx.outputs.objects.version).toBe(version);
    expect(items[0]?.worldFromObject.elements[13]).toBe(1);
  });
});
