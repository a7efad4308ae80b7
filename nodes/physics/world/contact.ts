import type { Levers } from './impulse-math.ts';
import type { RigidBody } from './rigid-body.ts';

/** One point at which two bodies touch or nearly touch. Numbers only: the solver runs over thousands of them. */
export interface Contact extends Levers {
  /** Key of the pair of bodies; the same in the next step. */
  pair: number;
  /** The normal: a unit vector from a to b, world axes. */
  nx: number;
  ny: number;
  nz: number;
  /** Distance of the bodies along the normal when the contact was found; negative if they overlap. */
  gapM: number;
  /** The point in the axes of `a` (or of the world, if `a` is the room), to find the contact again in the next step. */
  lx: number;
  ly: number;
  lz: number;
  friction: number;
  restitution: number;
  rollingM: number;
  /** Whether the contact is with the measured room. Such contacts are softer than those between bodies. */
  isRoom: boolean;
  /**
   * Whether all passes of the solver go through the contacts of the pair in one order, as they do for a ball on the measured room: forces
   * through its middle do not turn it, and with other orders fewer balls come to rest on a noisy room.
   */
  keepsOrder: boolean;

  // Of the solver.
  tx: number;
  ty: number;
  tz: number;
  ux: number;
  uy: number;
  uz: number;
  normalMass: number;
  tangentMass: number;
  otherTangentMass: number;
  rollingMass: number;
  normalImpulse: number;
  tangentImpulse: number;
  otherTangentImpulse: number;
  rollX: number;
  rollY: number;
  rollZ: number;
  maxImpulse: number;
  /** Velocity along the normal before the first impulse, meters per second; negative if the bodies approach. */
  approach: number;
  wasMatched: boolean;
}

export function createContact(body: RigidBody): Contact {
  const none = 0;
  return {
    a: body,
    b: body,
    pair: none,
    nx: 0,
    ny: 0,
    nz: 0,
    ax: 0,
    ay: 0,
    az: 0,
    bx: 0,
    by: 0,
    bz: 0,
    gapM: 0,
    lx: 0,
    ly: 0,
    lz: 0,
    friction: 0,
    restitution: 0,
    rollingM: 0,
    isRoom: false,
    keepsOrder: false,
    tx: 0,
    ty: 0,
    tz: 0,
    ux: 0,
    uy: 0,
    uz: 0,
    normalMass: 0,
    tangentMass: 0,
    otherTangentMass: 0,
    rollingMass: 0,
    normalImpulse: 0,
    tangentImpulse: 0,
    otherTangentImpulse: 0,
    rollX: 0,
    rollY: 0,
    rollZ: 0,
    maxImpulse: 0,
    approach: 0,
    wasMatched: false,
  };
}

/** The contacts of a step, in objects that are reused. */
export class ContactList {
  count = 0;
  private readonly pool: Contact[] = [];

  at(index: number): Contact {
    const contact = this.pool[index];
    if (!contact) throw new Error(`There is no contact ${index}.`);
    return contact;
  }

  clear(): void {
    this.count = 0;
  }

  /**
   * Adds a contact.
   *
   * @param px A point on `a`, world space. The point on `b` is `gapM` along the normal.
   */
  add(a: RigidBody, b: RigidBody, px: number, py: number, pz: number, nx: number, ny: number, nz: number, gapM: number): Contact {
    let contact = this.pool[this.count];
    if (!contact) {
      contact = createContact(a);
      this.pool.push(contact);
    }
    this.count++;
    // Both anchors lie halfway, so that both bodies see the same lever.
    const mx = px + 0.5 * gapM * nx;
    const my = py + 0.5 * gapM * ny;
    const mz = pz + 0.5 * gapM * nz;
    contact.a = a;
    contact.b = b;
    contact.pair = pairKey(a, b);
    contact.nx = nx;
    contact.ny = ny;
    contact.nz = nz;
    contact.ax = mx - a.position.x;
    contact.ay = my - a.position.y;
    contact.az = mz - a.position.z;
    contact.bx = mx - b.position.x;
    contact.by = my - b.position.y;
    contact.bz = mz - b.position.z;
    contact.gapM = gapM;
    const from = a.description;
    const to = b.description;
    contact.friction = Math.sqrt(from.friction * to.friction);
    contact.restitution = Math.max(from.restitution, to.restitution);
    contact.rollingM = Math.max(from.rollingM, to.rollingM);
    contact.isRoom = false;
    contact.keepsOrder = false;
    contact.wasMatched = false;
    return contact;
  }
}

/** The key of a pair of bodies, the same for both orders. */
export function pairKey(a: RigidBody, b: RigidBody): number {
  return Math.min(a.key, b.key) * 2 ** 24 + Math.max(a.key, b.key);
}
