import { Matrix4 } from 'three';

export type Pattern = 'row' | 'grid' | 'ring' | 'scatter';

export interface Arrangement {
  readonly count: number;
  readonly stepM: ArrayLike<number>;
  readonly radiusM: number;
  readonly turnRad: number;
  readonly sizeSpread: number;
  readonly seed: number;
}

/** The golden angle: the angle between consecutive points of a spiral that covers a disk evenly with any number of points (Vogel 1979). */
const GOLDEN_ANGLE = 2.399963229728653;

// Filled and read within one call.
const scratchTurn = new Matrix4();

/** Computes the transform of a copy relative to the first: rotated and scaled about its own origin. */
export function placeCopy(pattern: Pattern, index: number, arrangement: Arrangement, into: Matrix4): Matrix4 {
  const { count, stepM, radiusM, turnRad, sizeSpread, seed } = arrangement;
  const stepX = stepM[0] ?? 0;
  const stepY = stepM[1] ?? 0;
  const stepZ = stepM[2] ?? 0;
  const size = 1 + sizeSpread * (2 * chance(seed, index, 0) - 1);
  switch (pattern) {
    case 'row':
      return place(into, index * stepX, index * stepY, index * stepZ, index * turnRad, size);
    case 'grid': {
      const columns = Math.ceil(Math.sqrt(count));
      const rows = Math.ceil(count / columns);
      const column = (index % columns) - (columns - 1) / 2;
      const row = Math.floor(index / columns) - (rows - 1) / 2;
      return place(into, column * stepX, 0, row * stepZ, index * turnRad, size);
    }
    case 'ring': {
      const angle = (2 * Math.PI * index) / count;
      return place(into, radiusM * Math.sin(angle), 0, radiusM * Math.cos(angle), angle + index * turnRad, size);
    }
    case 'scatter': {
      const away = radiusM * Math.sqrt((index + chance(seed, index, 1)) / count);
      const angle = index * GOLDEN_ANGLE + chance(seed, index, 2) + seed;
      return place(into, away * Math.sin(angle), 0, away * Math.cos(angle), turnRad * (2 * chance(seed, index, 3) - 1), size);
    }
  }
}

function place(into: Matrix4, x: number, y: number, z: number, turnRad: number, size: number): Matrix4 {
  return into.makeScale(size, size, size).premultiply(scratchTurn.makeRotationY(turnRad)).setPosition(x, y, z);
}

/**
 * A pseudorandom number in [0, 1): a hash of the arguments. It does not depend on the number of copies, so existing copies keep their
 * places (lowbias32, Wellons 2018).
 */
function chance(seed: number, index: number, which: number): number {
  let bits = (Math.imul(seed | 0, 0x9e3779b1) ^ Math.imul(index * 4 + which + 1, 0x85ebca6b)) | 0;
  bits = Math.imul(bits ^ (bits >>> 16), 0x7feb352d);
  bits = Math.imul(bits ^ (bits >>> 15), 0x846ca68b);
  return ((bits ^ (bits >>> 16)) >>> 0) / 2 ** 32;
}
