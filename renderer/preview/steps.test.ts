import { expect, test } from '@jest/globals';
import { createSteps } from './steps.ts';

test('a step waits until the previous frame is drawn; steps in quick succession happen one per frame', () => {
  let frame = 0;
  const steps = createSteps(() => frame++);
  for (let i = 0; i < 3; i++) steps.ask();
  expect(frame).toBe(0);
  const seen: number[] = [];
  for (const late of [false, false, true, true, false, false, false]) {
    seen.push(frame);
    steps.afterFrame(late);
  }
  expect(seen).toEqual([0, 1, 2, 2, 2, 3, 3]);
  steps.ask();
  expect(frame).toBe(4);
});

test('steps that wait are dropped when time goes elsewhere', () => {
  let frame = 0;
  const steps = createSteps(() => frame++);
  steps.ask();
  steps.ask();
  steps.restart();
  steps.afterFrame(false);
  expect(frame).toBe(0);
});
