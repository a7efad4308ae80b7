import { NodeIO } from '@gltf-transform/core';
import { describe, expect, test } from '@jest/globals';
import { BufferAttribute, BufferGeometry, Group, Mesh, Vector3 } from 'three';
import { compile } from '../../export/compiler/compile.ts';
import type { BodyShape, Triple } from '../../nodes/kit/physics.ts';
import { type ShapeKind, shapeOf } from '../../nodes/physics/body/body-shape.ts';
import { makeProject } from '../../tools/examples/paper/recipe.ts';
import { BALL_RADIUS_M, CAN, CRATE_M } from '../../tools/examples/play/cans.ts';
import { FUNNEL_M, MARBLE_RADIUS_M } from '../../tools/examples/play/marble-run.ts';
import { PLAY } from '../../tools/examples/play/recipes.ts';
import { expectMadeByScript } from '../support/example-files.ts';
import { LIBRARY } from '../support/library.ts';
import { ball, createLab } from '../support/physics/lab.ts';

describe.each(PLAY.map((recipe) => [recipe.folder, recipe] as const))('the example %s', (folder, recipe) => {
  const project = makeProject(LIBRARY, recipe);

  test('is what the script makes of its recipe, with all its files', () => expectMadeByScript(folder, project));

  test('compiles without a word, tells visitors what to do, and simulates 50 bodies', () => {
    const { output, diagnostics } = compile({ project, library: LIBRARY });
    expect(diagnostics).toEqual([]);
    expect(output).not.toBeNull();
    expect(recipe.description).toMatch(/^Tap /);
    const moving = Object.values(recipe.nodes).flatMap(([type, , , params]) =>
      type === 'physics/body' && params?.mode !== 'static' ? [params] : [],
    );
    expect(moving.length).toBeGreaterThan(0);
  });
});

/** The body of a model of an example, as the node Body makes it. */
async function bodyOf(path: string, kind: ShapeKind): Promise<readonly BodyShape[]> {
  const document = await new NodeIO().read(`examples/${path}`);
  const group = new Group();
  for (const mesh of document.getRoot().listMeshes()) {
    for (const primitive of mesh.listPrimitives()) {
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', new BufferAttribute(Float32Array.from(primitive.getAttribute('POSITION')?.getArray() ?? []), 3));
      group.add(new Mesh(geometry));
    }
  }
  const { shapes, problem } = shapeOf(kind, group, new Vector3(1, 1, 1));
  expect(problem).toBeNull();
  return shapes;
}

test('marbles roll down all chutes, one after the other, and leave the run at its foot', async () => {
  const lab = createLab({ sleep: true });
  lab.floor(0.6, 0.1);
  lab.add({ mode: 'static', shapes: await bodyOf('marble-run/assets/chutes.glb', 'parts'), friction: 0.35, restitution: 0.1 }, {});
  const marble = { massKg: 0, densityKgPerM3: 2500, friction: 0.35, rollingM: 0.0005, restitution: 0.45, shapes: ball(MARBLE_RADIUS_M) };
  const ids: number[] = [];
  const turns = new Map<number, number[]>();
  lab.run(14, (frame) => {
    // As the example: one each 0.6 s.
    if (frame % 36 === 0 && ids.length < 12) ids.push(lab.add(marble, { positionM: [...FUNNEL_M] }));
    for (const id of ids) {
      const { positionM, velocity } = lab.body(id);
      const list = turns.get(id) ?? [];
      turns.set(id, list);
      const direction = Math.sign(velocity[0]);
      if (positionM[1] > 0.1 && Math.abs(velocity[0]) > 0.15 && list.at(-1) !== direction) list.push(direction);
    }
  });
  const onFloor = ids.filter((id) => lab.body(id).positionM[1] < 2 * MARBLE_RADIUS_M);
  expect([onFloor.length, ids.length]).toEqual([12, 12]);
  // To the right, the left, the right and the left again.
  for (const id of ids) expect([id, (turns.get(id) ?? []).length >= 4]).toEqual([id, true]);
});

test('the cans stand until a ball hits them', async () => {
  const lab = createLab({ sleep: true });
  lab.floor();
  lab.add({ mode: 'static', shapes: await bodyOf('tin-cans/assets/crate.glb', 'box'), friction: 0.7 }, {});
  const gapM = 2 * CAN.radiusM + 0.004;
  const can = {
    massKg: 0.05,
    friction: 0.5,
    restitution: 0.25,
    rollingM: 0.002,
    shapes: await bodyOf('tin-cans/assets/can.glb', 'cylinder'),
  };
  const places = [5, 4, 3, 2, 1].flatMap((count, row) =>
    Array.from({ length: count }, (_, i): Triple => [(i - (count - 1) / 2) * gapM, CRATE_M[1] + (row + 0.5) * CAN.heightM, -0.05]),
  );
  for (const x of [-0.14, 0, 0.14]) {
    lab.add(
      { massKg: 0.12, shapes: await bodyOf('tin-cans/assets/ball.glb', 'sphere') },
      { positionM: [x, CRATE_M[1] + BALL_RADIUS_M, CRATE_M[2] / 2 - 0.03] },
    );
  }
  const ids = places.map((positionM) => lab.add(can, { positionM }));
  lab.run(10);
  ids.forEach((id, i) => {
    const [x = 0, y = 0, z = 0] = places[i] ?? [];
    const { positionM, isAsleep } = lab.body(id);
    expect([i, Math.hypot(positionM[0] - x, positionM[1] - y, positionM[2] - z) < 0.01, isAsleep]).toEqual([i, true, true]);
  });
  lab.add(
    { massKg: 0.12, friction: 0.6, restitution: 0.55, rollingM: 0.003, shapes: ball(BALL_RADIUS_M) },
    { positionM: [0, 0.55, 1], velocity: [0, 1, -6] },
  );
  lab.run(3);
  const fallen = ids.filter((id) => lab.body(id).positionM[1] < CRATE_M[1]);
  expect(fallen.length).toBeGreaterThan(5);
});
