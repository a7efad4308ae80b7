import type { MeasuredRoom } from '../../kit/hit-test.ts';
import { FILE_HEADER_BYTES, FILE_VOXEL_BYTES } from '../../kit/voxel-file.ts';
import { createVoxelFit } from './voxel-fit.ts';

/** Rays end after this distance. */
const FAR_M = 20;
/** A ray meets the surface of a voxel at most this far from its center along each axis, edges: a little beyond its faces. */
const NEAR_EDGES = 0.75;
/** Rays that come from behind what was seen pass: cosine between the direction to the cameras and the direction against the ray. */
const LEAST_FACING = -0.1;

/** Answers rays by a copy of the voxels of a room, because the grid itself is in the worker of the physics world. */
export interface VoxelRays extends MeasuredRoom {
  /** Replaces the copy by the voxels of a file that the physics world has written. The bytes are kept until the next call. */
  read(file: Uint8Array): void;
  /** Empties the copy. */
  clear(): void;
  readonly isEmpty: boolean;
}

/**
 * Follows a ray from voxel to voxel (Amanatides and Woo, “A Fast Voxel Traversal Algorithm for Ray Tracing”, 1987). At an occupied voxel the
 * ray meets the plane that fits the measured points around it.
 */
export function createVoxelRays(): VoxelRays {
  let view: DataView = new DataView(new ArrayBuffer(0));
  let count = 0;
  let edgeM = 1;
  /** Numbers of voxels plus 1, by hash of the index; 0 is free. The length is a power of two. */
  let table = new Int32Array(2);
  /** The box of all voxels, indices; the upper ones are included. */
  const low = [0, 0, 0];
  const high = [0, 0, 0];
  const fit = createVoxelFit();

  const byteOf = (n: number): number => FILE_HEADER_BYTES + FILE_VOXEL_BYTES * n;
  function slotOf(x: number, y: number, z: number): number {
    return (Math.imul(x, 73856093) ^ Math.imul(y, 19349663) ^ Math.imul(z, 83492791)) & (table.length - 1);
  }
  /** The number of a voxel; -1 if it is not occupied. */
  function find(x: number, y: number, z: number): number {
    for (let slot = slotOf(x, y, z); ; slot = (slot + 1) & (table.length - 1)) {
      const n = (table[slot] ?? 0) - 1;
      if (n < 0) return -1;
      const o = byteOf(n);
      if (view.getInt16(o, true) === x && view.getInt16(o + 2, true) === y && view.getInt16(o + 4, true) === z) return n;
    }
  }
  function add(n: number): void {
    const o = byteOf(n);
    const [x, y, z] = [view.getInt16(o, true), view.getInt16(o + 2, true), view.getInt16(o + 4, true)];
    let slot = slotOf(x, y, z);
    while (table[slot] !== 0) slot = (slot + 1) & (table.length - 1);
    table[slot] = n + 1;
    for (let axis = 0; axis < 3; axis++) {
      const v = axis === 0 ? x : axis === 1 ? y : z;
      low[axis] = Math.min(low[axis] ?? v, v);
      high[axis] = Math.max(high[axis] ?? v, v);
    }
  }

  return {
    isAsked: false,
    get isEmpty() {
      return count === 0;
    },
    read: (file) => {
      view = new DataView(file.buffer, file.byteOffset, file.byteLength);
      edgeM = view.getFloat32(8, true);
      count = view.getUint32(12, true);
      let size = 16;
      while (size < 2 * count) size *= 2;
      if (table.length < size) table = new Int32Array(size);
      else table.fill(0);
      low.fill(Number.POSITIVE_INFINITY);
      high.fill(Number.NEGATIVE_INFINITY);
      for (let n = 0; n < count; n++) add(n);
    },
    clear: () => {
      count = 0;
    },
    cast: (out, { ox, oy, oz, dx, dy, dz }) => {
      if (count === 0) return false;
      let near = 0;
      let far = FAR_M;
      for (let axis = 0; axis < 3; axis++) {
        const o = axis === 0 ? ox : axis === 1 ? oy : oz;
        const d = axis === 0 ? dx : axis === 1 ? dy : dz;
        const a = (low[axis] ?? 0) * edgeM - o;
        const b = ((high[axis] ?? 0) + 1) * edgeM - o;
        if (d === 0) {
          if (a > 0 || b < 0) return false;
          continue;
        }
        near = Math.max(near, Math.min(a / d, b / d));
        far = Math.min(far, Math.max(a / d, b / d));
      }
      if (!(near <= far)) return false;
      // A little inside, so that rounding does not begin before the box.
      const start = near + 1e-6;
      let x = Math.floor((ox + start * dx) / edgeM);
      let y = Math.floor((oy + start * dy) / edgeM);
      let z = Math.floor((oz + start * dz) / edgeM);
      let tx = borderAt(x, ox, dx);
      let ty = borderAt(y, oy, dy);
      let tz = borderAt(z, oz, dz);
      for (let t = near; t <= far; ) {
        const n = find(x, y, z);
        if (n >= 0 && facing(n, -dx, -dy, -dz) > LEAST_FACING && fit.at(view, n, x, y, z, find)) {
          const speed = fit.nx * dx + fit.ny * dy + fit.nz * dz;
          const gap = fit.nx * (fit.mx * edgeM - ox) + fit.ny * (fit.my * edgeM - oy) + fit.nz * (fit.mz * edgeM - oz);
          const meets = gap / speed;
          const inX = Math.abs((ox + meets * dx) / edgeM - x - 0.5);
          const inY = Math.abs((oy + meets * dy) / edgeM - y - 0.5);
          const inZ = Math.abs((oz + meets * dz) / edgeM - z - 0.5);
          if (meets > 0 && Math.max(inX, inY, inZ) <= NEAR_EDGES) {
            out.distanceM = meets;
            const sign = speed > 0 ? -1 : 1;
            out.nx = sign * fit.nx;
            out.ny = sign * fit.ny;
            out.nz = sign * fit.nz;
            return true;
          }
        }
        if (tx <= ty && tx <= tz) {
          x += Math.sign(dx);
          t = tx;
          tx = borderAt(x, ox, dx);
        } else if (ty <= tz) {
          y += Math.sign(dy);
          t = ty;
          ty = borderAt(y, oy, dy);
        } else {
          z += Math.sign(dz);
          t = tz;
          tz = borderAt(z, oz, dz);
        }
      }
      return false;
    },
  };

  /** Where a ray leaves a voxel along an axis. */
  function borderAt(v: number, from: number, direction: number): number {
    return direction === 0 ? Number.POSITIVE_INFINITY : ((v + (direction > 0 ? 1 : 0)) * edgeM - from) / direction;
  }
  /** The cosine between a unit direction and the mean direction to the cameras that saw a voxel; 1 where that is unknown. */
  function facing(n: number, x: number, y: number, z: number): number {
    const o = byteOf(n);
    const [sx, sy, sz] = [view.getInt8(o + 7), view.getInt8(o + 8), view.getInt8(o + 9)];
    const length = Math.hypot(sx, sy, sz);
    return length === 0 ? 1 : (sx * x + sy * y + sz * z) / length;
  }
}
