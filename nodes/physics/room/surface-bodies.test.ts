import { describe, expect, test } from '@jest/globals';
import { BoxGeometry, Matrix4, Mesh, PlaneGeometry } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { ball } from '../../../tests/support/physics/lab.ts';
import { createStage, placeOf } from '../../../tests/support/physics/stage.ts';
import type { ObjectItem } from '../../kit/scene-lists.ts';
import type { DetectedMesh, DetectedPlane } from '../../kit/session.ts';
import { definition as bodyDefinition } from '../body/definition.ts';
import { create as createBody } from '../body/runtime.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

const at = (x: number, y: number, z: number) => Float32Array.from(new Matrix4().makeTranslation(x, y, z).elements);
const table: DetectedPlane = {
  id: 'table',
  version: 1,
  label: 'table',
  orientation: 'horizontal',
  worldFromSurface: at(0, 0.74, -1),
  // An L: the square between its legs is free.
  outlineXZ: Float32Array.of(-0.6, -0.4, 0.6, -0.4, 0.6, 0, 0, 0, 0, 0.4, -0.6, 0.4),
};
const couch: DetectedMesh = {
  id: 'couch',
  version: 1,
  label: 'couch',
  worldFromSurface: at(2, 0.21, -1),
  positions: Float32Array.from(new BoxGeometry(1, 0.42, 0.8).attributes.position?.array ?? []),
  indices: Uint32Array.from(new BoxGeometry(1, 0.42, 0.8).index?.array ?? []),
};
const RADIUS_M = 0.05;
const session = { depthImage: () => null, sessions: 0, answerRays: () => () => {} };

function open(config: Readonly<Record<string, boolean>>) {
  const stage = createStage({ floor: true });
  const fake = fakeContext(definition, { params: config, services: { session: session as never } });
  const node = create(fake.ctx);
  const out = fake.ctx.outputs.body;
  const drop = (x: number, z: number) => stage.add([x, 1.2, z], ball(RADIUS_M), { rollingM: 0.004 });
  return { stage, out, drop, play: (frames: number, surfaces: object) => stage.play(frames, node, fake, { jumps: 0, surfaces }, [out]) };
}

describe('what a session detects', () => {
  test('holds balls: a plane and a mesh within a millimeter; beside the outline they fall to the floor', () => {
    const { drop, play, out } = open({ depth: false, planes: true, meshes: true });
    expect(out.room).toBeUndefined();
    const [onTable, beside, onCouch] = [drop(-0.3, -0.8), drop(0.3, -0.8), drop(2.1, -0.9)];
    play(240, { planes: [table], meshes: [couch] });
    expect(Math.abs(placeOf(onTable)[1] - 0.74 - RADIUS_M)).toBeLessThan(1e-3);
    expect(Math.abs(placeOf(onCouch)[1] - 0.42 - RADIUS_M)).toBeLessThan(1e-3);
    expect(Math.abs(placeOf(beside)[1] - RADIUS_M)).toBeLessThan(1e-3);
  });

  test('is no obstacle unless it is wanted, and none any more when the device has lost it', () => {
    const { drop, play } = open({ depth: false, planes: true, meshes: false });
    const [onTable, onCouch] = [drop(-0.3, -0.8), drop(2.1, -0.9)];
    play(180, { planes: [table], meshes: [couch] });
    expect(placeOf(onTable)[1]).toBeGreaterThan(0.7);
    expect(placeOf(onCouch)[1]).toBeLessThan(0.06);
    play(120, { planes: [], meshes: [couch] });
    expect(placeOf(onTable)[1]).toBeLessThan(0.06);
  });

  test('bodies follow a plane that the device corrects, and sleep on one whose tracking trembles', () => {
    const { drop, play } = open({ depth: false, planes: true, meshes: false });
    const body = drop(-0.3, -0.8);
    play(180, { planes: [table], meshes: [] });
    for (let i = 0; i < 60; i++) {
      table.worldFromSurface.set(at(0, 0.74 + (i % 2) * 4e-4, -1));
      play(1, { planes: [table], meshes: [] });
    }
    expect(body.isAsleep).toBe(true);
    table.worldFromSurface.set(at(0, 0.7, -1));
    play(90, { planes: [table], meshes: [] });
    expect(Math.abs(placeOf(body)[1] - 0.7 - RADIUS_M)).toBeLessThan(2e-3);
    table.worldFromSurface.set(at(0, 0.74, -1));
  });
});

test('a phantom in the shape of a hollow thing holds a ball in its hollow, as a body that nothing moves', () => {
  const stage = createStage();
  // A tray: a bottom and two walls.
  const root = new Mesh(new PlaneGeometry(1, 1).rotateX(-Math.PI / 2));
  for (const side of [-1, 1]) {
    const wall = new Mesh(new PlaneGeometry(1, 0.3).rotateY(Math.PI / 2));
    wall.matrixWorld.makeTranslation(side * 0.5, 0.15, 0);
    root.add(wall);
  }
  const item: ObjectItem = {
    key: 'tray',
    root,
    worldFromObject: new Matrix4().makeTranslation(0, 0.8, 0),
    role: 'phantom',
    castsShadow: false,
    receivesShadow: true,
  };
  const fake = fakeContext(bodyDefinition, { inputs: { objects: [{ version: 1, items: [item] }] }, params: { mode: 'static' } });
  const node = createBody(fake.ctx);
  node.prepare?.();
  const body = stage.add([0.2, 1.2, 0.1], ball(RADIUS_M), { rollingM: 0.001 });
  body.targetVelocity.set([0.6, 0, 0]);
  stage.play(300, node, fake, { jumps: 0 }, [fake.ctx.outputs.body]);
  expect(Math.abs(placeOf(body)[1] - 0.8 - RADIUS_M)).toBeLessThan(1e-3);
  expect(Math.abs(placeOf(body)[0])).toBeLessThan(0.5);
  expect(fake.reports).toEqual([]);
});
