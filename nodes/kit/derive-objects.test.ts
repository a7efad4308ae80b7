import { describe, expect, test } from '@jest/globals';
import { Matrix4, Object3D } from 'three';
import { deriveObjects } from './derive-objects.ts';
import type { ObjectItem, ObjectList } from './scene-lists.ts';

function list(...keys: string[]): ObjectList {
  return { version: 1, items: keys.map(item) };
}

function item(key: string): ObjectItem {
  return { key, root: new Object3D(), worldFromObject: new Matrix4(), role: 'virtual', castsShadow: true, receivesShadow: true };
}

describe('deriveObjects', () => {
  test('concatenates lists in order, with unique keys', () => {
    const output: ObjectList = { version: 0, items: [] };
    const twice = list('a', 'b');
    const once = list('c');
    deriveObjects(output, () => {}).update([twice, once, twice]);
    const roots = (...lists: ObjectList[]): Object3D[] => lists.flatMap(({ items }) => items.map(({ root }) => root));
    expect(roots(output)).toEqual(roots(twice, once, twice));
    expect(new Set(output.items.map(({ key }) => key)).size).toBe(5);
  });

  test('increases its version exactly when items are added or removed', () => {
    const output: ObjectList = { version: 0, items: [] };
    const source = list('a');
    const derived = deriveObjects(output, () => {});
    const versions: number[] = [];
    const step = (inputs: ObjectList[]): number => {
      derived.update(inputs);
      return versions.push(output.version);
    };
    step([source]);
    step([source]);
    source.items.push(item('b'));
    source.version++;
    step([source]);
    step([source, list('c')]);
    step([]);
    expect(versions).toEqual([1, 1, 2, 3, 4]);
    expect(output.items).toEqual([]);
  });

  test('follows matrices and flags every frame, and does not change its sources', () => {
    const output: ObjectList = { version: 0, items: [] };
    const source = list('a');
    const [from] = source.items;
    const derived = deriveObjects(output, (adjusted) => {
      adjusted.worldFromObject.elements[12] += 1;
    });
    derived.update([source]);
    from?.worldFromObject.setPosition(5, 0, 0);
    if (from) from.castsShadow = false;
    derived.update([source]);
    derived.update([source]);
    const [to] = output.items;
    expect([to?.worldFromObject.elements[12], to?.castsShadow]).toEqual([6, false]);
    expect(from?.worldFromObject.elements[12]).toBe(5);
  });
});
