import { createRadixSort } from './radix-sort.ts';

/** Sorts splats from far to near. */
export interface DepthSort {
  /**
   * Writes the indices of the splats, the farthest along the direction first. Splats at the same depth keep their order.
   *
   * @param direction The direction of view in the space of the positions, of any length.
   * @param order Receives one index per splat.
   */
  sort(direction: ArrayLike<number>, order: Uint32Array): void;
}

/**
 * Creates the sort of some splats. The position of the eye is no input: it adds the same to all depths.
 *
 * @param positions x, y, z of each splat; not changed.
 *
 * @example
 * createDepthSort(positions).sort([0, 0, -1], order);
 */
export function createDepthSort(positions: Float32Array): DepthSort {
  const count = positions.length / 3;
  const sorter = createRadixSort(count);
  const depths = new Float32Array(count);
  const bits = new Uint32Array(depths.buffer);
  return {
    sort: (direction, order) => {
      const x = direction[0] ?? 0;
      const y = direction[1] ?? 0;
      const z = direction[2] ?? 0;
      for (let i = 0; i < count; i++) {
        const along = x * (positions[3 * i] as number) + y * (positions[3 * i + 1] as number) + z * (positions[3 * i + 2] as number);
        // Makes -0 to 0, which it equals.
        depths[i] = along + 0;
      }
      // The bits of a float ascend with it if it is positive, and descend if it is negative. Here the farthest has the smallest key.
      for (let i = 0; i < count; i++) {
        const float = bits[i] as number;
        sorter.keys[i] = float >>> 31 === 1 ? float : ~(float | 0x80000000);
      }
      sorter.into(order);
    },
  };
}
