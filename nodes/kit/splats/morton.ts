import { createRadixSort } from './radix-sort.ts';
import { WORDS } from './splats.ts';

/** Cells per axis: 10 bits of each make 30 bits. */
const CELLS = 1024;

/**
 * Sorts packed splats along a Morton curve, in which neighbors in space are close.
 *
 * @param words The packed splats, of which the first three words are the position.
 * @param count Number of splats.
 * @returns The indices of the splats in their new order.
 *
 * @example
 * const order = sortedByMorton(splats.words, splats.count);
 */
export function sortedByMorton(words: Uint32Array<ArrayBuffer>, count: number): Uint32Array {
  const positions = new Float32Array(words.buffer, words.byteOffset, words.length);
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < count; i++) {
    for (let axis = 0; axis < 3; axis++) {
      const x = positions[i * WORDS + axis] ?? 0;
      least[axis] = Math.min(least[axis] ?? x, x);
      most[axis] = Math.max(most[axis] ?? x, x);
    }
  }
  const sort = createRadixSort(count);
  for (let i = 0; i < count; i++) {
    let code = 0;
    for (let axis = 0; axis < 3; axis++) {
      const from = least[axis] ?? 0;
      const extent = (most[axis] ?? 0) - from || 1;
      const cell = Math.min(CELLS - 1, Math.floor((((positions[i * WORDS + axis] ?? 0) - from) / extent) * CELLS));
      code |= spread(cell) << axis;
    }
    sort.keys[i] = code;
  }
  const order = new Uint32Array(count);
  sort.into(order);
  return order;
}

/** Puts two zero bits between the bits of a number of 10 bits. */
function spread(cell: number): number {
  let bits = cell;
  bits = (bits | (bits << 16)) & 0x030000ff;
  bits = (bits | (bits << 8)) & 0x0300f00f;
  bits = (bits | (bits << 4)) & 0x030c30c3;
  return (bits | (bits << 2)) & 0x09249249;
}
