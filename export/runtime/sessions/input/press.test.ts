import { expect, test } from '@jest/globals';
import { beginPress, createPress, endPress, type Press, showPhase } from './press.ts';

function phases(press: Press, count: number): string[] {
  return Array.from({ length: count }, () => {
    showPhase(press);
    return press.pointer.phase;
  });
}

test('a press shows its start, its end and what lies between', () => {
  const press = createPress();
  beginPress(press);
  const first = phases(press, 3);
  endPress(press, 'end', true);
  expect([first, phases(press, 2)]).toEqual([
    ['start', 'hold', 'hold'],
    ['end', 'hover'],
  ]);
});

test('a press between two frames is seen in two', () => {
  const press = createPress();
  beginPress(press);
  endPress(press, 'end', true);
  expect(phases(press, 3)).toEqual(['start', 'end', 'hover']);
});

test('a canceled press is no tap', () => {
  const press = createPress();
  beginPress(press);
  endPress(press, 'cancel', true);
  expect([phases(press, 2), press.pointer.tapped]).toEqual([['start', 'cancel'], false]);
});

test('only the first end counts, and none without a press', () => {
  const press = createPress();
  endPress(press, 'end', true);
  beginPress(press);
  endPress(press, 'cancel', false);
  endPress(press, 'end', true);
  expect(phases(press, 2)).toEqual(['start', 'cancel']);
});

test('a claim ends in the frame after the press', () => {
  const press = createPress();
  beginPress(press);
  showPhase(press);
  press.pointer.owner = press;
  endPress(press, 'end', false);
  showPhase(press);
  expect([press.pointer.phase, press.pointer.owner]).toEqual(['end', press]);
  showPhase(press);
  expect(press.pointer.owner).toBe(null);
});
