/** Random numbers in [0, 1) for the suffixes of new node ids. */
export const pageRandom: () => number = Math.random;
