import { describe, expect, test } from '@jest/globals';
import { type BoardLabel, createBoard } from './board.ts';

function labelAt(distanceM: number, bottom: number, more: Partial<BoardLabel> = {}): BoardLabel {
  const box = { left: -0.1, right: 0.1, bottom, top: bottom + 0.1 };
  return { overlap: 'move', wants: true, distanceM, atMost: 10, box, shown: false, moved: 0, prepare: () => {}, ...more };
}

function arrange(...labels: BoardLabel[]) {
  const board = createBoard();
  for (const label of labels) board.add(label);
  for (const label of labels) board.arrange(label, {} as never);
  return labels.map(({ shown, moved }) => (shown ? Math.round(moved * 1000) / 1000 : 'hidden'));
}

describe('labels among each other', () => {
  test('a farther label moves up over a nearer one, whatever their order', () => {
    expect(arrange(labelAt(1, 0), labelAt(2, 0.05))).toEqual([0, 0.056]);
    expect(arrange(labelAt(2, 0.05), labelAt(1, 0))).toEqual([0.056, 0]);
    expect(arrange(labelAt(1, 0), labelAt(2, 0.05), labelAt(3, 0.02))).toEqual([0, 0.056, 0.192]);
  });

  test('labels that do not overlap, and those that may, stay', () => {
    expect(arrange(labelAt(1, 0), labelAt(2, 0.11))).toEqual([0, 0]);
    expect(arrange(labelAt(1, 0), labelAt(2, 0, { overlap: 'allow' }))).toEqual([0, 0]);
  });

  test('is hidden where it would have to move too far, or is not to move', () => {
    expect(arrange(labelAt(1, 0), labelAt(2, 0), labelAt(3, 0), labelAt(4, 0))).toEqual([0, 0.106, 0.212, 'hidden']);
    expect(arrange(labelAt(1, 0), labelAt(2, 0.05, { overlap: 'hide' }))).toEqual([0, 'hidden']);
  });

  test('a label without a pose takes no room, and one that was removed no longer does', () => {
    expect(arrange(labelAt(1, 0, { wants: false }), labelAt(2, 0))).toEqual(['hidden', 0]);
    const near = labelAt(1, 0);
    const far = labelAt(2, 0);
    const board = createBoard();
    board.add(near);
    board.add(far);
    board.remove(near);
    board.arrange(far, {} as never);
    expect(far.moved).toBe(0);
  });

  test('the nearest are shown where there are at most so many', () => {
    const labels = [5, 1, 4, 2, 3].map((distanceM) => labelAt(distanceM, distanceM, { atMost: 2 }));
    expect(arrange(...labels)).toEqual(['hidden', 0, 'hidden', 0, 'hidden']);
  });

  test('is arranged once per frame', () => {
    let prepared = 0;
    const labels = [1, 2, 3].map((distanceM) => labelAt(distanceM, distanceM, { prepare: () => void prepared++ }));
    const board = createBoard();
    for (const label of labels) board.add(label);
    for (let frame = 0; frame < 4; frame++) for (const label of labels) board.arrange(label, {} as never);
    expect(prepared).toBe(3 * 4);
  });
});
