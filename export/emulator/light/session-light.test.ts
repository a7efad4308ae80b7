import { expect, test } from '@jest/globals';
import type { RoomLight } from './room-light.ts';
import { createSessionLight, LIGHT_DEFAULTS, type LightOptions, type LightState } from './session-light.ts';

const ROOM: RoomLight = {
  sphericalHarmonics: new Float32Array(27).fill(0.5),
  directionWorld: [0, 1, 0],
  intensity: [1, 2, 3],
  cubeFaces: [],
  cubeSizePx: 32,
};

/** What is told after each of these states, one a frame. */
function told(states: readonly LightState[], options: LightOptions = {}) {
  const light = createSessionLight(() => ROOM, { ...LIGHT_DEFAULTS, ...options });
  return states.map((state) => {
    const changed = light.follow(state);
    return { changed, ...light.estimate(), size: light.reflection()?.cubeSizePx ?? null };
  });
}

const DIM = { intensity: [0.1, 0.1, 0.1] } as const;

test('the room’s light, and what is changed of it', () => {
  const [room, dim] = told(['room', DIM]);
  expect(room).toMatchObject({ directionWorld: [0, 1, 0], intensity: [1, 2, 3], size: 32 });
  expect(dim).toMatchObject({ directionWorld: [0, 1, 0], intensity: [0.1, 0.1, 0.1] });
  expect(dim?.sphericalHarmonics?.[26]).toBe(0.5);
});

test('nothing when it stops, the last when it freezes', () => {
  const [, stopped, back, frozen] = told(['room', 'stopped', DIM, 'frozen']);
  expect(stopped?.sphericalHarmonics).toBeUndefined();
  expect(back?.intensity).toEqual([0.1, 0.1, 0.1]);
  expect(frozen?.intensity).toEqual([0.1, 0.1, 0.1]);
});

test('late by as many frames as asked', () => {
  expect(told(['room', DIM, DIM, DIM], { lagFrames: 2 }).map(({ intensity }) => intensity?.[0])).toEqual([1, 1, 1, 0.1]);
});

test('another cube map is announced once, and none at all is possible', () => {
  const reflection = Array.from({ length: 6 }, () => [1, 0, 0] as const);
  const state = { reflection };
  const found = told(['room', DIM, state, state, { ...state, intensity: null }, { reflection: null }, 'room']);
  expect(found.map(({ changed }) => changed)).toEqual([false, false, true, false, false, true, true]);
  expect(found.map(({ size }) => size)).toEqual([32, 32, 4, 4, 4, null, 32]);
});

test('flickering about the truth, the same every time', () => {
  const states = Array.from({ length: 400 }, () => 'room' as const);
  const levels = told(states, { flicker: 0.1 }).map(({ sphericalHarmonics }) => sphericalHarmonics?.[0] ?? 0);
  const mean = levels.reduce((sum, level) => sum + level, 0) / levels.length;
  expect(mean).toBeCloseTo(0.5, 1);
  expect(Math.sqrt(levels.reduce((sum, level) => sum + (level - mean) ** 2, 0) / levels.length) / 0.05).toBeCloseTo(1, 0);
  expect(told(states, { flicker: 0.1 }).map(({ sphericalHarmonics }) => sphericalHarmonics?.[0])).toEqual(levels);
});
