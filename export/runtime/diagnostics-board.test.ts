import { expect, test } from '@jest/globals';
import { createDiagnosticsBoard } from './diagnostics-board.ts';

test('tells all there is whenever it changes, and only then', () => {
  const told: string[][] = [];
  const board = createDiagnosticsBoard((diagnostics) => told.push(diagnostics.map((d) => `${d.nodeId}: ${d.message}`)));
  board.report('a', { code: 'SCR030', severity: 'error', message: 'gone' });
  board.report('a', { code: 'SCR030', severity: 'error', message: 'gone' });
  board.report('b', { code: 'SCR032', severity: 'error', message: 'broken' });
  board.clear('a');
  board.clear('a');
  expect(told).toEqual([['a: gone'], ['a: gone', 'b: broken'], ['b: broken']]);
});
