import { Quaternion, Shape, Vec3 } from 'cannon-es';
import type { Triple } from '../../kit/physics.ts';

/** A flat face: its corners counterclockwise from outside, and its plane `normal · x = offset`. */
export interface HullFace {
  readonly corners: readonly Vec3[];
  readonly normal: Vec3;
  offset: number;
}

/** An edge with the faces at its sides. */
export interface HullEdge {
  readonly from: Vec3;
  readonly to: Vec3;
  readonly left: HullFace;
  readonly right: HullFace;
}

/**
 * A convex polyhedron in world space: its vertices are moved in place once per step. Unlike the polyhedron of cannon-es it knows the two
 * faces of each edge, which a separating-axis test needs, and clips against the neighbors of an edge instead of those of a vertex.
 */
export class HullShape extends Shape {
  readonly vertices: readonly Vec3[];
  readonly faces: readonly HullFace[];
  readonly edges: readonly HullEdge[];
  readonly center = new Vec3();
  readonly innerRadiusM: number;
  private readonly position = new Vec3();
  private readonly rotation = new Quaternion();
  private pointsLocal: readonly Vec3[] = [];
  private points: readonly Vec3[] = [];
  private spacingM = 0;
  private readonly local: readonly Vec3[];
  private readonly normals: readonly Vec3[];
  private readonly centerLocal = new Vec3();

  /**
   * Creates the shape.
   *
   * @param originM The center of mass, which becomes the origin.
   */
  constructor(vertices: readonly Triple[], faces: readonly (readonly number[])[], originM: Vec3) {
    super({ type: Shape.types.CONVEXPOLYHEDRON });
    this.local = vertices.map(([x, y, z]) => new Vec3(x, y, z).vsub(originM));
    this.vertices = this.local.map((vertex) => vertex.clone());
    for (const vertex of this.local) this.centerLocal.vadd(vertex, this.centerLocal);
    this.centerLocal.scale(1 / Math.max(this.local.length, 1), this.centerLocal);
    this.normals = faces.map((face) => normalOf(face.flatMap((i) => this.local[i] ?? [])));
    this.faces = faces.map((face) => ({ corners: face.flatMap((i) => this.vertices[i] ?? []), normal: new Vec3(), offset: 0 }));
    this.edges = edgesOf(this.faces);
    this.place(new Vec3(), new Quaternion());
    let inner = Number.POSITIVE_INFINITY;
    for (const face of this.faces) inner = Math.min(inner, face.offset - face.normal.dot(this.center));
    this.innerRadiusM = Number.isFinite(inner) ? Math.max(inner, 0) : 0;
    this.updateBoundingSphereRadius();
  }

  /** Moves the world-space vertices to a pose of the body. */
  place(position: Vec3, quaternion: Quaternion): void {
    this.position.copy(position);
    this.rotation.copy(quaternion);
    for (let i = 0; i < this.local.length; i++) {
      const local = this.local[i];
      const vertex = this.vertices[i];
      if (!local || !vertex) continue;
      quaternion.vmult(local, vertex);
      vertex.vadd(position, vertex);
    }
    for (let i = 0; i < this.faces.length; i++) {
      const face = this.faces[i];
      const normal = this.normals[i];
      const corner = face?.corners[0];
      if (!face || !normal || !corner) continue;
      quaternion.vmult(normal, face.normal);
      face.offset = face.normal.dot(corner);
    }
    quaternion.vmult(this.centerLocal, this.center);
    this.center.vadd(position, this.center);
  }

  /** Points of the surface in world space, about as far apart as `spacingM`: all vertices, and points on edges and faces. */
  surfacePoints(spacingM: number): readonly Vec3[] {
    if (this.spacingM !== spacingM) {
      this.spacingM = spacingM;
      this.pointsLocal = spread(this.local, this.faces, this.vertices, spacingM);
      this.points = this.pointsLocal.map((point) => point.clone());
    }
    for (let i = 0; i < this.points.length; i++) {
      const local = this.pointsLocal[i];
      const point = this.points[i];
      if (!local || !point) continue;
      this.rotation.vmult(local, point);
      point.vadd(this.position, point);
    }
    return this.points;
  }

  override updateBoundingSphereRadius(): void {
    this.boundingSphereRadius = Math.sqrt(this.local.reduce((most, vertex) => Math.max(most, vertex.lengthSquared()), 0));
  }

  override calculateWorldAABB(position: Vec3, quaternion: Quaternion, min: Vec3, max: Vec3): void {
    min.set(Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY);
    max.set(Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY);
    for (const vertex of this.local) {
      quaternion.vmult(vertex, scratch);
      scratch.vadd(position, scratch);
      min.set(Math.min(min.x, scratch.x), Math.min(min.y, scratch.y), Math.min(min.z, scratch.z));
      max.set(Math.max(max.x, scratch.x), Math.max(max.y, scratch.y), Math.max(max.z, scratch.z));
    }
  }

  override volume(): number {
    return 0;
  }

  override calculateLocalInertia(_mass: number, target: Vec3): void {
    target.setZero();
  }
}

const scratch = new Vec3();

/** The normal of a polygon by Newell's method, which is exact for any flat polygon. */
function normalOf(corners: readonly Vec3[]): Vec3 {
  const normal = new Vec3();
  corners.forEach((a, i) => {
    const b = corners[(i + 1) % corners.length] ?? a;
    normal.x += (a.y - b.y) * (a.z + b.z);
    normal.y += (a.z - b.z) * (a.x + b.x);
    normal.z += (a.x - b.x) * (a.y + b.y);
  });
  normal.normalize();
  return normal;
}

function edgesOf(faces: readonly HullFace[]): HullEdge[] {
  const edges: HullEdge[] = [];
  const open = new Map<Vec3, Map<Vec3, HullFace>>();
  for (const face of faces) {
    face.corners.forEach((from, i) => {
      const to = face.corners[(i + 1) % face.corners.length] ?? from;
      const other = open.get(to)?.get(from);
      if (other) edges.push({ from, to, left: face, right: other });
      else open.set(from, (open.get(from) ?? new Map<Vec3, HullFace>()).set(to, face));
    });
  }
  return edges;
}

/** The most points that `surfacePoints` returns for one hull. */
const MAX_POINTS = 300;

/** Spreads points over a polyhedron: its vertices, and a grid over each triangle of each face. */
function spread(local: readonly Vec3[], faces: readonly HullFace[], vertices: readonly Vec3[], spacingM: number): Vec3[] {
  const points = local.map((vertex) => vertex.clone());
  for (const { corners } of faces) {
    const [a, ...rest] = corners.flatMap((corner) => local[vertices.indexOf(corner)] ?? []);
    for (let i = 0; a && i + 1 < rest.length; i++) {
      const b = rest[i];
      const c = rest[i + 1];
      if (!b || !c) continue;
      const steps = Math.min(Math.ceil(Math.max(a.distanceTo(b), a.distanceTo(c), b.distanceTo(c)) / spacingM), 24);
      for (let u = 0; u <= steps; u++) {
        for (let v = 0; u + v <= steps && points.length < MAX_POINTS; v++) {
          const s = u / steps;
          const t = v / steps;
          points.push(
            new Vec3(
              a.x + s * (b.x - a.x) + t * (c.x - a.x),
              a.y + s * (b.y - a.y) + t * (c.y - a.y),
              a.z + s * (b.z - a.z) + t * (c.z - a.z),
            ),
          );
        }
      }
    }
  }
  return points;
}
