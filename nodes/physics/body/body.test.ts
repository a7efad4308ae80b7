import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import {
  Bone,
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  CylinderGeometry,
  Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  Skeleton,
  SkinnedMesh,
  SphereGeometry,
  TorusGeometry,
  Vector3,
} from 'three';
import { createPulseQueue } from '../../../export/runtime/values/pulses.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { type BodyShape, createWorldControl } from '../../kit/physics.ts';
import type { ObjectItem, ObjectList } from '../../kit/scene-lists.ts';
import { massProperties } from '../world/mass-properties.ts';
import { shapeOf } from './body-shape.ts';
import { hullOf, MAX_VERTICES } from './convex-hull.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

const ONE = new Vector3(1, 1, 1);
const KNOWN_HULLS = JSON.parse(readFileSync(resolve(import.meta.dirname, '../../../tests/support/physics/convex-hulls.json'), 'utf8')) as {
  name: string;
  points: number[];
  volume: number;
  vertices: number;
}[];
const volumeOf = (shapes: readonly BodyShape[]) => massProperties(shapes, 0, 1).massKg;

/** How far a vertex lies outside a face at most. */
function bulge(shape: BodyShape): number {
  if (shape.kind !== 'hull') throw new Error('It is no hull.');
  const vertices = shape.verticesM.map((vertex) => new Vector3(...vertex));
  return Math.max(
    ...shape.faces.map((face) => {
      const [a, b, c] = face.map((i) => vertices[i] ?? new Vector3()) as [Vector3, Vector3, Vector3];
      const normal = b.clone().sub(a).cross(c.clone().sub(a)).normalize();
      return Math.max(...vertices.map((vertex) => vertex.clone().sub(a).dot(normal)));
    }),
  );
}

describe('shapes', () => {
  test.each([
    ['box', new BoxGeometry(0.2, 0.3, 0.4), 0.024],
    ['sphere', new SphereGeometry(0.1, 24, 16), (4 / 3) * Math.PI * 0.001],
    ['cylinder', new CylinderGeometry(0.1, 0.1, 0.5), Math.PI * 0.01 * 0.5],
  ] as const)('of a %s are its solid', (_name, geometry, volume) => {
    const { shapes, problem } = shapeOf('auto', new Mesh(geometry), ONE);
    expect(problem).toBeNull();
    expect(volumeOf(shapes)).toBeCloseTo(volume, 6);
  });

  test('a hull is convex, holds nearly all of the model, and has few vertices and merged faces', () => {
    const { shapes } = shapeOf('hull', new Mesh(new TorusGeometry(0.4, 0.1, 24, 64)), ONE);
    const [hull] = shapes;
    if (hull?.kind !== 'hull') throw new Error('It is no hull.');
    expect(hull.verticesM.length).toBeLessThanOrEqual(40);
    expect(bulge(hull)).toBeLessThan(0.01);
    const box = shapeOf('hull', new Mesh(new BoxGeometry(1, 1, 1, 4, 4, 4)), ONE).shapes[0];
    expect(box?.kind === 'hull' && [box.verticesM.length, box.faces.length]).toEqual([8, 6]);
  });

  // The values are those of tests/support/physics/convex-hulls.py.
  test.each(KNOWN_HULLS)('the hull of $name has the volume that another implementation gives', ({ points, volume, vertices }) => {
    const hull = hullOf(Float64Array.from(points));
    if (!hull) throw new Error('There is no hull.');
    const isWhole = vertices <= MAX_VERTICES;
    expect(volumeOf([hull]) / volume).toBeGreaterThan(isWhole ? 0.99 : 0.85);
    expect(volumeOf([hull]) / volume).toBeLessThan(1.01);
    expect(hull.verticesM.length).toBeLessThanOrEqual(Math.min(vertices, MAX_VERTICES));
    const sizeM = Math.max(...points) - Math.min(...points);
    expect(bulge(hull)).toBeLessThan(0.03 * sizeM);
  });

  test('parts keep what is between them free', () => {
    const group = new Group();
    for (const x of [-0.5, 0.5]) {
      const leg = new Mesh(new BoxGeometry(0.1, 1, 0.1));
      leg.matrixWorld.makeTranslation(x, 0, 0);
      group.add(leg);
    }
    expect(volumeOf(shapeOf('parts', group, ONE).shapes)).toBeCloseTo(0.02, 6);
    expect(volumeOf(shapeOf('hull', group, ONE).shapes)).toBeCloseTo(0.11, 6);
  });

  test('a scale counts', () => {
    expect(volumeOf(shapeOf('auto', new Mesh(new BoxGeometry()), new Vector3(1, 2, 3)).shapes)).toBeCloseTo(6, 6);
  });

  test('all instances count, and a skinned mesh has the shape of its rest pose', () => {
    const posts = new InstancedMesh(new BoxGeometry(0.1, 1, 0.1), new MeshBasicMaterial(), 2);
    posts.setMatrixAt(0, new Matrix4().makeTranslation(-0.5, 0, 0));
    posts.setMatrixAt(1, new Matrix4().makeTranslation(0.5, 0, 0));
    expect(volumeOf(shapeOf('hull', posts, ONE).shapes)).toBeCloseTo(0.11, 6);
    const geometry = new BoxGeometry(0.1, 1, 0.1);
    geometry.setAttribute('skinIndex', new BufferAttribute(new Uint16Array(4 * 24), 4));
    geometry.setAttribute('skinWeight', new BufferAttribute(new Float32Array(4 * 24).fill(0.25), 4));
    const arm = new SkinnedMesh(geometry);
    const bone = new Bone();
    arm.bind(new Skeleton([bone]));
    bone.scale.set(3, 3, 3);
    bone.updateMatrixWorld();
    expect(volumeOf(shapeOf('hull', arm, new Vector3(1, 2, 1)).shapes)).toBeCloseTo(0.02, 6);
  });

  const flat = new Mesh(new PlaneGeometry(1, 1));
  const nothing = new Mesh(new BufferGeometry());
  const point = new Mesh(new BoxGeometry(0, 0, 0));
  const triangles = new BufferGeometry();
  triangles.setAttribute(
    'position',
    new BufferAttribute(
      new Float32Array(9_000_000).map((_, i) => ((i * 7919) % 1000) / 1000),
      3,
    ),
  );
  const strange = new BufferGeometry();
  strange.setAttribute('position', new BufferAttribute(new Float32Array(300).fill(Number.NaN), 3));
  test.each([
    ['flat', flat],
    ['empty', nothing],
    ['of no size', point],
    ['of a million triangles', new Mesh(triangles)],
    ['of numbers that are none', new Mesh(strange)],
  ])('a model that is %s is a box, with a reason', (_name, mesh) => {
    const { shapes, problem } = shapeOf('hull', mesh, ONE);
    expect(problem).toMatch(/^The object /);
    expect(shapes).toHaveLength(1);
    expect(volumeOf(shapes)).toBeGreaterThan(0);
  });

  test('a huge model has a hull of its size, and numbers that overflow give a box', () => {
    const huge = new Mesh(new SphereGeometry(1e5, 24, 16));
    const { shapes, problem } = shapeOf('hull', huge, ONE);
    expect(problem).toBeNull();
    // Of 40 vertices.
    expect(volumeOf(shapes) / ((4 / 3) * Math.PI * 1e15)).toBeGreaterThan(0.8);
    const overflow = new BufferGeometry();
    overflow.setAttribute('position', new BufferAttribute(Float32Array.of(0, 0, 0, 1e38, 0, 0, 0, 1e38, 0, 0, 0, 1e38), 3));
    const box = shapeOf('hull', new Mesh(overflow), ONE);
    const numbers = box.shapes.flatMap((shape) => (shape.kind === 'hull' ? shape.verticesM.flat() : []));
    expect(numbers.every(Number.isFinite)).toBe(true);
  });

  test('an edge that three triangles share has a hull', () => {
    const fins = new BufferGeometry();
    const corners = [0, 0, 0, 1, 0, 0, 0.5, 1, 0, 0.5, 0, 1, 0.5, -1, 0.2];
    fins.setAttribute('position', new BufferAttribute(Float32Array.from(corners), 3));
    fins.setIndex([0, 1, 2, 0, 1, 3, 0, 1, 4]);
    const { shapes, problem } = shapeOf('hull', new Mesh(fins), ONE);
    expect(problem).toBeNull();
    // By hand: pyramids of the height 0.5 to both sides of the section at x = 0.5, whose area is 1.
    expect(volumeOf(shapes)).toBeCloseTo(1 / 3, 5);
  });

  test('a model with holes and double faces has a hull', () => {
    const open = new BoxGeometry(1, 1, 1).toNonIndexed();
    const values = (open.getAttribute('position').array as Float32Array).slice(18);
    const broken = new BufferGeometry();
    broken.setAttribute('position', new BufferAttribute(Float32Array.from([...values, ...values]), 3));
    const { shapes, problem } = shapeOf('hull', new Mesh(broken), ONE);
    expect(problem).toBeNull();
    expect(volumeOf(shapes)).toBeCloseTo(1, 5);
  });
});

function start(params: Parameters<typeof fakeContext<typeof definition>>[1] = {}, more: readonly ObjectItem[] = []) {
  const root = new Mesh(new BoxGeometry(0.2, 0.2, 0.2));
  const item: ObjectItem = { key: 'box', root, role: 'virtual', castsShadow: true, receivesShadow: true, worldFromObject: new Matrix4() };
  const list: ObjectList = { version: 1, items: [item, ...more] };
  const spawn = createPulseQueue();
  const fake = fakeContext(definition, { ...params, inputs: { objects: [list], spawn } });
  const node = create(fake.ctx);
  const update = () => {
    node.update({ jumps: 0 } as never);
    spawn.clear();
  };
  return { ...fake, node, item, spawn, update, body: () => fake.ctx.outputs.body.bodies };
}

describe('physics/body', () => {
  test('moves its object as the world moves the body, in its size', () => {
    const { item, update, body, ctx } = start();
    item.worldFromObject.makeScale(2, 2, 2).setPosition(0, 1, 0);
    update();
    const [made] = body();
    expect(made?.description.shapes).toMatchObject([{ kind: 'hull' }]);
    expect(volumeOf(made?.description.shapes ?? [])).toBeCloseTo(0.064, 6);
    made?.worldFromBody.set(new Matrix4().makeRotationY(1).setPosition(3, 0, 0).elements);
    if (made) made.world = { applyPoses: () => {}, control: createWorldControl(), massOf: () => ({ massKg: 1, centerM: [0, 0, 0] }) };
    update();
    const [moved] = ctx.outputs.objects.items;
    expect(moved?.worldFromObject.elements.slice(12, 15)).toEqual([3, 0, 0]);
    expect(new Vector3().setFromMatrixScale(moved?.worldFromObject ?? new Matrix4()).x).toBeCloseTo(2, 6);
  });

  test('a static body is where the graph places it in the same frame, whatever the world last said', () => {
    const { item, update, body, ctx } = start({ params: { mode: 'static' } });
    item.worldFromObject.makeTranslation(0, 1, 0);
    update();
    const [made] = body();
    if (made) made.world = { applyPoses: () => {}, control: createWorldControl(), massOf: () => ({ massKg: 1, centerM: [0, 0, 0] }) };
    item.worldFromObject.makeTranslation(2, 1, 0);
    update();
    expect(ctx.outputs.objects.items[0]?.worldFromObject.elements[12]).toBe(2);
    expect(ctx.outputs.pose.worldFromPose[12]).toBe(2);
  });

  test('makes another shape where the scale changes by more than a hundredth', () => {
    const { item, update, body } = start();
    update();
    const version = body()[0]?.version;
    item.worldFromObject.makeScale(1.005, 1, 1);
    update();
    expect(body()[0]?.version).toBe(version);
    item.worldFromObject.makeScale(1.05, 1, 1);
    update();
    expect(volumeOf(body()[0]?.description.shapes ?? [])).toBeCloseTo(0.0084, 6);
  });

  test('copies are hidden until pulses throw them, one after the other, and the oldest again', () => {
    const { spawn, update, body, ctx } = start({ params: { copies: 2, spawnSpeed: 5 } });
    update();
    expect([body(), ctx.outputs.objects.items.map(({ hidden }) => hidden)]).toEqual([[], [true, true]]);
    // Readers of the objects build everything anew at each version, which takes longer than a frame.
    const { version } = ctx.outputs.objects;
    const keys: (string | undefined)[] = [];
    for (let i = 0; i < 3; i++) {
      spawn.emit().setPose(new Matrix4().makeTranslation(i, 1, 0).elements);
      update();
      keys.push(body().find(({ worldFromTarget }) => worldFromTarget[12] === i)?.key);
    }
    expect(body()).toHaveLength(2);
    expect(ctx.outputs.objects).toMatchObject({ version, items: [{ hidden: false }, { hidden: false }] });
    expect(keys[0]).toBe(keys[2]);
    expect(Array.from(body()[0]?.targetVelocity ?? [])).toEqual([-0, -0, -5]);
  });

  test('several objects are thrown in turn, and are listed before, so that their materials are ready', () => {
    const list = (key: string): ObjectItem => ({
      key,
      root: new Mesh(new BoxGeometry()),
      worldFromObject: new Matrix4(),
      role: 'virtual',
      castsShadow: true,
      receivesShadow: true,
    });
    const objects: ObjectList = { version: 0, items: [list('red'), list('blue')] };
    const spawn = createPulseQueue();
    const fake = fakeContext(definition, { params: { copies: 2 }, inputs: { objects: [objects], spawn } });
    const node = create(fake.ctx);
    node.prepare?.();
    expect(fake.ctx.outputs.objects.items.map(({ hidden }) => hidden)).toEqual([true, true, true, true]);
    const thrown = Array.from({ length: 4 }, () => {
      fake.tick(1 / 60);
      spawn.clear();
      spawn.emit();
      const before = new Set(fake.ctx.outputs.body.bodies);
      node.update({ jumps: 0 } as never);
      return fake.ctx.outputs.body.bodies.find((body) => !before.has(body))?.key;
    });
    expect(thrown).toEqual(['body-test/0/red#0', 'body-test/0/blue#0', 'body-test/0/red#1', 'body-test/0/blue#1']);
  });

  test('a body that fell out of the room or too low begins anew, once, and is counted', () => {
    const { item, update, body, ctx } = start();
    const lost = { value: 0 };
    Object.assign(ctx.outputs, { lost });
    item.worldFromObject.makeTranslation(0, 1, 0);
    update();
    const [made] = body();
    if (!made) throw new Error('There is no body.');
    made.world = { applyPoses: () => {}, control: createWorldControl(), massOf: () => ({ massKg: 1, centerM: [0, 0, 0] }) };
    // A world that is late tells it twice.
    for (let i = 0; i < 2; i++) {
      made.isLost = true;
      made.worldFromBody[13] = -3;
      update();
    }
    expect([made.jumps, lost.value]).toEqual([1, 1]);
    made.isLost = false;
    made.worldFromBody[13] = 1;
    update();
    made.worldFromBody[13] = -20;
    update();
    expect([made.jumps, lost.value, made.worldFromTarget[13]]).toEqual([2, 2, 1]);
  });

  test('says that a body without a world does not move', () => {
    const { update, reports } = start();
    for (let i = 0; i < 5; i++) update();
    expect(reports).toMatchObject([{ code: 'SCR038' }]);
    const slow = start();
    slow.ctx.outputs.body.isInWorld = true;
    for (let i = 0; i < 5; i++) slow.update();
    expect(slow.reports).toEqual([]);
  });

  test('a hidden object is no obstacle, and is one again when it is shown', () => {
    const { item, update, body, ctx } = start();
    item.hidden = true;
    update();
    expect([body(), ctx.outputs.objects.items[0]?.hidden]).toEqual([[], true]);
    item.hidden = false;
    update();
    expect([body().length, ctx.outputs.objects.items[0]?.hidden]).toEqual([1, false]);
  });

  test('a reticle is passed on, but is no body', () => {
    const ring = { key: 'ring', root: new Mesh(), role: 'virtual', castsShadow: false, receivesShadow: false, pickable: false } as const;
    const { update, body, ctx } = start({}, [{ ...ring, worldFromObject: new Matrix4() }]);
    update();
    expect(body()).toHaveLength(1);
    expect(ctx.outputs.objects.items.map(({ key }) => key)).toEqual(['0/box', '0/ring']);
  });

  test('a matrix that is not finite leaves the body where it was', () => {
    const { item, update, body } = start();
    item.worldFromObject.makeTranslation(0, 1, 0);
    update();
    item.worldFromObject.makeTranslation(Number.NaN, 1, 0);
    update();
    expect([...(body()[0]?.worldFromBody ?? [])].every(Number.isFinite)).toBe(true);
  });
});
