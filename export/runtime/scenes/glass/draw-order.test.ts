import { describe, expect, test } from '@jest/globals';
import { arrange, MAX_BATCHES, type OrderedItem } from './draw-order.ts';

interface Named extends OrderedItem {
  readonly name: string;
}

function item(name: string, depthM: number, x: number, more: Partial<Named> = {}): Named {
  const box = { left: x - 0.1, right: x + 0.1, bottom: -0.1, top: 0.1 };
  return { name, isGlass: true, isLast: false, renderOrder: 0, isVisible: true, depthM, box, batch: -1, ...more };
}

function batches(...items: Named[]): Record<string, number> {
  const count = arrange(items);
  return { ...Object.fromEntries(items.map(({ name, batch }) => [name, batch])), count };
}

describe('the order in which glass is drawn', () => {
  test('has no batch without visible glass', () => {
    expect(batches(item('a', 1, 0, { isVisible: false }), item('veil', 2, 0, { isGlass: false }))).toEqual({ a: 0, veil: 0, count: 0 });
  });

  test('is from far to near; blended surfaces before the first glass are drawn with all others', () => {
    const items = [item('near', 1, 0, { isGlass: false }), item('glass', 2, 0), item('far', 3, 0, { isGlass: false })];
    expect(batches(...items)).toEqual({ near: 1, glass: 1, far: 0, count: 1 });
  });

  test('draws anew what is behind glass only where that may be seen', () => {
    expect(batches(item('a', 3, -0.5), item('b', 2, 0.5), item('c', 1, 0.6))).toEqual({ a: 1, b: 1, c: 2, count: 2 });
    expect(batches(item('a', 3, 0), item('veil', 2, 0.5, { isGlass: false }), item('b', 1, 0.5))).toEqual({
      a: 1,
      veil: 1,
      b: 2,
      count: 2,
    });
  });

  test('puts a given order before distance, and depth alone at the very end', () => {
    const last = item('depth', 9, 0, { isGlass: false, isLast: true, renderOrder: 1e9 });
    expect(batches(last, item('first', 1, 0, { renderOrder: -1 }), item('second', 2, 0))).toEqual({
      depth: 2,
      first: 1,
      second: 2,
      count: 2,
    });
  });

  test('lets the farthest share an image where there are many', () => {
    const items = Array.from({ length: 9 }, (_, i) => item(`${i}`, 9 - i, 0));
    expect(arrange(items)).toBe(MAX_BATCHES);
    expect(items.map(({ batch }) => batch)).toEqual([1, 1, 1, 1, 1, 2, 3, 4, 5]);
  });
});
