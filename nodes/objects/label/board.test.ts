import { describe, expect, test } from '@jest/globals';
import { type BoardLabel, createBoard } from './board.ts';

function labelAt(distanceM: number, bottom: number, more: Partial<BoardLabel> = {}): BoardLabel {
  const box = { left: -0.1, right: 0.1, bottom, top: bottom + 0.1 };
  const hidden = { shown: false, moved: 0, mayLook: false, unseenFrames: Number.POSITIVE_INFINITY };
  return { overlap: 'move', looks: true, wants: true, distanceM, atMost: 10, box, ...hidden, prepare: () => {}, ...more };
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

  describe('looking for what hides them', () => {
    function watch(labels: readonly BoardLabel[]) {
      const board = createBoard();
      for (const label of labels) board.add(label);
      return () => {
        for (const label of labels) board.arrange(label, {} as never);
        return labels.flatMap(({ mayLook, distanceM }) => (mayLook ? [distanceM] : []));
      };
    }

    test('four labels look per frame, and each in turn', () => {
      const frame = watch(Array.from({ length: 10 }, (_, i) => labelAt(i + 1, i)));
      const looks = Array.from({ length: 30 }, frame);
      expect(looks.filter(({ length }) => length !== 4)).toEqual([]);
      // Ten labels by four: none waits longer than three frames.
      for (let i = 0; i + 3 <= looks.length; i++) expect(new Set(looks.slice(i, i + 3).flat()).size).toBe(10);
    });

    test('one that appears looks at once, hidden ones and those that never fade do not', () => {
      const late = labelAt(50, 50, { wants: false });
      const plain = labelAt(60, 60, { looks: false });
      const frame = watch([...Array.from({ length: 8 }, (_, i) => labelAt(i + 1, i)), late, plain]);
      for (let i = 0; i < 3; i++) expect(frame()).not.toContain(50);
      late.wants = true;
      expect(frame()).toContain(50);
      for (let i = 0; i < 4; i++) expect(frame()).not.toContain(60);
    });
  });
});
