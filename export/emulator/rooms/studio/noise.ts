/** Hashes lattice points to [0, 1) with integer arithmetic, so every machine gives the same textures. */
export function hash(x: number, y: number, seed: number): number {
  let h = Math.imul(x, 0x27d4eb2d) ^ Math.imul(y, 0x165667b1) ^ Math.imul(seed, 0x9e3779b1);
  h = Math.imul(h ^ (h >>> 15), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return ((h ^ (h >>> 16)) >>> 0) / 4294967296;
}

/** Value noise in [0, 1) that repeats every `periodX` by `periodY` cells. */
export function noise(x: number, y: number, periodX: number, periodY: number, seed: number): number {
  const x0 = Math.floor(x);
  const y0 = Math.floor(y);
  const u = fade(x - x0);
  const v = fade(y - y0);
  const left = wrap(x0, periodX);
  const right = wrap(x0 + 1, periodX);
  const bottom = wrap(y0, periodY);
  const top = wrap(y0 + 1, periodY);
  const below = hash(left, bottom, seed);
  const above = hash(left, top, seed);
  const low = below + (hash(right, bottom, seed) - below) * u;
  const high = above + (hash(right, top, seed) - above) * u;
  return low + (high - low) * v;
}

/** Three octaves of `noise`, in [0, 1). */
export function fractal(x: number, y: number, periodX: number, periodY: number, seed: number): number {
  return (
    0.57 * noise(x, y, periodX, periodY, seed) +
    0.29 * noise(x * 2, y * 2, periodX * 2, periodY * 2, seed + 1) +
    0.14 * noise(x * 4, y * 4, periodX * 4, periodY * 4, seed + 2)
  );
}

function fade(t: number): number {
  return t * t * (3 - 2 * t);
}

function wrap(i: number, period: number): number {
  return ((i % period) + period) % period;
}
