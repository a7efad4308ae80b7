import { Sphere, Vec3 } from 'cannon-es';
import type { Contact, ContactList } from './contact.ts';
import { centerOf } from './find-contacts.ts';
import { HullShape } from './hull-shape.ts';
import { MARGIN_M, type RigidBody } from './rigid-body.ts';
import type { VoxelGrid } from './voxel-grid.ts';

/** Cosine of the angle between the normals of two nearby contacts below which they count as one contact. */
const SAME_NORMAL = 0.97;

// Filled and read within one call.
const scratchCenter = new Vec3();

/**
 * Finds the contacts of a body with the occupied voxels around it. A sphere is tested against the nearest point of each voxel; a polyhedron
 * at points that are spread over its surface (McNeely et al., “Six Degree-of-Freedom Haptic Rendering Using Voxel Sampling”, 1999). Faces
 * between two occupied voxels give no contacts, so bodies slide over them, and no contact pushes a body to a side from which the voxel was
 * never seen.
 *
 * @param room The static body that stands for the room.
 */
export function collideVoxels(room: RigidBody, grid: VoxelGrid, body: RigidBody, stepS: number, out: ContactList): void {
  const marginM = MARGIN_M + Math.min(body.velocity.length() * stepS, body.innerRadiusM);
  for (let i = 0; i < body.shapes.length; i++) {
    const shape = body.shapes[i];
    const first = out.count;
    if (shape instanceof Sphere) {
      centerOf(body, i, scratchCenter);
      meet(room, grid, body, scratchCenter, shape.radius, marginM, first, shape.radius, out);
    } else if (shape instanceof HullShape) {
      for (const point of shape.surfacePoints(grid.settings.edgeM / 2)) {
        meet(room, grid, body, point, 0, marginM, first, grid.settings.edgeM, out);
      }
    }
  }
}

/**
 * Tests a sphere, or a point if the radius is 0, against the occupied voxels around it.
 *
 * @param nearM Contacts with the same normal that are nearer to each other than this count as one.
 */
function meet(
  room: RigidBody,
  grid: VoxelGrid,
  body: RigidBody,
  { x, y, z }: Vec3,
  radiusM: number,
  marginM: number,
  first: number,
  nearM: number,
  out: ContactList,
): void {
  const { edgeM } = grid.settings;
  const reach = radiusM + marginM;
  const lowX = Math.floor((x - reach) / edgeM);
  const lowY = Math.floor((y - reach) / edgeM);
  const lowZ = Math.floor((z - reach) / edgeM);
  const highX = Math.floor((x + reach) / edgeM);
  const highY = Math.floor((y + reach) / edgeM);
  const highZ = Math.floor((z + reach) / edgeM);
  for (let vx = lowX; vx <= highX; vx++) {
    for (let vy = lowY; vy <= highY; vy++) {
      for (let vz = lowZ; vz <= highZ; vz++) {
        if (grid.isOccupied(vx, vy, vz)) meetVoxel(room, grid, body, x, y, z, vx, vy, vz, radiusM, reach, first, nearM, out);
      }
    }
  }
}

function meetVoxel(
  room: RigidBody,
  grid: VoxelGrid,
  body: RigidBody,
  x: number,
  y: number,
  z: number,
  vx: number,
  vy: number,
  vz: number,
  radiusM: number,
  reach: number,
  first: number,
  nearM: number,
  out: ContactList,
): void {
  const { edgeM } = grid.settings;
  // From the middle of the voxel, in half edges.
  const half = edgeM / 2;
  const px = x - (vx + 0.5) * edgeM;
  const py = y - (vy + 0.5) * edgeM;
  const pz = z - (vz + 0.5) * edgeM;
  const qx = Math.min(Math.max(px, -half), half);
  const qy = Math.min(Math.max(py, -half), half);
  const qz = Math.min(Math.max(pz, -half), half);
  let dx = px - qx;
  let dy = py - qy;
  let dz = pz - qz;
  let distance = Math.hypot(dx, dy, dz);
  if (distance > reach) return;
  if (distance > 1e-9) {
    // The neighbor on that side is nearer.
    if (dx !== 0 && grid.isOccupied(vx + Math.sign(dx), vy, vz)) return;
    if (dy !== 0 && grid.isOccupied(vx, vy + Math.sign(dy), vz)) return;
    if (dz !== 0 && grid.isOccupied(vx, vy, vz + Math.sign(dz))) return;
    dx /= distance;
    dy /= distance;
    dz /= distance;
    if (!grid.isOutward(vx, vy, vz, dx, dy, dz)) return;
  } else {
    // Inside: out through the nearest free face that was seen.
    let least = Number.POSITIVE_INFINITY;
    for (let axis = 0; axis < 3; axis++) {
      for (let sign = -1; sign <= 1; sign += 2) {
        const nx = axis === 0 ? sign : 0;
        const ny = axis === 1 ? sign : 0;
        const nz = axis === 2 ? sign : 0;
        const depth = half - (nx * px + ny * py + nz * pz);
        if (depth >= least || grid.isOccupied(vx + nx, vy + ny, vz + nz) || !grid.isOutward(vx, vy, vz, nx, ny, nz)) continue;
        least = depth;
        dx = nx;
        dy = ny;
        dz = nz;
      }
    }
    if (least === Number.POSITIVE_INFINITY) return;
    distance = -least;
  }
  const gapM = distance - radiusM;
  // On the voxel: the center moved back to its surface.
  const cx = x - dx * distance;
  const cy = y - dy * distance;
  const cz = z - dz * distance;
  for (let i = first; i < out.count; i++) {
    const other = out.at(i);
    if (other.nx * dx + other.ny * dy + other.nz * dz < SAME_NORMAL || distanceTo(other, room, cx, cy, cz) > nearM) continue;
    if (other.gapM <= gapM) return;
  }
  const contact = out.add(room, body, cx, cy, cz, dx, dy, dz, gapM);
  contact.isRoom = true;
  contact.keepsOrder = radiusM > 0;
}

function distanceTo({ ax, ay, az }: Contact, { position: p }: RigidBody, x: number, y: number, z: number): number {
  return Math.hypot(ax + p.x - x, ay + p.y - y, az + p.z - z);
}

/**
 * The distance along a ray to the first occupied voxel (Amanatides and Woo, “A Fast Voxel Traversal Algorithm for Ray Tracing”, 1987);
 * infinite if there is none.
 */
export function castOnVoxels(grid: VoxelGrid, from: Vec3, direction: Vec3, lengthM: number, normal: Vec3): number {
  const { edgeM } = grid.settings;
  let x = Math.floor(from.x / edgeM);
  let y = Math.floor(from.y / edgeM);
  let z = Math.floor(from.z / edgeM);
  const sx = Math.sign(direction.x);
  const sy = Math.sign(direction.y);
  const sz = Math.sign(direction.z);
  const first = (p: number, v: number, d: number) => (d === 0 ? Number.POSITIVE_INFINITY : ((v + (d > 0 ? 1 : 0)) * edgeM - p) / d);
  let tx = first(from.x, x, direction.x);
  let ty = first(from.y, y, direction.y);
  let tz = first(from.z, z, direction.z);
  const ex = edgeM / Math.abs(direction.x);
  const ey = edgeM / Math.abs(direction.y);
  const ez = edgeM / Math.abs(direction.z);
  for (let t = 0; t <= lengthM; ) {
    if (tx <= ty && tx <= tz) {
      x += sx;
      t = tx;
      tx += ex;
      normal.set(-sx, 0, 0);
    } else if (ty <= tz) {
      y += sy;
      t = ty;
      ty += ey;
      normal.set(0, -sy, 0);
    } else {
      z += sz;
      t = tz;
      tz += ez;
      normal.set(0, 0, -sz);
    }
    if (t <= lengthM && grid.isOccupied(x, y, z) && grid.isOutward(x, y, z, normal.x, normal.y, normal.z)) return t;
  }
  return Number.POSITIVE_INFINITY;
}
