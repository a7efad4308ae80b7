import { describe, expect, test } from '@jest/globals';
import { Matrix4 } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { createStage, placeOf } from '../../../tests/support/physics/stage.ts';
import { createPose, writePose } from '../../kit/pose.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function start(params: Record<string, number | string>, at: readonly [number, number, number] = [1, 2, 0]) {
  const stage = createStage({ gravity: [0, 0, 0], floor: false });
  const body = stage.add(at);
  const pose = createPose();
  writePose(pose, new Matrix4().makeTranslation(0, 2, 0).elements, 0);
  const fake = fakeContext(definition, { params, inputs: { body: [stage.list], pose } });
  const node = create(fake.ctx);
  return { body, pose, play: (seconds: number) => stage.play(seconds * 60, node, fake) };
}

describe('physics/force-field', () => {
  test('wind takes a body along until it has its speed: v (1 - e^(-drag t))', () => {
    const { body, play } = start({ kind: 'wind', strength: 3, drag: 2 });
    play(1);
    expect(-(body.velocity[2] ?? 0)).toBeCloseTo(3 * (1 - Math.exp(-2)), 1);
    play(4);
    expect(-(body.velocity[2] ?? 0)).toBeCloseTo(3, 2);
  });

  test('an attractor accelerates towards its point, within its radius', () => {
    const { body, play } = start({ kind: 'attractor', strength: 2 });
    play(0.5);
    expect(placeOf(body)[0]).toBeCloseTo(1 - 0.5 * 2 * 0.25, 1);
    const far = start({ kind: 'attractor', strength: 2, radiusM: 0.5 });
    far.play(0.5);
    expect(placeOf(far.body)).toEqual([1, 2, 0]);
  });

  test('a vortex accelerates about its axis', () => {
    const { body, play } = start({ kind: 'vortex', strength: 2 });
    play(0.2);
    // Counterclockwise from above: at +x towards -z.
    expect(body.velocity[2]).toBeLessThan(-0.3);
  });

  test('there is none while the pose is invalid', () => {
    const { body, pose, play } = start({ kind: 'attractor', strength: 2 });
    writePose(pose, null, 0);
    play(0.5);
    expect(placeOf(body)).toEqual([1, 2, 0]);
  });
});
