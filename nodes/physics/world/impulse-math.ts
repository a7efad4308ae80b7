import type { RigidBody } from './rigid-body.ts';

/** Two bodies, and the vectors from their centers of mass to a point, world axes. */
export interface Levers {
  a: RigidBody;
  b: RigidBody;
  ax: number;
  ay: number;
  az: number;
  bx: number;
  by: number;
  bz: number;
}

/**
 * The effective mass at the point: impulse divided by the change of relative velocity along a unit direction; 0 if both bodies are
 * immovable.
 */
export function effectiveMass(l: Readonly<Levers>, x: number, y: number, z: number): number {
  const k = l.a.invMass + l.b.invMass + angularPart(l.a, l.ax, l.ay, l.az, x, y, z) + angularPart(l.b, l.bx, l.by, l.bz, x, y, z);
  return k > 0 ? 1 / k : 0;
}

function angularPart({ inverseWorld: m }: RigidBody, rx: number, ry: number, rz: number, x: number, y: number, z: number): number {
  const cx = ry * z - rz * y;
  const cy = rz * x - rx * z;
  const cz = rx * y - ry * x;
  return cx * (m.xx * cx + m.xy * cy + m.xz * cz) + cy * (m.xy * cx + m.yy * cy + m.yz * cz) + cz * (m.xz * cx + m.yz * cy + m.zz * cz);
}

/** Applies an impulse to `b` and the opposite impulse to `a`, at the point. */
export function applyImpulse(l: Readonly<Levers>, x: number, y: number, z: number): void {
  push(l.a, l.ax, l.ay, l.az, -x, -y, -z);
  push(l.b, l.bx, l.by, l.bz, x, y, z);
}

/** Applies an impulse to one body, at a point relative to its center of mass. */
export function push(body: RigidBody, rx: number, ry: number, rz: number, x: number, y: number, z: number): void {
  const { velocity: v, angularVelocity: w, invMass, inverseWorld: m } = body;
  if (invMass === 0) return;
  v.x += invMass * x;
  v.y += invMass * y;
  v.z += invMass * z;
  const cx = ry * z - rz * y;
  const cy = rz * x - rx * z;
  const cz = rx * y - ry * x;
  w.x += m.xx * cx + m.xy * cy + m.xz * cz;
  w.y += m.xy * cx + m.yy * cy + m.yz * cz;
  w.z += m.xz * cx + m.yz * cy + m.zz * cz;
}

/** Writes the velocity of `b` relative to `a` at the point. */
export function readRelativeVelocity(out: { x: number; y: number; z: number }, { a, b, ax, ay, az, bx, by, bz }: Levers): void {
  const { velocity: v, angularVelocity: w } = a;
  const { velocity: s, angularVelocity: t } = b;
  out.x = s.x + t.y * bz - t.z * by - (v.x + w.y * az - w.z * ay);
  out.y = s.y + t.z * bx - t.x * bz - (v.y + w.z * ax - w.x * az);
  out.z = s.z + t.x * by - t.y * bx - (v.z + w.x * ay - w.y * ax);
}
