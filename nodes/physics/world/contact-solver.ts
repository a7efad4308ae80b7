import type { Contact, ContactList } from './contact.ts';
import { applyImpulse, effectiveMass, readRelativeVelocity } from './impulse-math.ts';

/** Contacts in which bodies approach more slowly do not bounce, meters per second. */
const BOUNCE_MPS = 0.15;
const BOUNCE_PASSES = 8;
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

/**
 * Makes bodies bounce after all substeps: their separation speed is the approach speed times the restitution. A body that lands on several
 * points shares the impulse among them, so that it does not turn.
 */
export function bounce(contacts: ContactList): void {
  // Forwards and backwards by turns, so that the order of the contacts matters little.
  for (let pass = 0; pass < BOUNCE_PASSES; pass++) {
    let bounces = false;
    for (let n = 0; n < contacts.count; n++) {
      const c = contacts.at(pass % 2 === 0 ? n : contacts.count - 1 - n);
      if (c.restitution === 0 || c.approach > -BOUNCE_MPS || c.maxImpulse === 0) continue;
      if (c.keepsOrder && pass > 0) continue;
      bounces ||= !c.keepsOrder;
      readRelativeVelocity(relative, c);
      const speed = relative.x * c.nx + relative.y * c.ny + relative.z * c.nz;
      const total = Math.max(c.normalImpulse - c.normalMass * (speed + c.restitution * c.approach), 0);
      const given = total - c.normalImpulse;
      c.normalImpulse = total;
      c.maxImpulse = Math.max(c.maxImpulse, total);
      applyImpulse(c, given * c.nx, given * c.ny, given * c.nz);
    }
    if (!bounces) return;
  }
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
