/**
 * Improved gradient noise (Ken Perlin, "Improving Noise", SIGGRAPH 2002) in three dimensions. Values are in [-1, 1] except for rare,
 * tiny overshoots. At integer coordinates it is 0, with one of twelve gradients. A hash of the coordinates and the seed replaces
 * Perlin's permutation table, so the noise does not repeat.
 */
export function gradientNoise(x: number, y: number, z: number, seed: number): number {
  const x0 = Math.floor(x);
  const y0 = Math.floor(y);
  const z0 = Math.floor(z);
  const fx = x - x0;
  const fy = y - y0;
  const fz = z - z0;
  const u = fade(fx);
  const v = fade(fy);
  const w = fade(fz);
  const lowNear = alongEdge(x0, y0, z0, fx, fy, fz, u, seed);
  const highNear = alongEdge(x0, y0 + 1, z0, fx, fy - 1, fz, u, seed);
  const lowFar = alongEdge(x0, y0, z0 + 1, fx, fy, fz - 1, u, seed);
  const highFar = alongEdge(x0, y0 + 1, z0 + 1, fx, fy - 1, fz - 1, u, seed);
  const near = lowNear + v * (highNear - lowNear);
  const far = lowFar + v * (highFar - lowFar);
  return near + w * (far - near);
}

/** Interpolates between a corner and its neighbor in x; `fx` to `fz` is the offset from that corner. */
function alongEdge(x0: number, y0: number, z0: number, fx: number, fy: number, fz: number, u: number, seed: number): number {
  const left = slope(hash(x0, y0, z0, seed), fx, fy, fz);
  return left + u * (slope(hash(x0 + 1, y0, z0, seed), fx - 1, fy, fz) - left);
}

/** The quintic fade function: first and second derivatives are 0 at both ends. */
function fade(t: number): number {
  return t * t * t * (t * (t * 6 - 15) + 10);
}

/** The dot product of an offset and the gradient of a corner: one of the twelve edge directions of a cube, four of them twice. */
function slope(hash: number, x: number, y: number, z: number): number {
  const h = hash & 15;
  const u = h < 8 ? x : y;
  const v = h < 4 ? y : h === 12 || h === 14 ? x : z;
  return ((h & 1) === 0 ? u : -u) + ((h & 2) === 0 ? v : -v);
}

/** The finalizer of MurmurHash3 (Austin Appleby, public domain). */
function hash(x: number, y: number, z: number, seed: number): number {
  let h = Math.imul(x, 0x27d4eb2d) ^ Math.imul(y, 0x165667b1) ^ Math.imul(z, 0x1b873593) ^ Math.imul(seed, 0x9e3779b1);
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return (h ^ (h >>> 16)) >>> 0;
}
