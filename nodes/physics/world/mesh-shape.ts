import { Quaternion, Shape, Vec3 } from 'cannon-es';

/** Leaves of the tree have at most this many triangles. */
const LEAF = 4;
/** Numbers of a node of the tree: its bounding box. */
const BOX = 6;
const MAX_DEPTH = 64;

// Filled and read within one call.
const scratchInverse = new Quaternion();
const scratchVector = new Vec3();
const scratchTo = new Vec3();
const stack = new Int32Array(2 * MAX_DEPTH);
const lower = new Float64Array(3);
const upper = new Float64Array(3);

/**
 * The triangles of a body that no force moves, in a tree of bounding boxes (median split along the longest axis). They have no inside: both
 * sides collide.
 */
export class MeshShape extends Shape {
  readonly position = new Vec3();
  readonly rotation = new Quaternion();
  /** The corners of the triangle that `read` has read, world space. */
  readonly corners = new Float64Array(9);
  /** The triangles that `findNear` has found. */
  readonly found: number[] = [];
  private readonly positionsM: Float32Array;
  private readonly indices: Uint32Array;
  private readonly originM: Vec3;
  /** Numbers of the triangles, such that those of a node are neighbors. */
  private readonly order: Uint32Array;
  private readonly boxes: number[] = [];
  /** Of each node: the index of its first triangle in `order`, and their number; of an inner node -1 and its second child. */
  private readonly spans: number[] = [];

  /** Creates the shape. `originM` becomes the origin. */
  constructor(positionsM: Float32Array, indices: Uint32Array, originM: Vec3) {
    super({ type: Shape.types.TRIMESH });
    this.positionsM = positionsM;
    this.indices = indices;
    this.originM = originM.clone();
    const middles = new Float64Array(indices.length - (indices.length % 3));
    const whole = Array.from({ length: middles.length / 3 }, (_, i) => i).filter((triangle) => this.isTriangle(triangle));
    for (const triangle of whole)
      for (let k = 0; k < 9; k++) middles[3 * triangle + (k % 3)] = (middles[3 * triangle + (k % 3)] ?? 0) + this.at(triangle, k);
    this.order = Uint32Array.from(whole);
    if (whole.length > 0) this.split(0, whole.length, middles);
    this.updateBoundingSphereRadius();
  }

  place(position: Vec3, quaternion: Quaternion): void {
    this.position.copy(position);
    this.rotation.copy(quaternion);
  }

  /** Writes the triangles whose boxes meet a box in world space to `found`. */
  findNear(min: Vec3, max: Vec3): void {
    this.found.length = 0;
    if (this.spans.length === 0) return;
    this.toLocal(min, max);
    let depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const node = stack[--depth] ?? 0;
      if (!this.meets(node)) continue;
      const first = this.spans[2 * node] ?? 0;
      const second = this.spans[2 * node + 1] ?? 0;
      if (first >= 0) for (let i = 0; i < second; i++) this.found.push(this.order[first + i] ?? 0);
      else {
        stack[depth++] = second;
        stack[depth++] = node + 1;
      }
    }
  }

  /** Reads the corners of a triangle to `corners`. */
  read(triangle: number): void {
    for (let k = 0; k < 9; k += 3) {
      scratchVector.set(this.at(triangle, k), this.at(triangle, k + 1), this.at(triangle, k + 2));
      this.rotation.vmult(scratchVector, scratchVector);
      this.corners[k] = scratchVector.x + this.position.x;
      this.corners[k + 1] = scratchVector.y + this.position.y;
      this.corners[k + 2] = scratchVector.z + this.position.z;
    }
  }

  /**
   * The distance along a ray to the nearest triangle, whose normal against the ray is written (Möller and Trumbore, “Fast, Minimum Storage
   * Ray/Triangle Intersection”, 1997); infinite if there is none within `farM`.
   */
  cast(from: Vec3, direction: Vec3, farM: number, normal: Vec3): number {
    scratchTo.set(from.x + farM * direction.x, from.y + farM * direction.y, from.z + farM * direction.z);
    this.findNear(
      new Vec3(Math.min(from.x, scratchTo.x), Math.min(from.y, scratchTo.y), Math.min(from.z, scratchTo.z)),
      new Vec3(Math.max(from.x, scratchTo.x), Math.max(from.y, scratchTo.y), Math.max(from.z, scratchTo.z)),
    );
    let nearest = Number.POSITIVE_INFINITY;
    for (const triangle of this.found) {
      this.read(triangle);
      const [ax = 0, ay = 0, az = 0, bx = 0, by = 0, bz = 0, cx = 0, cy = 0, cz = 0] = this.corners;
      const [ux, uy, uz, vx, vy, vz] = [bx - ax, by - ay, bz - az, cx - ax, cy - ay, cz - az];
      const px = direction.y * vz - direction.z * vy;
      const py = direction.z * vx - direction.x * vz;
      const pz = direction.x * vy - direction.y * vx;
      const determinant = ux * px + uy * py + uz * pz;
      if (Math.abs(determinant) < 1e-12) continue;
      const [tx, ty, tz] = [from.x - ax, from.y - ay, from.z - az];
      const s = (tx * px + ty * py + tz * pz) / determinant;
      const qx = ty * uz - tz * uy;
      const qy = tz * ux - tx * uz;
      const qz = tx * uy - ty * ux;
      const t = (direction.x * qx + direction.y * qy + direction.z * qz) / determinant;
      const distance = (vx * qx + vy * qy + vz * qz) / determinant;
      if (s < 0 || t < 0 || s + t > 1 || distance < 0 || distance >= Math.min(nearest, farM)) continue;
      nearest = distance;
      normal.set(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
      normal.normalize();
      if (normal.dot(direction) > 0) normal.scale(-1, normal);
    }
    return nearest;
  }

  override updateBoundingSphereRadius(): void {
    // Called by the constructor of the parent, too, before there is a tree.
    const [ax = 0, ay = 0, az = 0, bx = 0, by = 0, bz = 0] = this.boxes ?? [];
    this.boundingSphereRadius = Math.hypot(
      Math.max(Math.abs(ax), Math.abs(bx)),
      Math.max(Math.abs(ay), Math.abs(by)),
      Math.max(Math.abs(az), Math.abs(bz)),
    );
  }

  override calculateWorldAABB(position: Vec3, quaternion: Quaternion, min: Vec3, max: Vec3): void {
    const [ax = 0, ay = 0, az = 0, bx = 0, by = 0, bz = 0] = this.boxes;
    min.set(Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY);
    max.set(Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY);
    for (let corner = 0; corner < 8; corner++) {
      scratchVector.set(corner & 1 ? bx : ax, corner & 2 ? by : ay, corner & 4 ? bz : az);
      quaternion.vmult(scratchVector, scratchVector);
      scratchVector.vadd(position, scratchVector);
      min.set(Math.min(min.x, scratchVector.x), Math.min(min.y, scratchVector.y), Math.min(min.z, scratchVector.z));
      max.set(Math.max(max.x, scratchVector.x), Math.max(max.y, scratchVector.y), Math.max(max.z, scratchVector.z));
    }
  }

  override volume(): number {
    return 0;
  }

  override calculateLocalInertia(_mass: number, target: Vec3): void {
    target.setZero();
  }

  /** A coordinate of a corner: k is three times the corner, plus the axis. */
  private at(triangle: number, k: number): number {
    const vertex = this.indices[3 * triangle + Math.floor(k / 3)] ?? 0;
    const axis = k % 3;
    return (
      (this.positionsM[3 * vertex + axis] ?? Number.NaN) - (axis === 0 ? this.originM.x : axis === 1 ? this.originM.y : this.originM.z)
    );
  }

  private isTriangle(triangle: number): boolean {
    for (let k = 0; k < 9; k++) if (!Number.isFinite(this.at(triangle, k))) return false;
    return true;
  }

  /** Appends the node of a part of `order`, and its children after it. */
  private split(first: number, count: number, middles: Float64Array): void {
    const node = this.spans.length / 2;
    this.spans.push(first, count);
    const box = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY];
    box.push(...box.map((x) => -x));
    const part = this.order.subarray(first, first + count);
    for (const triangle of part) {
      for (let k = 0; k < 9; k++) {
        const axis = k % 3;
        const value = this.at(triangle, k);
        box[axis] = Math.min(box[axis] ?? 0, value);
        box[axis + 3] = Math.max(box[axis + 3] ?? 0, value);
      }
    }
    this.boxes.push(...box);
    if (count <= LEAF) return;
    const size = (axis: number) => (box[axis + 3] ?? 0) - (box[axis] ?? 0);
    const axis = size(0) >= size(1) && size(0) >= size(2) ? 0 : size(1) >= size(2) ? 1 : 2;
    part.sort((a, b) => (middles[3 * a + axis] ?? 0) - (middles[3 * b + axis] ?? 0) || a - b);
    const half = count >> 1;
    this.spans[2 * node] = -1;
    this.split(first, half, middles);
    this.spans[2 * node + 1] = this.spans.length / 2;
    this.split(first + half, count - half, middles);
  }

  /** Writes the box around a box in world space, in the axes of the mesh, to `lower` and `upper`. */
  private toLocal(min: Vec3, max: Vec3): void {
    this.rotation.conjugate(scratchInverse);
    lower.fill(Number.POSITIVE_INFINITY);
    upper.fill(Number.NEGATIVE_INFINITY);
    for (let corner = 0; corner < 8; corner++) {
      scratchVector.set(corner & 1 ? max.x : min.x, corner & 2 ? max.y : min.y, corner & 4 ? max.z : min.z);
      scratchVector.vsub(this.position, scratchVector);
      scratchInverse.vmult(scratchVector, scratchVector);
      const { x, y, z } = scratchVector;
      lower[0] = Math.min(lower[0] ?? 0, x);
      lower[1] = Math.min(lower[1] ?? 0, y);
      lower[2] = Math.min(lower[2] ?? 0, z);
      upper[0] = Math.max(upper[0] ?? 0, x);
      upper[1] = Math.max(upper[1] ?? 0, y);
      upper[2] = Math.max(upper[2] ?? 0, z);
    }
  }

  private meets(node: number): boolean {
    for (let axis = 0; axis < 3; axis++) {
      const o = BOX * node + axis;
      if ((this.boxes[o] ?? 0) > (upper[axis] ?? 0) || (this.boxes[o + 3] ?? 0) < (lower[axis] ?? 0)) return false;
    }
    return true;
  }
}
