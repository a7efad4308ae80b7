import { describe, expect, test } from '@jest/globals';
import { Bone, BoxGeometry, InstancedMesh, Matrix4, Mesh, MeshBasicMaterial, Object3D, Skeleton, SkinnedMesh, Vector3 } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { ObjectItem, ObjectList } from '../../kit/scene-lists.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

type Params = NonNullable<NonNullable<Parameters<typeof fakeContext<typeof definition>>[1]>['params']>;

function listOf(root: Object3D, ...at: readonly [number, number, number]): ObjectList {
  root.updateMatrixWorld(true);
  const worldFromObject = new Matrix4().makeTranslation(...at);
  return { version: 1, items: [{ key: 'a', root, worldFromObject, role: 'virtual', castsShadow: true, receivesShadow: true }] };
}

const box = (): Mesh => new Mesh(new BoxGeometry(), new MeshBasicMaterial());

/** Where copies of a point of the object come to be, whichever way they are drawn. */
function placesOf(items: readonly ObjectItem[], point = new Vector3()): number[][] {
  const matrix = new Matrix4();
  const round = (place: Vector3): number[] => place.toArray().map((x) => Math.round(x * 1e4) / 1e4 + 0);
  return items.flatMap((item) => {
    const [instances] = item.root.children;
    if (!(instances instanceof InstancedMesh)) return [round(point.clone().applyMatrix4(item.worldFromObject))];
    return Array.from({ length: instances.count }, (_, i) => {
      instances.getMatrixAt(i, matrix);
      return round(point.clone().applyMatrix4(matrix).applyMatrix4(instances.matrixWorld).applyMatrix4(item.worldFromObject));
    });
  });
}

function play(params: Params, list: ObjectList = listOf(box(), 1, 0, 0)) {
  const fake = fakeContext(definition, { params, inputs: { objects: [list] } });
  const node = create(fake.ctx);
  const update = (): void => node.update({} as never);
  update();
  return { ...fake, node, update, list, out: fake.ctx.outputs.objects };
}

const QUARTER = Math.PI / 2;

describe('objects/copies', () => {
  test.each<[string, Params, number[][]]>([
    [
      'in a row, begin where the object is',
      { count: 3, stepM: [0, 0, -1] },
      [
        [1, 0, 0],
        [1, 0, -1],
        [1, 0, -2],
      ],
    ],
    [
      'in a row, are turned ever farther',
      { count: 2, stepM: [0, 2, 0], turnRad: QUARTER },
      [
        [1, 0, 0],
        [0, 2, -1],
      ],
    ],
    [
      'in a grid, stand around the origin, row by row',
      { pattern: 'grid', count: 3, stepM: [2, 9, 4] },
      [
        [0, 0, -2],
        [2, 0, -2],
        [0, 0, 2],
      ],
    ],
    [
      'in a ring, face outwards',
      { pattern: 'ring', count: 4, radiusM: 2 },
      [
        [1, 0, 2],
        [2, 0, -1],
        [-1, 0, -2],
        [-2, 0, 1],
      ],
    ],
    ['may be none', { count: 0 }, []],
  ])('%s', (_what, params, expected) => {
    expect(placesOf(play(params).out.items)).toEqual(expected);
  });

  test('are scattered over the disc, apart from each other, and alike for the same number', () => {
    const params: Params = { pattern: 'scatter', count: 60, radiusM: 3, sizeSpread: 0.5, seed: 4 };
    const scatter = (more: Params): number[][] => placesOf(play({ ...params, ...more }, listOf(box(), 0, 0, 0)).out.items);
    const places = scatter({});
    const away = places.map(([x = 0, , z = 0]) => Math.hypot(x, z));
    expect(Math.max(...away)).toBeLessThanOrEqual(3);
    // Half of an even disc lies beyond 0.71 of its radius.
    expect(away.filter((r) => r > 3 * Math.SQRT1_2).length).toBeGreaterThan(25);
    expect(new Set(places.map(String)).size).toBe(60);
    expect(scatter({})).toEqual(places);
    expect(scatter({ seed: 5 })).not.toEqual(places);
    const tops = placesOf(play(params, listOf(box(), 0, 0, 0)).out.items, new Vector3(0, 1, 0)).map(([, y = 0]) => y);
    expect(Math.min(...tops)).toBeGreaterThanOrEqual(0.5);
    expect(Math.max(...tops)).toBeLessThanOrEqual(1.5);
    expect(Math.max(...tops) - Math.min(...tops)).toBeGreaterThan(0.7);
  });

  test('are instances of one mesh each, which share geometry and textures', () => {
    const model = new Object3D();
    const [left, right] = [box(), box()];
    right.position.set(0, 1, 0);
    model.add(left, new Object3D().add(right));
    const { out } = play({ count: 500 }, listOf(model, 0, 0, 0));
    expect(out.items).toHaveLength(1);
    const instances = out.items[0]?.root.children as InstancedMesh[];
    expect(instances.map(({ count, geometry, material }) => [count, geometry, material])).toEqual([
      [500, left.geometry, left.material],
      [500, right.geometry, right.material],
    ]);
    const matrix = new Matrix4();
    instances[1]?.getMatrixAt(2, matrix);
    expect(new Vector3().setFromMatrixPosition(matrix).toArray()).toEqual([1, 1, 1]);
  });

  test('are separate items for skinned and transparent objects', () => {
    const skinned = new SkinnedMesh(new BoxGeometry(), new MeshBasicMaterial());
    const bone = new Bone();
    skinned.add(bone);
    skinned.bind(new Skeleton([bone]));
    const { out } = play({ count: 3 }, listOf(skinned, 0, 0, 0));
    expect(out.items.map(({ root }) => root)).toEqual([skinned, skinned, skinned]);
    expect(new Set(out.items.map(({ key }) => key)).size).toBe(3);

    const mesh = box();
    const { out: later, update } = play({ count: 3 }, listOf(mesh, 0, 0, 0));
    expect(later.items).toHaveLength(1);
    const { version } = later;
    (mesh.material as MeshBasicMaterial).transparent = true;
    update();
    expect([later.items.length, later.version > version]).toEqual([3, true]);
    expect(placesOf(later.items)).toEqual([
      [0, 0, 0],
      [0.5, 0, 0.5],
      [1, 0, 1],
    ]);
  });

  test('follow their object and params without a new list, and upload only changed matrices', () => {
    const { out, set, update, list } = play({ count: 2, stepM: [1, 0, 0] });
    const instances = out.items[0]?.root.children[0] as InstancedMesh;
    const { version } = out;
    const uploads = instances.instanceMatrix.version;
    update();
    expect(instances.instanceMatrix.version).toBe(uploads);
    list.items[0]?.worldFromObject.makeTranslation(0, 5, 0);
    set('stepM', [3, 0, 0]);
    update();
    expect(instances.instanceMatrix.version).toBe(uploads + 1);
    expect(placesOf(out.items)).toEqual([
      [0, 5, 0],
      [3, 5, 0],
    ]);
    expect(instances.boundingSphere?.center.toArray()).toEqual([1.5, 5, 0]);
    expect(out.version).toBe(version);
    set('count', 3);
    update();
    expect([placesOf(out.items).length, out.version]).toEqual([3, version + 1]);
  });
});
