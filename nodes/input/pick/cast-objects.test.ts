import { describe, expect, test } from '@jest/globals';
import {
  AnimationClip,
  AnimationMixer,
  BackSide,
  Bone,
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  CylinderGeometry,
  DoubleSide,
  Float32BufferAttribute,
  Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  PlaneGeometry,
  Quaternion,
  QuaternionKeyframeTrack,
  Raycaster,
  Skeleton,
  SkinnedMesh,
  Sphere,
  SphereGeometry,
  TorusKnotGeometry,
  Uint16BufferAttribute,
  Vector3,
} from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import { createRandom } from '../../../export/runtime/random.ts';
import type { ObjectItem } from '../../kit/scene-lists.ts';
import { castAtObjects, createObjectHit } from './cast-objects.ts';
import { trianglesOf } from './geometry-triangles.ts';
import { buildTriangleTree, castAtTree } from './triangle-tree.ts';

const MATERIAL = new MeshBasicMaterial();

function itemOf(root: Object3D, key = 'a', worldFromObject = new Matrix4()): ObjectItem {
  root.updateMatrixWorld(true);
  return { key, root, worldFromObject, role: 'virtual', castsShadow: true, receivesShadow: true };
}

function rayFrom(origin: Vector3, towards: Vector3): number[] {
  return new Matrix4().lookAt(origin, towards, new Vector3(0.013, 1, 0.007)).setPosition(origin).elements;
}

function cast(worldFromRay: ArrayLike<number>, ...items: readonly ObjectItem[]) {
  const hit = createObjectHit();
  castAtObjects(hit, worldFromRay, [{ version: 1, items: [...items] }]);
  return hit;
}

/** What the raycaster of three.js meets, with the object moved instead of the ray. */
function castByThree(worldFromRay: ArrayLike<number>, root: Object3D, worldFromObject: Matrix4) {
  const matrix = new Matrix4().fromArray([...(worldFromRay as number[])]);
  const caster = new Raycaster(
    new Vector3().setFromMatrixPosition(matrix),
    new Vector3().setFromMatrixColumn(matrix, 2).negate().normalize(),
  );
  const parent = new Group().add(root);
  parent.matrixAutoUpdate = false;
  parent.matrix.copy(worldFromObject);
  parent.updateMatrixWorld(true);
  const [hit] = caster.intersectObject(root, true);
  parent.remove(root);
  root.updateMatrixWorld(true);
  return hit ?? null;
}

/** Rays from around a place towards points near it, of which about half meet what is there. */
function* rays(count: number, salt: string, center: Vector3, radius: number): Generator<number[]> {
  const random = createRandom(1, salt);
  const spread = (size: number) => new Vector3(random.next() - 0.5, random.next() - 0.5, random.next() - 0.5).multiplyScalar(2 * size);
  for (let i = 0; i < count; i++) {
    const from = spread(1)
      .normalize()
      .multiplyScalar(4 * radius)
      .add(center);
    yield rayFrom(from, spread(radius).add(center));
  }
}

/** A bent tube with two bones, whose upper one an animation turns. */
function arm(): { readonly mesh: SkinnedMesh; pose(timeS: number): void } {
  const geometry = new CylinderGeometry(0.1, 0.1, 1, 12, 20).translate(0, 0.5, 0);
  const { position } = geometry.attributes;
  const indices: number[] = [];
  const weights: number[] = [];
  for (let i = 0; i < (position?.count ?? 0); i++) {
    const upper = Math.min(Math.max(((position?.getY(i) ?? 0) - 0.3) / 0.4, 0), 1);
    indices.push(0, 1, 0, 0);
    weights.push(1 - upper, upper, 0, 0);
  }
  geometry.setAttribute('skinIndex', new Uint16BufferAttribute(indices, 4));
  geometry.setAttribute('skinWeight', new Float32BufferAttribute(weights, 4));
  const [root, elbow] = [new Bone(), new Bone()];
  elbow.name = 'elbow';
  elbow.position.y = 0.5;
  root.add(elbow);
  const mesh = new SkinnedMesh(geometry, new MeshBasicMaterial({ side: DoubleSide }));
  mesh.add(root);
  mesh.position.set(0.3, 0, 0);
  mesh.updateMatrixWorld(true);
  mesh.bind(new Skeleton([root, elbow]));
  const turn = new Quaternion().setFromAxisAngle(new Vector3(0, 0, 1), -2);
  const clip = new AnimationClip('bend', 1, [new QuaternionKeyframeTrack('elbow.quaternion', [0, 1], [0, 0, 0, 1, ...turn.toArray()])]);
  const mixer = new AnimationMixer(mesh);
  mixer.clipAction(clip).play();
  return {
    mesh,
    pose: (timeS) => {
      mixer.setTime(timeS);
      mesh.updateMatrixWorld(true);
    },
  };
}

describe('a ray meets', () => {
  test('the triangle that three-mesh-bvh finds, in a knot of 8,192 triangles', () => {
    const geometry = new TorusKnotGeometry(1, 0.35, 256, 16);
    const bvh = new MeshBVH(geometry.clone());
    const tree = trianglesOf(geometry)?.tree;
    if (!tree) throw new Error('The knot has no triangles.');
    let met = 0;
    for (const worldFromRay of rays(400, 'knot', new Vector3(), 1.5)) {
      const matrix = new Matrix4().fromArray(worldFromRay);
      const origin = new Vector3().setFromMatrixPosition(matrix);
      const ahead = new Vector3().setFromMatrixColumn(matrix, 2).negate();
      const caster = new Raycaster(origin, ahead);
      const theirs = bvh.raycastFirst(caster.ray, DoubleSide);
      const ours = { along: Number.POSITIVE_INFINITY, nx: 0, ny: 0, nz: 0 };
      const isMet = castAtTree(ours, tree, { ox: origin.x, oy: origin.y, oz: origin.z, dx: ahead.x, dy: ahead.y, dz: ahead.z }, 0);
      expect(isMet).toBe(theirs !== null);
      if (!theirs) continue;
      met++;
      expect(ours.along).toBeCloseTo(theirs.distance, 6);
      const normal = new Vector3(ours.nx, ours.ny, ours.nz).normalize();
      expect(normal.dot(theirs.face?.normal ?? normal)).toBeCloseTo(1, 4);
    }
    expect(met).toBeGreaterThan(100);
  });

  test.each([
    [
      'placed, turned and stretched',
      new Matrix4()
        .makeRotationX(0.7)
        .scale(new Vector3(2, 0.5, -1))
        .setPosition(3, 1, -2),
    ],
    ['far away', new Matrix4().makeTranslation(1000, 0, -1000)],
  ])('what three.js meets, in a subtree of parts, %s', (_, worldFromObject) => {
    const root = new Group();
    const part = new Mesh(new SphereGeometry(0.5, 24, 16), MATERIAL);
    part.position.set(0.6, 0, 0);
    part.scale.set(1, 2, 0.5);
    root.add(new Mesh(new BoxGeometry(), MATERIAL), part);
    const item = itemOf(root, 'a', worldFromObject);
    let met = 0;
    for (const ray of rays(300, 'parts', new Vector3().setFromMatrixPosition(worldFromObject), 1.5)) {
      const ours = cast(ray, item);
      const theirs = castByThree(ray, root, worldFromObject);
      expect(ours.item !== null).toBe(theirs !== null);
      if (!theirs) continue;
      met++;
      expect([ours.mesh, ours.distanceM]).toEqual([theirs.object, expect.closeTo(theirs.distance, 3)]);
    }
    expect(met).toBeGreaterThan(50);
  });

  test('a skinned mesh as it is posed in this frame, as three.js does', () => {
    const { mesh, pose } = arm();
    const worldFromObject = new Matrix4().makeRotationY(1).setPosition(0, 1, 0);
    const item = itemOf(mesh, 'arm', worldFromObject);
    for (const timeS of [0, 0.4, 0.99]) {
      pose(timeS);
      let met = 0;
      for (const ray of rays(200, `arm ${timeS}`, new Vector3(0.2, 1.5, -0.2), 0.7)) {
        const ours = cast(ray, item);
        const theirs = castByThree(ray, mesh, worldFromObject);
        expect(ours.item !== null).toBe(theirs !== null);
        if (theirs) expect(ours.distanceM).toBeCloseTo(theirs.distance, 4);
        met += theirs ? 1 : 0;
      }
      expect(met).toBeGreaterThan(10);
    }
  });

  test('a morphed mesh where its targets move it', () => {
    const geometry = new PlaneGeometry(1, 1, 8, 8);
    const raised = geometry.attributes.position?.clone() as BufferAttribute;
    for (let i = 0; i < raised.count; i++) raised.setZ(i, 2);
    geometry.morphAttributes.position = [raised];
    const mesh = new Mesh(geometry, MATERIAL);
    mesh.morphTargetInfluences = [0.5];
    const ray = rayFrom(new Vector3(0.1, 0.2, 5), new Vector3(0.1, 0.2, 0));
    expect(cast(ray, itemOf(mesh)).distanceM).toBeCloseTo(4, 6);
    mesh.morphTargetInfluences[0] = 1;
    expect(cast(ray, itemOf(mesh)).distanceM).toBeCloseTo(3, 6);
  });

  test('each copy of an instanced mesh alone', () => {
    const copies = new InstancedMesh(new BoxGeometry(0.2, 0.2, 0.2), MATERIAL, 50);
    for (let i = 0; i < 50; i++) copies.setMatrixAt(i, new Matrix4().makeRotationZ(i).setPosition(i, 0, -i));
    const item = itemOf(copies, 'a', new Matrix4().makeTranslation(0, 2, 0));
    const hit = cast(rayFrom(new Vector3(31, 2, 5), new Vector3(31, 2, -31)), item);
    expect([hit.copy, hit.distanceM]).toEqual([31, expect.closeTo(35.9, 5)]);
    expect(cast(rayFrom(new Vector3(31.5, 2, 5), new Vector3(31.5, 2, -31)), item).item).toBe(null);
    copies.count = 20;
    expect(cast(rayFrom(new Vector3(31, 2, 5), new Vector3(31, 2, -31)), item).item).toBe(null);
  });

  test('the nearest of several, on the sides that the material shows, and nothing invisible', () => {
    const plane = (z: number, material = MATERIAL) => {
      const mesh = new Mesh(new PlaneGeometry(), material);
      mesh.position.z = z;
      return mesh;
    };
    const ray = rayFrom(new Vector3(0.1, 0.1, 5), new Vector3(0.1, 0.1, 0));
    const [near, far] = [itemOf(plane(1), 'near'), itemOf(plane(0), 'far')];
    expect([cast(ray, near, far).item, cast(ray, far, near).item]).toEqual([near, near]);
    expect(cast(ray, itemOf(plane(2, new MeshBasicMaterial({ side: BackSide })), 'behind'), far).item).toBe(far);
    expect(cast(ray, itemOf(plane(2, new MeshBasicMaterial({ visible: false })), 'unseen'), far).item).toBe(far);
    near.root.visible = false;
    expect(cast(ray, near, far).item).toBe(far);
    expect(cast(rayFrom(new Vector3(0, 0, -5), new Vector3()), far).item).toBe(null);
    near.root.visible = true;
    expect(cast(ray, { ...near, hidden: true }, { ...near, pickable: false }, far).item).toBe(far);
  });

  test('the normal of the face, also where the object is stretched', () => {
    const slope = new Mesh(new PlaneGeometry(2, 2).rotateX(-Math.PI / 4), MATERIAL);
    // Half as deep: a slope of 45° becomes one of 63.4°.
    const item = itemOf(slope, 'slope', new Matrix4().makeScale(1, 1, 0.5));
    const { normal } = cast(rayFrom(new Vector3(0, 0, 3), new Vector3()), item);
    expect(normal.normalize().toArray()).toEqual([0, expect.closeTo(Math.sqrt(0.2), 5), expect.closeTo(Math.sqrt(0.8), 5)]);
  });

  test('nothing of what has no triangles, no size, or numbers that are none', () => {
    const ray = rayFrom(new Vector3(0, 0, 3), new Vector3());
    const broken = new BufferGeometry();
    broken.setAttribute('position', new BufferAttribute(new Float32Array(9).fill(Number.NaN), 3));
    broken.boundingSphere = new Sphere();
    const flat = itemOf(new Mesh(new BoxGeometry(), MATERIAL), 'flat', new Matrix4().makeScale(0, 0, 0));
    const items = [itemOf(new Mesh(new BufferGeometry(), MATERIAL)), itemOf(new Mesh(broken, MATERIAL)), itemOf(new Group()), flat];
    for (const item of items) expect(cast(ray, item).item).toBe(null);
    expect(buildTriangleTree(new Float32Array(0)).corners).toHaveLength(0);
  });

  test('a tree that is built once per geometry, until its buffers or its draw range change', () => {
    const geometry = new PlaneGeometry();
    const ray = rayFrom(new Vector3(0.2, 0.2, 3), new Vector3(0.2, 0.2, 0));
    const item = itemOf(new Mesh(geometry, MATERIAL));
    expect(cast(ray, item).distanceM).toBeCloseTo(3, 6);
    const first = trianglesOf(geometry);
    expect(trianglesOf(geometry)).toBe(first);
    const { position } = geometry.attributes;
    for (let i = 0; i < 4; i++) position?.setZ(i, 1);
    (position as BufferAttribute).needsUpdate = true;
    geometry.computeBoundingSphere();
    expect(cast(ray, item).distanceM).toBeCloseTo(2, 6);
    geometry.setDrawRange(0, 0);
    expect(cast(ray, item).item).toBe(null);
  });
});
