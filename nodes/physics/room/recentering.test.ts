import { expect, test } from '@jest/globals';
import { Matrix4 } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { ball } from '../../../tests/support/physics/lab.ts';
import { createStage, placeOf } from '../../../tests/support/physics/stage.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

const TABLE_M = 0.4;
const RADIUS_M = 0.05;
const MOVE_M = [3, -0.2, 0] as const;

/** Depth of a table, seen from a meter above it. */
const image = {
  meters: new Float32Array(160 * 120).fill(1),
  widthPx: 160,
  heightPx: 120,
  uvFromViewUv: Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1),
  clipFromView: Float32Array.from(new Matrix4().makePerspective(-0.1, 0.1, 0.075, -0.075, 0.1, 100).elements),
  worldFromView: Float32Array.from(new Matrix4().makeRotationX(-Math.PI / 2).setPosition(0, TABLE_M + 1, 0).elements),
  frame: 0,
};

/** Whether a table that nobody looks at any more holds balls, at its former and at its present place, after world space has moved. */
function recenter(worldFromFormer: Float32Array | null): { readonly former: boolean; readonly present: boolean } {
  let isSeen = true;
  const session = { sessions: 0, depthImage: () => (isSeen ? image : null), answerRays: () => () => {} };
  const fake = fakeContext(definition, { services: { session: session as never } });
  const node = create(fake.ctx);
  const stage = createStage({ floor: false });
  const play = (frames: number, jumps: number) => {
    for (let i = 0; i < frames; i++) {
      image.frame++;
      stage.play(1, node, fake, { jumps, worldFromFormer }, [fake.ctx.outputs.body]);
    }
  };
  play(20, 0);
  isSeen = false;
  const before = stage.add([0, TABLE_M + 0.2, 0], ball(RADIUS_M), { rollingM: 0.004 });
  play(60, 0);
  expect(Math.abs(placeOf(before)[1] - TABLE_M - RADIUS_M)).toBeLessThan(0.06);
  play(1, 1);
  const moved = stage.add([MOVE_M[0], TABLE_M + MOVE_M[1] + 0.2, MOVE_M[2]], ball(RADIUS_M), { rollingM: 0.004 });
  play(60, 1);
  return {
    former: placeOf(before)[1] > TABLE_M - RADIUS_M,
    present: Math.abs(placeOf(moved)[1] - TABLE_M - MOVE_M[1] - RADIUS_M) < 0.06,
  };
}

test('the voxels move with the room when the device tells how the session re-centered', () => {
  const worldFromFormer = Float32Array.from(new Matrix4().makeTranslation(...MOVE_M).elements);
  expect(recenter(worldFromFormer)).toEqual({ former: false, present: true });
});

test('they are cleared when it does not', () => {
  expect(recenter(null)).toEqual({ former: false, present: false });
});
