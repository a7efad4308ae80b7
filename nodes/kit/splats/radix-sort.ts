/** Sorts keys of 32 bits. Equal keys keep their order, so the result depends on nothing but the keys. */
export interface RadixSort {
  /** The keys to sort, one per element. Sorting changes them. */
  readonly keys: Uint32Array;
  /** Writes the indices of the elements in ascending order of their keys. Allocates nothing. */
  into(order: Uint32Array): void;
}

/** Three passes over 11, 11 and 10 bits: fewer passes would need tables that do not fit a cache. */
const BITS = 11;
const BUCKETS = 1 << BITS;

/**
 * Creates a sort of a fixed number of elements, with all the memory that it needs.
 *
 * @example
 * const sort = createRadixSort(2);
 * sort.keys.set([7, 3]);
 * sort.into(order); // order: 1, 0
 */
export function createRadixSort(count: number): RadixSort {
  const keys = new Uint32Array(count);
  const otherKeys = new Uint32Array(count);
  const otherOrder = new Uint32Array(count);
  const starts = new Uint32Array(3 * BUCKETS);

  /** Moves the elements from one pair of arrays to the other by the bits above `shift`. */
  const pass = (shift: number, from: Uint32Array, fromOrder: Uint32Array | null, to: Uint32Array, toOrder: Uint32Array): void => {
    const first = (shift / BITS) * BUCKETS;
    for (let i = 0; i < count; i++) {
      const key = from[i] as number;
      const bucket = first + ((key >>> shift) & (BUCKETS - 1));
      const at = starts[bucket] as number;
      starts[bucket] = at + 1;
      to[at] = key;
      toOrder[at] = fromOrder === null ? i : (fromOrder[i] as number);
    }
  };
  return {
    keys,
    into: (order) => {
      starts.fill(0);
      for (let i = 0; i < count; i++) {
        const key = keys[i] as number;
        for (let nth = 0; nth < 3; nth++) {
          const bucket = nth * BUCKETS + ((key >>> (nth * BITS)) & (BUCKETS - 1));
          starts[bucket] = (starts[bucket] as number) + 1;
        }
      }
      for (let nth = 0; nth < 3; nth++) {
        let sum = 0;
        for (let bucket = nth * BUCKETS; bucket < (nth + 1) * BUCKETS; bucket++) {
          const size = starts[bucket] as number;
          starts[bucket] = sum;
          sum += size;
        }
      }
      pass(0, keys, null, otherKeys, order);
      pass(BITS, otherKeys, order, keys, otherOrder);
      pass(2 * BITS, keys, otherOrder, otherKeys, order);
    },
  };
}
