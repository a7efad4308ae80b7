import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { ball } from '../../../tests/support/physics/lab.ts';
import { createStage } from '../../../tests/support/physics/stage.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

describe('physics/collision', () => {
  test('gives one pulse when a ball meets the floor, with point, normal, body and the momentum', () => {
    const stage = createStage();
    const body = stage.add([0.5, 1.1, 0], ball(0.1));
    const fake = fakeContext(definition, { inputs: { body: [stage.list] } });
    const node = create(fake.ctx);
    const pulses: { number: number; key: string; pose: number[] }[] = [];
    for (let i = 0; i < 90; i++) {
      stage.play(1, node, fake);
      const { touched, strength } = fake.ctx.outputs;
      for (let j = 0; j < touched.count; j++) {
        const { number, bodyKey, worldFromPose } = touched.at(j);
        pulses.push({ number, key: bodyKey, pose: Array.from(worldFromPose ?? [], (x) => Math.round(x * 100) / 100 + 0) });
        expect(strength.value).toBe(number);
      }
    }
    expect(pulses).toHaveLength(1);
    expect(pulses[0]?.key).toBe(body.key);
    // It falls 1 m: m √(2 g h).
    expect(pulses[0]?.number).toBeCloseTo(Math.sqrt(2 * 9.81), 0);
    expect(pulses[0]?.pose.slice(4, 7)).toEqual([0, 1, 0]);
    expect(pulses[0]?.pose.slice(12, 15)).toEqual([0.5, 0, 0]);
  });

  test('tells both bodies of a contact, and is silent below the least strength', () => {
    const play = (leastNs: number) => {
      const stage = createStage({ gravity: [0, 0, 0] });
      stage.add([0, 1, 0]).targetVelocity.set([1, 0, 0]);
      stage.add([0.5, 1, 0]);
      const fake = fakeContext(definition, { params: { leastNs }, inputs: { body: [stage.list] } });
      const node = create(fake.ctx);
      const keys: string[] = [];
      for (let i = 0; i < 60; i++) {
        stage.play(1, node, fake);
        const { touched } = fake.ctx.outputs;
        for (let j = 0; j < touched.count; j++) keys.push(touched.at(j).bodyKey);
      }
      return keys.sort();
    };
    expect(play(0.01)).toEqual(['body 0', 'body 1']);
    expect(play(100)).toEqual([]);
  });
});
