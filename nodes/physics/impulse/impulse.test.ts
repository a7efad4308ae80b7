import { describe, expect, test } from '@jest/globals';
import { Matrix4 } from 'three';
import { createPulseQueue } from '../../../export/runtime/values/pulses.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { createStage } from '../../../tests/support/physics/stage.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function start(params: Record<string, number[] | string> = {}) {
  const stage = createStage({ gravity: [0, 0, 0] });
  const a = stage.add([0, 2, 0]);
  const b = stage.add([3, 2, 0]);
  const push = createPulseQueue();
  const fake = fakeContext(definition, { params, inputs: { body: [stage.list], push } });
  const node = create(fake.ctx);
  const play = (frames: number) => {
    for (let i = 0; i < frames; i++) {
      stage.play(1, node, fake);
      push.clear();
    }
  };
  return { a, b, push, play };
}

describe('physics/impulse', () => {
  test('changes the velocity by impulse over mass, of all bodies or of the one that the pulse names', () => {
    const { a, b, push, play } = start({ impulseNs: [0, 3, 0] });
    play(1);
    push.emit().bodyKey = a.key;
    play(2);
    expect([a.velocity[1], b.velocity[1]]).toEqual([3, 0]);
    push.emit();
    play(2);
    expect([a.velocity[1], b.velocity[1]]).toEqual([6, 3]);
  });

  test('goes along the ray of the pulse', () => {
    const { a, push, play } = start({ impulseNs: [0, 0, -2], axes: 'pulse' });
    play(1);
    // Its -z axis points along -x.
    push.emit().setPose(new Matrix4().makeRotationY(Math.PI / 2).elements);
    play(2);
    expect(Array.from(a.velocity, (v) => Math.round(v * 1e5) / 1e5 + 0)).toEqual([-2, 0, 0]);
  });

  test('an angular impulse turns', () => {
    const { a, push, play } = start({ impulseNs: [0, 0, 0], turnNms: [0, 0.01, 0] });
    push.emit();
    play(3);
    // The moment of a cube of 1 kg and 20 cm is m a² / 6.
    expect(a.angularVelocity[1]).toBeCloseTo(0.01 / (0.04 / 6), 4);
  });
});
