import { Sphere, Vec3 } from 'cannon-es';
import type { ContactList } from './contact.ts';
import { addFaceContacts } from './convex-contacts.ts';
import type { HullShape } from './hull-shape.ts';
import type { MeshShape } from './mesh-shape.ts';
import type { RigidBody } from './rigid-body.ts';
import { addKept, beginSphere, meetTriangle } from './sphere-triangles.ts';

/** A thin polyhedron that is deeper than this behind a triangle belongs to its other side, meters. */
const DEEPEST_M = 0.02;

// Filled and read within one call.
const scratchMin = new Vec3();
const scratchMax = new Vec3();
const face = { corners: [new Vec3(), new Vec3(), new Vec3()], normal: new Vec3(), offset: 0 };

/**
 * Finds the contacts of a sphere or polyhedron with the triangles around it. A triangle pushes to the side on which the middle of the other
 * shape is.
 *
 * @param owner The body of the triangles.
 * @param center The middle of the sphere, world space.
 */
export function collideMesh(
  owner: RigidBody,
  mesh: MeshShape,
  body: RigidBody,
  shape: Sphere | HullShape,
  center: Vec3,
  marginM: number,
  out: ContactList,
): void {
  if (shape instanceof Sphere) collideSphere(owner, mesh, body, shape, center, marginM, out);
  else collideHull(owner, mesh, body, shape, marginM, out);
}

function collideSphere(
  owner: RigidBody,
  mesh: MeshShape,
  body: RigidBody,
  { radius }: Sphere,
  center: Vec3,
  marginM: number,
  out: ContactList,
): void {
  const reach = radius + marginM;
  mesh.findNear(
    scratchMin.set(center.x - reach, center.y - reach, center.z - reach),
    scratchMax.set(center.x + reach, center.y + reach, center.z + reach),
  );
  beginSphere(center, radius, marginM);
  for (const triangle of mesh.found) {
    mesh.read(triangle);
    const [ax = 0, ay = 0, az = 0, bx = 0, by = 0, bz = 0, cx = 0, cy = 0, cz = 0] = mesh.corners;
    const [ox, oy, oz] = [center.x - ax, center.y - ay, center.z - az];
    meetTriangle(ax, ay, az, bx - ax, by - ay, bz - az, cx - ax, cy - ay, cz - az, ox, oy, oz, radius);
  }
  addKept(owner, body, false, out);
}

function collideHull(owner: RigidBody, mesh: MeshShape, body: RigidBody, hull: HullShape, marginM: number, out: ContactList): void {
  scratchMin.set(Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY);
  scratchMax.set(Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY);
  for (const { x, y, z } of hull.vertices) {
    scratchMin.set(Math.min(scratchMin.x, x - marginM), Math.min(scratchMin.y, y - marginM), Math.min(scratchMin.z, z - marginM));
    scratchMax.set(Math.max(scratchMax.x, x + marginM), Math.max(scratchMax.y, y + marginM), Math.max(scratchMax.z, z + marginM));
  }
  mesh.findNear(scratchMin, scratchMax);
  for (const triangle of mesh.found) {
    mesh.read(triangle);
    if (readFace(mesh.corners, hull.center))
      addFaceContacts(owner, face, body, hull, false, marginM, out, Math.max(hull.innerRadiusM, DEEPEST_M));
  }
}

/** Reads a triangle as a face whose normal points to the side of a point. Returns false for a triangle without area. */
function readFace(corners: Float64Array, { x, y, z }: Vec3): boolean {
  const [ax = 0, ay = 0, az = 0, bx = 0, by = 0, bz = 0, cx = 0, cy = 0, cz = 0] = corners;
  const [a, b, c] = face.corners;
  const { normal } = face;
  const [ux, uy, uz, vx, vy, vz] = [bx - ax, by - ay, bz - az, cx - ax, cy - ay, cz - az];
  normal.set(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
  const length = normal.length();
  if (!(length > 1e-12)) return false;
  const isFront = normal.x * (x - ax) + normal.y * (y - ay) + normal.z * (z - az) >= 0;
  normal.scale((isFront ? 1 : -1) / length, normal);
  a?.set(ax, ay, az);
  (isFront ? b : c)?.set(bx, by, bz);
  (isFront ? c : b)?.set(cx, cy, cz);
  face.offset = normal.x * ax + normal.y * ay + normal.z * az;
  return true;
}
