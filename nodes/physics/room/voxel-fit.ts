import { FILE_HEADER_BYTES, FILE_VOXEL_BYTES } from '../../kit/voxel-file.ts';

/** Half the side of the window of voxels to which planes are fitted. */
const REACH = 2;
const WINDOW = (2 * REACH + 1) ** 3;
/** The least number of points that determine a plane well. */
const LEAST_POINTS = 4;
/** Points within this many standard deviations agree with a plane; the deviation is at least a quarter of an edge. */
const AGREES = 2;
const SIGMA_OF_MEDIAN = 1.4826;
const LEAST_SIGMA = 0.25;
/** Jacobi rotations of a 3×3 matrix; after four sweeps it is diagonal to the last bits. */
const SWEEPS = 4;

/** Returns the number of a voxel, -1 if it is not occupied. */
export type FindVoxel = (x: number, y: number, z: number) => number;

/** The plane around a voxel: a point and the unit normal, whose side is not defined. Lengths are in edges of a voxel. */
export interface VoxelFit {
  readonly mx: number;
  readonly my: number;
  readonly mz: number;
  readonly nx: number;
  readonly ny: number;
  readonly nz: number;
  /**
   * Fits the plane to the points of the occupied voxels around a voxel. A window that spans an edge has two surfaces: planes are fitted
   * to the whole window and to its halves, and the one with the least median residual wins (least median of squares, Rousseeuw 1984),
   * because more than half of the window belongs to the surface at its center. Voxels that were seen from the other side, as those of the
   * lower face of a table, do not count.
   *
   * @param view A voxel file.
   * @param n Number of the voxel in the file; x, y and z are its indices.
   * @returns False if there are too few points.
   */
  at(view: DataView, n: number, x: number, y: number, z: number, find: FindVoxel): boolean;
}

/** One direction of each pair of opposite ones towards the faces, edges and corners of a cube; both halves are tried. */
const HALVES: readonly (readonly [number, number, number])[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
  [1, 1, 0],
  [1, -1, 0],
  [1, 0, 1],
  [1, 0, -1],
  [0, 1, 1],
  [0, 1, -1],
];

export function createVoxelFit(): VoxelFit {
  /** Points from the center of the voxel, edges. */
  const points = new Float64Array(3 * WINDOW);
  const residuals = new Float64Array(WINDOW);
  /** 1 for the points to which a plane is fitted. */
  const members = new Uint8Array(WINDOW);
  /** Covariance, row by row, and the rotation to its axes. */
  const matrix = new Float64Array(9);
  const axes = new Float64Array(9);
  const plane = { cx: 0, cy: 0, cz: 0, nx: 0, ny: 1, nz: 0 };
  const best = { ...plane };
  let count = 0;

  function gather(view: DataView, n: number, x: number, y: number, z: number, find: FindVoxel): void {
    const own = FILE_HEADER_BYTES + FILE_VOXEL_BYTES * n;
    const [sx, sy, sz] = [view.getInt8(own + 7), view.getInt8(own + 8), view.getInt8(own + 9)];
    count = 0;
    for (let i = -REACH; i <= REACH; i++) {
      for (let j = -REACH; j <= REACH; j++) {
        for (let k = -REACH; k <= REACH; k++) {
          const other = i === 0 && j === 0 && k === 0 ? n : find(x + i, y + j, z + k);
          if (other < 0) continue;
          const o = FILE_HEADER_BYTES + FILE_VOXEL_BYTES * other;
          if (other !== n && sx * view.getInt8(o + 7) + sy * view.getInt8(o + 8) + sz * view.getInt8(o + 9) < 0) continue;
          points[3 * count] = i + view.getUint8(o + 10) / 255 - 0.5;
          points[3 * count + 1] = j + view.getUint8(o + 11) / 255 - 0.5;
          points[3 * count + 2] = k + view.getUint8(o + 12) / 255 - 0.5;
          count++;
        }
      }
    }
  }
  /** The distance of a point from a plane. */
  function residualAt(i: number, { cx, cy, cz, nx, ny, nz }: typeof plane): number {
    return Math.abs(nx * (at(points, 3 * i) - cx) + ny * (at(points, 3 * i + 1) - cy) + nz * (at(points, 3 * i + 2) - cz));
  }
  /** Fits `plane` to the points on one side of the center, or to those that lie within a distance of `best`. */
  function fitPlane(half: readonly [number, number, number] | undefined, sign: number, withinOfBest: number): boolean {
    let n = 0;
    let x = 0;
    let y = 0;
    let z = 0;
    for (let i = 0; i < count; i++) {
      const side = half ? half[0] * at(points, 3 * i) + half[1] * at(points, 3 * i + 1) + half[2] * at(points, 3 * i + 2) : 0;
      const isIn = sign * side >= -0.5 && (withinOfBest === Number.POSITIVE_INFINITY || residualAt(i, best) <= withinOfBest);
      members[i] = isIn ? 1 : 0;
      if (!isIn) continue;
      n++;
      x += at(points, 3 * i);
      y += at(points, 3 * i + 1);
      z += at(points, 3 * i + 2);
    }
    if (n < LEAST_POINTS) return false;
    plane.cx = x / n;
    plane.cy = y / n;
    plane.cz = z / n;
    matrix.fill(0);
    for (let i = 0; i < count; i++) {
      if (members[i] === 0) continue;
      for (let a = 0; a < 3; a++) {
        const p = at(points, 3 * i + a) - (a === 0 ? plane.cx : a === 1 ? plane.cy : plane.cz);
        for (let b = 0; b < 3; b++) {
          const q = at(points, 3 * i + b) - (b === 0 ? plane.cx : b === 1 ? plane.cy : plane.cz);
          matrix[3 * a + b] = at(matrix, 3 * a + b) + p * q;
        }
      }
    }
    return writeNormal();
  }
  /** Writes the axis of least variance as the normal. Returns false if the points lie on a line. */
  function writeNormal(): boolean {
    diagonalize(matrix, axes);
    let least = 0;
    for (let a = 1; a < 3; a++) if (at(matrix, 4 * a) < at(matrix, 4 * least)) least = a;
    let middle = Number.POSITIVE_INFINITY;
    for (let a = 0; a < 3; a++) if (a !== least) middle = Math.min(middle, at(matrix, 4 * a));
    plane.nx = at(axes, least);
    plane.ny = at(axes, 3 + least);
    plane.nz = at(axes, 6 + least);
    return middle > 1e-3 && middle > 1.5 * at(matrix, 4 * least);
  }
  function medianResidual(): number {
    for (let i = 0; i < count; i++) residuals[i] = residualAt(i, plane);
    const used = residuals.subarray(0, count);
    used.sort();
    return used[count >> 1] ?? Number.POSITIVE_INFINITY;
  }
  const fit = {
    mx: 0,
    my: 0,
    mz: 0,
    nx: 0,
    ny: 1,
    nz: 0,
    at: (view: DataView, n: number, x: number, y: number, z: number, find: FindVoxel) => {
      gather(view, n, x, y, z, find);
      if (count < LEAST_POINTS) return false;
      let least = Number.POSITIVE_INFINITY;
      for (let half = -1; half < HALVES.length; half++) {
        for (let sign = half < 0 ? 1 : -1; sign <= 1; sign += 2) {
          if (!fitPlane(HALVES[half], sign, Number.POSITIVE_INFINITY)) continue;
          const median = medianResidual();
          if (median >= least) continue;
          least = median;
          Object.assign(best, plane);
        }
      }
      if (least === Number.POSITIVE_INFINITY) return false;
      if (fitPlane(undefined, 1, AGREES * Math.max(LEAST_SIGMA, SIGMA_OF_MEDIAN * least))) Object.assign(best, plane);
      fit.mx = x + 0.5 + best.cx;
      fit.my = y + 0.5 + best.cy;
      fit.mz = z + 0.5 + best.cz;
      fit.nx = best.nx;
      fit.ny = best.ny;
      fit.nz = best.nz;
      return true;
    },
  };
  return fit;
}

/** Diagonalizes a symmetric 3×3 matrix by Jacobi rotations; the columns of `axes` are the directions of its diagonal. */
function diagonalize(m: Float64Array, axes: Float64Array): void {
  axes.fill(0);
  for (let a = 0; a < 3; a++) axes[4 * a] = 1;
  for (let sweep = 0; sweep < SWEEPS; sweep++) {
    for (let p = 0; p < 2; p++) {
      for (let q = p + 1; q < 3; q++) {
        const off = at(m, 3 * p + q);
        if (Math.abs(off) < 1e-12) continue;
        const angle = 0.5 * Math.atan2(2 * off, at(m, 4 * q) - at(m, 4 * p));
        const c = Math.cos(angle);
        const s = Math.sin(angle);
        for (let k = 0; k < 3; k++) turn(m, 3 * k + p, 3 * k + q, c, s);
        for (let k = 0; k < 3; k++) turn(m, 3 * p + k, 3 * q + k, c, s);
        for (let k = 0; k < 3; k++) turn(axes, 3 * k + p, 3 * k + q, c, s);
      }
    }
  }
}

function turn(m: Float64Array, i: number, j: number, c: number, s: number): void {
  const a = at(m, i);
  const b = at(m, j);
  m[i] = c * a - s * b;
  m[j] = s * a + c * b;
}

function at(list: Float64Array, i: number): number {
  return list[i] ?? 0;
}
