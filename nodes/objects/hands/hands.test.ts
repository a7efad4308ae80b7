import { describe, expect, test } from '@jest/globals';
import { Box3, type BufferAttribute, Line3, Matrix4, type Mesh, type MeshStandardMaterial, type SkinnedMesh, Vector3 } from 'three';
import { createSessionInput } from '../../../export/runtime/sessions/input/session-input.ts';
import { captureHand } from '../../../tests/support/captured-hand.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { ParamValue } from '../../kit/definition.ts';
import { HAND_JOINTS, jointIndex } from '../../kit/hand-joints.ts';
import type { ObjectList } from '../../kit/scene-lists.ts';
import { definition } from './definition.ts';
import { BONES } from './hand-geometry.ts';
import { create } from './runtime.ts';

function start(params: Record<string, ParamValue> = {}) {
  const { ctx, set } = fakeContext(definition, { params });
  const node = create(ctx);
  const input = createSessionInput();
  const list = ctx.outputs.objects;
  const keys = () => {
    node.update({ input } as never);
    return list.items.map(({ key }) => key);
  };
  return { node, input, list, keys, set };
}

/** The skin of the hand as it is drawn, in world space, triangle by triangle. */
function skinOf(pose: Parameters<typeof captureHand>[0], side: 'left' | 'right' = 'left') {
  const { input, list, keys } = start();
  const hand = captureHand(pose, 0, side === 'left' ? input.leftHand : input.rightHand);
  // A right hand is the mirror image of a left one: positions, and axes of joints, whose x keeps them right-handed.
  if (side === 'right') {
    for (let i = 0; i < HAND_JOINTS.length; i++) {
      for (const k of [1, 2, 4, 8, 12]) hand.worldFromJoints[16 * i + k] = -(hand.worldFromJoints[16 * i + k] ?? 0);
    }
  }
  keys();
  const [item] = list.items;
  if (!item) throw new Error('There is no hand.');
  const mesh = item.root as SkinnedMesh;
  mesh.skeleton.update();
  const position = mesh.geometry.getAttribute('position');
  const points = Array.from({ length: position.count }, (_, i) =>
    mesh.applyBoneTransform(i, new Vector3().fromBufferAttribute(position as BufferAttribute, i)).applyMatrix4(item.worldFromObject),
  );
  const index = mesh.geometry.getIndex()?.array ?? [];
  const triangles = Array.from({ length: index.length / 3 }, (_, i) =>
    [0, 1, 2].map((k) => points[index[3 * i + k] ?? 0] ?? new Vector3()),
  ) as [Vector3, Vector3, Vector3][];
  const jointAt = (joint: number) => new Vector3().fromArray(hand.worldFromJoints, 16 * joint + 12);
  return { hand, mesh, triangles, jointAt };
}

/** Meters from a point to a line segment. */
function distanceTo(point: Vector3, a: Vector3, b: Vector3): number {
  return new Line3(a, b).closestPointToPoint(point, true, new Vector3()).distanceTo(point);
}

const TRIANGLES_PER_BONE = 12 * (2 + 7 * 2);

describe('the skin of a hand', () => {
  test.each([
    ['relaxed', 'left'],
    ['pinch', 'left'],
    ['fist', 'left'],
    ['relaxed', 'right'],
    ['fist', 'right'],
  ] as const)('of a %s %s hand lies around its bones at the radii of the joints, and faces outward', (pose, side) => {
    const { hand, triangles, jointAt } = skinOf(pose, side);
    BONES.forEach(([from, to], bone) => {
      const [a, b] = [jointAt(from), jointAt(to)];
      const radii = [hand.radiiM[from] ?? 0, hand.radiiM[to] ?? 0];
      let [volume, least, most] = [0, Number.POSITIVE_INFINITY, 0];
      for (const [p, q, r] of triangles.slice(bone * TRIANGLES_PER_BONE, (bone + 1) * TRIANGLES_PER_BONE)) {
        for (const corner of [p, q, r]) {
          const distance = distanceTo(corner, a, b);
          least = Math.min(least, distance);
          most = Math.max(most, distance);
        }
        volume += p.dot(q.clone().cross(r)) / 6;
      }
      expect(most).toBeLessThan(Math.max(...radii) * 1.001);
      // The sphere of a thick joint contains part of a thin one that is near.
      expect(least).toBeGreaterThan(Math.min(...radii) * 0.85);
      const length = a.distanceTo(b);
      // Of a cone's stump with the ends of both spheres; twelve sides have 0.955 of a circle.
      const [r0 = 0, r1 = 0] = radii;
      const expected = (Math.PI * length * (r0 * r0 + r0 * r1 + r1 * r1)) / 3 + (2 * Math.PI * (r0 ** 3 + r1 ** 3)) / 3;
      expect(volume / expected).toBeGreaterThan(0.88);
      expect(volume / expected).toBeLessThan(1);
    });
    // Plates of the palm: closed, and outward as a whole.
    for (let at = BONES.length * TRIANGLES_PER_BONE; at < triangles.length; at += 12) {
      let volume = 0;
      for (const [p, q, r] of triangles.slice(at, at + 12)) volume += p.dot(q.clone().cross(r)) / 6;
      // In this fist the index and middle finger are at the same place, and nothing is between them.
      expect(volume).toBeGreaterThan(pose === 'fist' ? -1e-12 : 1e-7);
    }
  });

  test('is closed: every edge belongs to two triangles in opposite directions', () => {
    const { mesh } = skinOf('relaxed');
    const index = [...(mesh.geometry.getIndex()?.array ?? [])];
    const edges = new Map<string, number>();
    for (let i = 0; i < index.length; i += 3) {
      for (let k = 0; k < 3; k++) {
        const [a = 0, b = 0] = [index[i + k], index[i + ((k + 1) % 3)]];
        edges.set(`${a}>${b}`, (edges.get(`${a}>${b}`) ?? 0) + 1);
      }
    }
    const open = [...edges].filter(([edge, count]) => count !== 1 || edges.get(edge.split('>').reverse().join('>')) !== 1);
    expect(open).toEqual([]);
  });
});

function firstOf({ items: [item] }: ObjectList) {
  if (!item) throw new Error('There is no object.');
  return { item, material: (item.root as Mesh).material as MeshStandardMaterial };
}

describe('objects/hands', () => {
  const GRIP = Float32Array.from(new Matrix4().makeRotationY(1).setPosition(1, 2, 3).elements);

  test('lists what is tracked, and keeps its list while the same is', () => {
    const { input, list, keys } = start();
    expect([keys(), list.version]).toEqual([[], 0]);
    captureHand('relaxed', 0, input.leftHand);
    input.right.worldFromGrip = GRIP;
    expect(keys()).toEqual(['left-hand', 'right-controller']);
    const { version } = list;
    captureHand('pinch', 1, input.leftHand);
    expect([keys(), list.version]).toEqual([['left-hand', 'right-controller'], version]);
    expect([...(list.items[1]?.worldFromObject.elements ?? [])]).toEqual([...GRIP]);
    input.leftHand.tracked = false;
    expect([keys(), list.version]).toEqual([['right-controller'], version + 1]);
    // A bare hand that the browser lists as a controller holds none.
    input.right.bare = true;
    expect(keys()).toEqual([]);
  });

  test.each<[Record<string, ParamValue>, string[]]>([
    [{ show: 'hands' }, ['left-hand', 'right-hand']],
    [{ show: 'controllers', side: 'left' }, ['left-controller']],
    [{ side: 'right' }, ['right-hand', 'right-controller']],
  ])('shows what its params say: %j', (params, expected) => {
    const { input, keys } = start(params);
    captureHand('relaxed', 0, input.leftHand);
    captureHand('relaxed', 0, input.rightHand);
    input.left.worldFromGrip = GRIP;
    input.right.worldFromGrip = GRIP;
    expect(keys()).toEqual(expected);
  });

  test('is at the wrist, so that later transforms turn about it', () => {
    const { input, list, keys } = start();
    captureHand('relaxed', 4, input.leftHand);
    keys();
    expect(list.items[0]?.worldFromObject.elements).toEqual([...input.leftHand.worldFromJoints.slice(16 * jointIndex('wrist'), 16)]);
  });

  test('a controller is as large as one that is held', () => {
    const { input, list, keys } = start();
    input.left.worldFromGrip = GRIP;
    keys();
    const size = new Box3().setFromObject(list.items[0]?.root as Mesh).getSize(new Vector3());
    expect([size.x > 0.03 && size.x < 0.08, size.y > 0.03 && size.y < 0.1, size.z > 0.1 && size.z < 0.18]).toEqual([true, true, true]);
  });

  test('has its color and shadows', () => {
    const { input, list, keys, set } = start();
    captureHand('relaxed', 0, input.leftHand);
    set('color', [0.5, 1, 0, 0.5]);
    set('castShadow', false);
    keys();
    const { item, material } = firstOf(list);
    expect([material.transparent, material.opacity, item.castsShadow, item.receivesShadow]).toEqual([true, 0.5, false, true]);
    expect(material.color.r).toBeCloseTo(0.21404, 5);
  });

  test('releases what it made', () => {
    const { node, input, list, keys } = start();
    captureHand('relaxed', 0, input.leftHand);
    input.right.worldFromGrip = GRIP;
    keys();
    let released = 0;
    for (const { root } of list.items) {
      root.traverse((object) => (object as Partial<Mesh>).geometry?.addEventListener('dispose', () => released++));
    }
    firstOf(list).material.addEventListener('dispose', () => released++);
    node.dispose();
    // A hand, a handle, a head with a stick and two buttons, a trigger, and the material of all.
    expect(released).toBe(1 + 6 + 1);
  });
});
