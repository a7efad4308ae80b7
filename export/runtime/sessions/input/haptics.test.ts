import { expect, test } from '@jest/globals';
import { createHapticsCache } from './haptics.ts';

test('a headset’s motor pulses within its limits, for milliseconds', () => {
  const played: number[][] = [];
  const gamepad = { hapticActuators: [{ pulse: async (value: number, ms: number) => played.push([value, ms]) }] };
  const of = createHapticsCache();
  const haptics = of(gamepad as never);
  expect(of(gamepad as never)).toBe(haptics);
  haptics?.pulse(0.5, 0.1);
  haptics?.pulse(7, 60);
  for (const [strength, durationS] of [
    [0, 1],
    [-1, 1],
    [1, 0],
    [Number.NaN, 1],
    [1, Number.NaN],
  ] as const)
    haptics?.pulse(strength, durationS);
  expect(played).toEqual([
    [0.5, 100],
    [1, 5000],
  ]);
});

test('a gamepad rumbles with both motors', () => {
  const played: unknown[] = [];
  const gamepad = { vibrationActuator: { playEffect: async (...effect: unknown[]) => played.push(effect) } };
  createHapticsCache()(gamepad as never)?.pulse(0.25, 1);
  expect(played).toEqual([['dual-rumble', { duration: 1000, strongMagnitude: 0.25, weakMagnitude: 0.25 }]]);
});

test('there is none without a motor, and a refusal is silent', async () => {
  const of = createHapticsCache();
  expect([of({} as never), of({ hapticActuators: [], vibrationActuator: null } as never)]).toEqual([null, null]);
  const refusing = {
    pulse: () => {
      throw new TypeError('no');
    },
  };
  of({ hapticActuators: [refusing] } as never)?.pulse(1, 1);
  of({ hapticActuators: [{ pulse: () => Promise.reject(new Error('no')) }] } as never)?.pulse(1, 1);
  await new Promise((resolve) => setImmediate(resolve));
});
