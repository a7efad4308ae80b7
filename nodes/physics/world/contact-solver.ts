import type { Contact, ContactList } from './contact.ts';
import { applyImpulse, effectiveMass, readRelativeVelocity } from './impulse-math.ts';
import type { RigidBody } from './rigid-body.ts';

/** Contacts in which bodies approach more slowly do not bounce, meters per second. */
const BOUNCE_MPS = 0.15;
/** The greatest speed at which overlapping bodies are moved apart, meters per second. */
const PUSH_MPS = 2;
/**
 * Stiffness of contacts in cycles per second, and damping as a fraction of critical damping. A substep that is too long for the stiffness
 * lowers it.
 */
const CONTACT_HZ = 100;
const DAMPING_RATIO = 10;
/** Overlap that is not corrected, so that contacts persist, meters. */
const SLOP_M = 2e-4;

// Filled and read within one call.
const relative = { x: 0, y: 0, z: 0 };

/** The coefficients of a soft constraint for one time step. */
export interface Softness {
  readonly biasRate: number;
  readonly massScale: number;
  readonly impulseScale: number;
}

/**
 * Computes the coefficients of a soft constraint, which acts like a damped spring and is stable at any step length (Catto, “Soft
 * Constraints”, GDC 2011).
 *
 * @param stepS Seconds.
 */
export function softness(frequencyHz: number, dampingRatio: number, stepS: number): Softness {
  const omega = 2 * Math.PI * frequencyHz;
  const a1 = 2 * dampingRatio + stepS * omega;
  const a2 = stepS * omega * a1;
  const a3 = 1 / (1 + a2);
  return { biasRate: omega / a1, massScale: a2 * a3, impulseScale: a3 };
}

/** Prepares masses and tangents. The impulses are those of the step before, if the contact was found again. */
export function prepareContacts(contacts: ContactList): void {
  for (let i = 0; i < contacts.count; i++) {
    const c = contacts.at(i);
    chooseTangents(c);
    c.normalMass = effectiveMass(c, c.nx, c.ny, c.nz);
    c.tangentMass = effectiveMass(c, c.tx, c.ty, c.tz);
    c.otherTangentMass = effectiveMass(c, c.ux, c.uy, c.uz);
    const { inverseWorld: p } = c.a;
    const { inverseWorld: q } = c.b;
    const turn = (p.xx + p.yy + p.zz + q.xx + q.yy + q.zz) / 3;
    c.rollingMass = turn > 0 ? 1 / turn : 0;
    c.normalImpulse = 0;
    c.tangentImpulse = 0;
    c.otherTangentImpulse = 0;
    c.rollX = 0;
    c.rollY = 0;
    c.rollZ = 0;
    c.maxImpulse = 0;
    c.approach = 0;
    setLocalPoint(c);
  }
}

/** Applies the accumulated impulses again, so that a resting contact needs few iterations. Call it once per substep. */
export function warmStart(contacts: ContactList): void {
  for (let i = 0; i < contacts.count; i++) {
    const c = contacts.at(i);
    const { normalImpulse: n, tangentImpulse: t, otherTangentImpulse: u } = c;
    applyImpulse(c, n * c.nx + t * c.tx + u * c.ux, n * c.ny + t * c.ty + u * c.uy, n * c.nz + t * c.tz + u * c.uz);
    turn(c, c.rollX, c.rollY, c.rollZ);
  }
}

/**
 * Solves each contact once: its normal impulse, then its friction, which is bounded by the normal impulse.
 *
 * @param usesBias Whether overlapping bodies are pushed apart. The pass after the positions have moved does not push, and removes the
 * velocity of the push.
 * @param stepS Seconds of a substep.
 */
export function solveContacts(contacts: ContactList, stepS: number, usesBias: boolean): void {
  const hz = Math.min(CONTACT_HZ, 0.5 / stepS);
  const soft = softness(hz, DAMPING_RATIO, stepS);
  const stiff = softness(2 * hz, DAMPING_RATIO, stepS);
  for (let i = 0; i < contacts.count; i++) {
    const c = contacts.at(i);
    const { a, b } = c;
    const isFixed = !a.isDynamic || !b.isDynamic;
    const { biasRate, massScale, impulseScale } = isFixed && !c.isRoom ? stiff : soft;

    const gapM = c.gapM + gapChange(c, a, b);
    readRelativeVelocity(relative, c);
    const speed = relative.x * c.nx + relative.y * c.ny + relative.z * c.nz;

    let bias = 0;
    let mass = 1;
    let keep = 0;
    if (gapM > 0) bias = gapM / stepS;
    else if (usesBias) {
      bias = Math.max(biasRate * Math.min(gapM + SLOP_M, 0), -PUSH_MPS);
      mass = massScale;
      keep = impulseScale;
    }
    const wanted = -c.normalMass * mass * (speed + bias) - keep * c.normalImpulse;
    const total = Math.max(c.normalImpulse + wanted, 0);
    const given = total - c.normalImpulse;
    if (given > 0 && c.maxImpulse === 0 && !c.wasMatched) c.approach = Math.min(c.approach, speed);
    c.normalImpulse = total;
    c.maxImpulse = Math.max(c.maxImpulse, total);
    applyImpulse(c, given * c.nx, given * c.ny, given * c.nz);

    solveFriction(c);
    if (c.rollingM > 0) solveRolling(c, a, b);
  }
}

/** The distance by which the gap of a contact has grown since the contact was found. */
function gapChange(c: Contact, a: RigidBody, b: RigidBody): number {
  const p = b.movedM;
  const q = a.movedM;
  const s = b.turnedRad;
  const t = a.turnedRad;
  return (
    (p.x + s.y * c.bz - s.z * c.by - (q.x + t.y * c.az - t.z * c.ay)) * c.nx +
    (p.y + s.z * c.bx - s.x * c.bz - (q.y + t.z * c.ax - t.x * c.az)) * c.ny +
    (p.z + s.x * c.by - s.y * c.bx - (q.z + t.x * c.ay - t.y * c.ax)) * c.nz
  );
}

function solveFriction(c: Contact): void {
  readRelativeVelocity(relative, c);
  const { x, y, z } = relative;
  let t = c.tangentImpulse - c.tangentMass * (x * c.tx + y * c.ty + z * c.tz);
  let u = c.otherTangentImpulse - c.otherTangentMass * (x * c.ux + y * c.uy + z * c.uz);
  const most = c.friction * c.normalImpulse;
  const length = Math.hypot(t, u);
  if (length > most) {
    const factor = length > 0 ? most / length : 0;
    t *= factor;
    u *= factor;
  }
  const dt = t - c.tangentImpulse;
  const du = u - c.otherTangentImpulse;
  c.tangentImpulse = t;
  c.otherTangentImpulse = u;
  applyImpulse(c, dt * c.tx + du * c.ux, dt * c.ty + du * c.uy, dt * c.tz + du * c.uz);
}

/** Applies a torque against rolling, bounded by the lever arm times the normal impulse. */
function solveRolling(c: Contact, a: RigidBody, b: RigidBody): void {
  let x = c.rollX - c.rollingMass * (b.angularVelocity.x - a.angularVelocity.x);
  let y = c.rollY - c.rollingMass * (b.angularVelocity.y - a.angularVelocity.y);
  let z = c.rollZ - c.rollingMass * (b.angularVelocity.z - a.angularVelocity.z);
  const most = c.rollingM * c.normalImpulse;
  const length = Math.hypot(x, y, z);
  if (length > most) {
    const factor = length > 0 ? most / length : 0;
    x *= factor;
    y *= factor;
    z *= factor;
  }
  turn(c, x - c.rollX, y - c.rollY, z - c.rollZ);
  c.rollX = x;
  c.rollY = y;
  c.rollZ = z;
}

/** Makes bodies bounce after all substeps: their separation speed is the approach speed times the restitution. */
export function bounce(contacts: ContactList): void {
  for (let i = 0; i < contacts.count; i++) {
    const c = contacts.at(i);
    if (c.restitution === 0 || c.approach > -BOUNCE_MPS || c.maxImpulse === 0) continue;
    readRelativeVelocity(relative, c);
    const speed = relative.x * c.nx + relative.y * c.ny + relative.z * c.nz;
    const total = Math.max(c.normalImpulse - c.normalMass * (speed + c.restitution * c.approach), 0);
    const given = total - c.normalImpulse;
    c.normalImpulse = total;
    c.maxImpulse = Math.max(c.maxImpulse, total);
    applyImpulse(c, given * c.nx, given * c.ny, given * c.nz);
  }
}

function turn({ a, b }: Contact, x: number, y: number, z: number): void {
  const p = a.inverseWorld;
  const q = b.inverseWorld;
  a.angularVelocity.x -= p.xx * x + p.xy * y + p.xz * z;
  a.angularVelocity.y -= p.xy * x + p.yy * y + p.yz * z;
  a.angularVelocity.z -= p.xz * x + p.yz * y + p.zz * z;
  b.angularVelocity.x += q.xx * x + q.xy * y + q.xz * z;
  b.angularVelocity.y += q.xy * x + q.yy * y + q.yz * z;
  b.angularVelocity.z += q.xz * x + q.yz * y + q.zz * z;
}

/**
 * Chooses two tangents that follow the normal continuously where possible (Duff et al., “Building an Orthonormal Basis, Revisited”, 2017).
 */
function chooseTangents(c: Contact): void {
  const sign = c.nz >= 0 ? 1 : -1;
  const p = -1 / (sign + c.nz);
  const q = c.nx * c.ny * p;
  c.tx = 1 + sign * c.nx * c.nx * p;
  c.ty = sign * q;
  c.tz = -sign * c.nx;
  c.ux = q;
  c.uy = sign + c.ny * c.ny * p;
  c.uz = -c.ny;
}

/** Stores the point in the axes of the body that was added first, so that the contact is found again after both have moved. */
function setLocalPoint(c: Contact): void {
  const isA = c.a.key < c.b.key;
  const { x, y, z, w } = isA ? c.a.quaternion : c.b.quaternion;
  const vx = isA ? c.ax : c.bx;
  const vy = isA ? c.ay : c.by;
  const vz = isA ? c.az : c.bz;
  // The inverse rotation of v.
  const tx = 2 * (z * vy - y * vz);
  const ty = 2 * (x * vz - z * vx);
  const tz = 2 * (y * vx - x * vy);
  c.lx = vx + w * tx + (z * ty - y * tz);
  c.ly = vy + w * ty + (x * tz - z * tx);
  c.lz = vz + w * tz + (y * tx - x * ty);
}
