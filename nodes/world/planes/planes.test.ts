import { describe, expect, test } from '@jest/globals';
import { BufferGeometry, DoubleSide, type Material, Mesh, Vector3 } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { ParamValue } from '../../kit/definition.ts';
import type { DetectedPlane, SessionFrame } from '../../kit/session.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

type Plane = { -readonly [K in keyof DetectedPlane]: DetectedPlane[K] };

/** A quarter turn about z: the normal points along -x, as that of a wall on the right. */
const WALL = Float32Array.of(0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 2, 1, 0, 1);
const FLOOR = Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);

function plane(id: string, outlineXZ: readonly number[], more: Partial<Plane> = {}): Plane {
  return {
    id,
    version: 0,
    label: '',
    worldFromSurface: FLOOR,
    orientation: 'horizontal',
    outlineXZ: Float32Array.from(outlineXZ),
    ...more,
  };
}

const SQUARE = [-1, -1, 1, -1, 1, 1, -1, 1];

function make(params: Record<string, ParamValue> = {}) {
  const { ctx, set } = fakeContext(definition, { params });
  const node = create(ctx);
  const { objects } = ctx.outputs;
  const see = (...planes: Plane[]): void => node.update({ surfaces: { planes, meshes: [] } } as unknown as SessionFrame);
  return { node, objects, see, set };
}

/** Area of the triangles, and the sum of their normals by area, in world space. */
function measure({ items }: ReturnType<typeof make>['objects'], i = 0) {
  const item = items[i];
  const geometry = item?.root instanceof Mesh && item.root.geometry instanceof BufferGeometry ? item.root.geometry : null;
  const { position } = geometry?.attributes ?? {};
  const index = geometry?.index;
  if (!item || !position || !index) throw new Error('There is no such object.');
  const corner = (at: number) => new Vector3().fromBufferAttribute(position, index.getX(at)).applyMatrix4(item.worldFromObject);
  const normal = new Vector3();
  let area = 0;
  for (let at = 0; at < index.count; at += 3) {
    const cross = corner(at + 1)
      .sub(corner(at))
      .cross(corner(at + 2).sub(corner(at)));
    area += cross.length() / 2;
    normal.add(cross);
  }
  return { area, normal: normal.normalize().toArray().map(Math.round) };
}

/** The shadows on them are proved in `tests/slow/real-surfaces.test.ts`. */
describe('world/planes', () => {
  test('makes each plane a phantom whose triangles face its normal, whichever way its outline turns, and that both sides show', () => {
    const { objects, see } = make();
    see(
      plane('a', SQUARE),
      plane('b', [-1, 1, 1, 1, 1, -1, -1, -1]),
      plane('c', SQUARE, { worldFromSurface: WALL, orientation: 'vertical' }),
    );
    expect(objects.items.map(({ key, role, castsShadow, receivesShadow }) => [key, role, castsShadow, receivesShadow])).toEqual(
      ['a', 'b', 'c'].map((key) => [key, 'phantom', false, true]),
    );
    expect([0, 1, 2].map((i) => measure(objects, i))).toEqual([
      { area: 4, normal: [0, 1, 0] },
      { area: 4, normal: [0, 1, 0] },
      { area: 4, normal: [-1, 0, 0] },
    ]);
    expect(objects.items.map(({ root }) => (root as Mesh<BufferGeometry, Material>).material.side)).toEqual([
      DoubleSide,
      DoubleSide,
      DoubleSide,
    ]);
  });

  test('fills exactly an outline that is not convex', () => {
    const { objects, see } = make();
    see(plane('an L', [0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2]), plane('a line', [0, 0, 1, 1]));
    expect([objects.items.length, measure(objects).area]).toEqual([1, expect.closeTo(3, 6)]);
  });

  test('follows added, moved, changed and removed planes; only changes of shape rebuild anything', () => {
    const { node, objects, see } = make();
    const floor = plane('floor', SQUARE);
    see(floor);
    const [first] = objects.items;
    let freed = 0;
    const geometry = first?.root instanceof Mesh ? first.root.geometry : null;
    geometry?.addEventListener('dispose', () => freed++);
    const made = objects.version;
    floor.worldFromSurface = Float32Array.from(FLOOR);
    floor.worldFromSurface[13] = 0.25;
    see(floor);
    expect([objects.version, objects.items[0] === first, first?.worldFromObject.elements[13], freed]).toEqual([made, true, 0.25, 0]);
    floor.outlineXZ = Float32Array.of(-2, -2, 2, -2, 2, 2, -2, 2);
    floor.version++;
    see(floor);
    expect([objects.version > made, measure(objects).area, freed]).toEqual([true, 16, 1]);
    see();
    expect(objects.items).toEqual([]);
    node.update({} as SessionFrame);
    expect(objects.items).toEqual([]);
    node.dispose();
  });

  test('takes level or upright ones alone, and its switches hold for those that are there', () => {
    const { objects, see, set } = make({ which: 'vertical' });
    const planes = [
      plane('floor', SQUARE),
      plane('wall', SQUARE, { orientation: 'vertical' }),
      plane('roof', SQUARE, { orientation: 'other' }),
    ];
    see(...planes);
    expect(objects.items.map(({ key }) => key)).toEqual(['wall']);
    set('castShadow', true);
    set('receiveShadow', false);
    see(...planes);
    expect(objects.items[0]).toMatchObject({ castsShadow: true, receivesShadow: false });
  });
});
