export interface SeededRandom {
  /** Returns the next random number, uniform in [0, 1). */
  readonly next: () => number;
  /** Starts the sequence over. */
  reset(): void;
}

/** Creates a separate sequence for each node, so that adding a node does not change the random numbers of others. */
export function createRandom(seed: number, name: string): SeededRandom {
  const start = hash(name, seed);
  let state = start;
  return {
    next: () => {
      // Mulberry32 (Tommy Ettinger, public domain): 32 bits of state suffice for scattering and jitter.
      state = (state + 0x6d2b79f5) | 0;
      let t = Math.imul(state ^ (state >>> 15), 1 | state);
      t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
      return ((t ^ (t >>> 14)) >>> 0) / 4_294_967_296;
    },
    reset: () => {
      state = start;
    },
  };
}

/** Hashes a name and a seed by FNV-1a over the name's UTF-16 code units. */
function hash(name: string, seed: number): number {
  let h = 0x811c9dc5 ^ seed;
  for (let i = 0; i < name.length; i++) h = Math.imul(h ^ name.charCodeAt(i), 0x01000193);
  return h | 0;
}
