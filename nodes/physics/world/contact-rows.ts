import type { ContactList } from './contact.ts';
import { softness } from './contact-solver.ts';
import type { RigidBody } from './rigid-body.ts';

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

/** Numbers of a body: velocity, angular velocity, inverse mass, inverse inertia (xx, xy, xz, yy, yz, zz), motion, rotation. */
const BODY = 19;
/** Offsets in the numbers of a contact. The normal, both tangents and both levers come first, three numbers each. */
const T = 3;
const U = 6;
const A = 9;
const B = 12;
const GAP = 15;
const FRICTION = 16;
const ROLLING = 17;
const NORMAL_MASS = 18;
const T_MASS = 19;
const U_MASS = 20;
const ROLL_MASS = 21;
/** 1: the stiffer constraint of contacts with immovable bodies. */
const IS_STIFF = 22;
const WAS_MATCHED = 23;
const NORMAL = 24;
const T_IMPULSE = 25;
const U_IMPULSE = 26;
const ROLL = 27;
const MOST = 30;
const APPROACH = 31;
/** The speed along the normal at the start of the substep. */
const SPEED = 32;
const KEEPS_ORDER = 33;
const CONTACT = 34;

/**
 * The contacts of a step and the velocities of their bodies as plain arrays of numbers, over which the solver runs: objects with numbers
 * are several times as slow.
 */
export interface ContactRows {
  /** Copies contacts that are prepared. */
  load(contacts: ContactList): void;
  /** Copies the velocities, inertia and motion of the bodies. */
  readBodies(): void;
  /** Copies the velocities back to the bodies. */
  writeBodies(): void;
  /** Applies the accumulated impulses again, so that a resting contact needs few iterations. Call it once per substep. */
  warmStart(): void;
  /**
   * Solves each contact once: its normal impulse, then its friction, which is bounded by the normal impulse.
   *
   * @param stepS Seconds of a substep.
   * @param usesBias Whether overlapping bodies are pushed apart. The pass after the positions have moved does not push, and removes the
   * velocity of the push.
   */
  solve(stepS: number, usesBias: boolean): void;
  /** Copies the impulses back to the contacts. */
  store(contacts: ContactList): void;
}

export function createContactRows(): ContactRows {
  let numbers = new Float64Array(256 * CONTACT);
  let slots = new Int32Array(512);
  let states = new Float64Array(128 * BODY);
  const bodies: RigidBody[] = [];
  let count = 0;
  /** For each contact, the contact that takes its turn in backward passes: those of two bodies are solved in the opposite order. */
  let mirrors = new Int32Array(256);
  /** Passes alternate, because a box that lands flat would turn and slide away if its corners were always solved in one order. */
  let isBackwards = true;

  function slotOf(body: RigidBody): number {
    if (bodies[body.slot] === body) return BODY * body.slot;
    body.slot = bodies.push(body) - 1;
    return BODY * body.slot;
  }
  /** Adds an impulse to a body. */
  function push(o: number, rx: number, ry: number, rz: number, x: number, y: number, z: number): void {
    const s = states;
    const invMass = s[o + 6] as number;
    if (invMass === 0) return;
    const cx = ry * z - rz * y;
    const cy = rz * x - rx * z;
    const cz = rx * y - ry * x;
    s[o] = (s[o] as number) + invMass * x;
    s[o + 1] = (s[o + 1] as number) + invMass * y;
    s[o + 2] = (s[o + 2] as number) + invMass * z;
    turn(o, cx, cy, cz);
  }
  /** Adds an angular impulse to a body. */
  function turn(o: number, x: number, y: number, z: number): void {
    const s = states;
    const xy = s[o + 8] as number;
    const xz = s[o + 9] as number;
    const yz = s[o + 11] as number;
    s[o + 3] = (s[o + 3] as number) + ((s[o + 7] as number) * x + xy * y + xz * z);
    s[o + 4] = (s[o + 4] as number) + (xy * x + (s[o + 10] as number) * y + yz * z);
    s[o + 5] = (s[o + 5] as number) + (xz * x + yz * y + (s[o + 12] as number) * z);
  }

  return {
    load: (contacts) => {
      ({ count } = contacts);
      isBackwards = true;
      if (numbers.length < count * CONTACT) {
        numbers = new Float64Array(2 * count * CONTACT);
        slots = new Int32Array(4 * count);
        mirrors = new Int32Array(2 * count);
      }
      bodies.length = 0;
      for (let i = 0; i < count; i++) {
        const c = contacts.at(i);
        slots[2 * i] = slotOf(c.a);
        slots[2 * i + 1] = slotOf(c.b);
        const o = i * CONTACT;
        numbers[o] = c.nx;
        numbers[o + 1] = c.ny;
        numbers[o + 2] = c.nz;
        numbers[o + T] = c.tx;
        numbers[o + T + 1] = c.ty;
        numbers[o + T + 2] = c.tz;
        numbers[o + U] = c.ux;
        numbers[o + U + 1] = c.uy;
        numbers[o + U + 2] = c.uz;
        numbers[o + A] = c.ax;
        numbers[o + A + 1] = c.ay;
        numbers[o + A + 2] = c.az;
        numbers[o + B] = c.bx;
        numbers[o + B + 1] = c.by;
        numbers[o + B + 2] = c.bz;
        numbers[o + GAP] = c.gapM;
        numbers[o + FRICTION] = c.friction;
        numbers[o + ROLLING] = c.rollingM;
        numbers[o + NORMAL_MASS] = c.normalMass;
        numbers[o + T_MASS] = c.tangentMass;
        numbers[o + U_MASS] = c.otherTangentMass;
        numbers[o + ROLL_MASS] = c.rollingMass;
        numbers[o + IS_STIFF] = (!c.a.isDynamic || !c.b.isDynamic) && !c.isRoom ? 1 : 0;
        numbers[o + WAS_MATCHED] = c.wasMatched ? 1 : 0;
        numbers[o + KEEPS_ORDER] = c.keepsOrder ? 1 : 0;
        numbers[o + NORMAL] = c.normalImpulse;
        numbers[o + T_IMPULSE] = c.tangentImpulse;
        numbers[o + U_IMPULSE] = c.otherTangentImpulse;
        numbers[o + ROLL] = c.rollX;
        numbers[o + ROLL + 1] = c.rollY;
        numbers[o + ROLL + 2] = c.rollZ;
        numbers[o + MOST] = 0;
        numbers[o + APPROACH] = 0;
      }
      for (let first = 0, end = 0; first < count; first = end) {
        const { pair, keepsOrder } = contacts.at(first);
        while (end < count && contacts.at(end).pair === pair) end++;
        for (let i = first; i < end; i++) mirrors[i] = keepsOrder ? i : first + end - 1 - i;
      }
      if (states.length < bodies.length * BODY) states = new Float64Array(2 * bodies.length * BODY);
    },
    readBodies: () => {
      for (let i = 0; i < bodies.length; i++) {
        const body = bodies[i] as RigidBody;
        const { velocity: v, angularVelocity: w, inverseWorld: m, movedM: p, turnedRad: r } = body;
        const o = i * BODY;
        states[o] = v.x;
        states[o + 1] = v.y;
        states[o + 2] = v.z;
        states[o + 3] = w.x;
        states[o + 4] = w.y;
        states[o + 5] = w.z;
        states[o + 6] = body.invMass;
        states[o + 7] = m.xx;
        states[o + 8] = m.xy;
        states[o + 9] = m.xz;
        states[o + 10] = m.yy;
        states[o + 11] = m.yz;
        states[o + 12] = m.zz;
        states[o + 13] = p.x;
        states[o + 14] = p.y;
        states[o + 15] = p.z;
        states[o + 16] = r.x;
        states[o + 17] = r.y;
        states[o + 18] = r.z;
      }
    },
    writeBodies: () => {
      for (let i = 0; i < bodies.length; i++) {
        const { velocity: v, angularVelocity: w } = bodies[i] as RigidBody;
        const o = i * BODY;
        v.set(states[o] as number, states[o + 1] as number, states[o + 2] as number);
        w.set(states[o + 3] as number, states[o + 4] as number, states[o + 5] as number);
      }
    },
    warmStart: () => {
      const k = numbers;
      const at = (i: number): number => k[i] as number;
      for (let i = 0; i < count; i++) {
        const o = i * CONTACT;
        const a = slots[2 * i] as number;
        const b = slots[2 * i + 1] as number;
        const n = at(o + NORMAL);
        const t = at(o + T_IMPULSE);
        const u = at(o + U_IMPULSE);
        const x = n * at(o) + t * at(o + T) + u * at(o + U);
        const y = n * at(o + 1) + t * at(o + T + 1) + u * at(o + U + 1);
        const z = n * at(o + 2) + t * at(o + T + 2) + u * at(o + U + 2);
        push(a, at(o + A), at(o + A + 1), at(o + A + 2), -x, -y, -z);
        push(b, at(o + B), at(o + B + 1), at(o + B + 2), x, y, z);
        if (at(o + ROLLING) === 0) continue;
        turn(a, -at(o + ROLL), -at(o + ROLL + 1), -at(o + ROLL + 2));
        turn(b, at(o + ROLL), at(o + ROLL + 1), at(o + ROLL + 2));
      }
      // Before any contact is solved: the first impulse at one point of a body changes how fast its other points approach.
      for (let i = 0; i < count; i++) {
        const o = i * CONTACT;
        if (at(o + MOST) > 0 || at(o + WAS_MATCHED) === 1) continue;
        const a = slots[2 * i] as number;
        const b = slots[2 * i + 1] as number;
        k[o + SPEED] =
          at(o) * relativeX(states, a, b, at(o + A + 1), at(o + A + 2), at(o + B + 1), at(o + B + 2)) +
          at(o + 1) * relativeY(states, a, b, at(o + A), at(o + A + 2), at(o + B), at(o + B + 2)) +
          at(o + 2) * relativeZ(states, a, b, at(o + A), at(o + A + 1), at(o + B), at(o + B + 1));
      }
    },
    solve: (stepS, usesBias) => {
      const hz = Math.min(CONTACT_HZ, 0.5 / stepS);
      const soft = softness(hz, DAMPING_RATIO, stepS);
      const stiff = softness(2 * hz, DAMPING_RATIO, stepS);
      const k = numbers;
      const s = states;
      isBackwards = !isBackwards;
      for (let n = 0; n < count; n++) {
        const i = isBackwards ? (mirrors[n] as number) : n;
        const o = i * CONTACT;
        const a = slots[2 * i] as number;
        const b = slots[2 * i + 1] as number;
        const nx = k[o] as number;
        const ny = k[o + 1] as number;
        const nz = k[o + 2] as number;
        const ax = k[o + A] as number;
        const ay = k[o + A + 1] as number;
        const az = k[o + A + 2] as number;
        const bx = k[o + B] as number;
        const by = k[o + B + 1] as number;
        const bz = k[o + B + 2] as number;

        // The distance by which the gap has grown since the contact was found.
        const ga = a + 13;
        const gb = b + 13;
        const gapM =
          (k[o + GAP] as number) +
          (((s[gb] as number) +
            (s[gb + 4] as number) * bz -
            (s[gb + 5] as number) * by -
            ((s[ga] as number) + (s[ga + 4] as number) * az - (s[ga + 5] as number) * ay)) *
            nx +
            ((s[gb + 1] as number) +
              (s[gb + 5] as number) * bx -
              (s[gb + 3] as number) * bz -
              ((s[ga + 1] as number) + (s[ga + 5] as number) * ax - (s[ga + 3] as number) * az)) *
              ny +
            ((s[gb + 2] as number) +
              (s[gb + 3] as number) * by -
              (s[gb + 4] as number) * bx -
              ((s[ga + 2] as number) + (s[ga + 3] as number) * ay - (s[ga + 4] as number) * ax)) *
              nz);
        let vx = relativeX(s, a, b, ay, az, by, bz);
        let vy = relativeY(s, a, b, ax, az, bx, bz);
        let vz = relativeZ(s, a, b, ax, ay, bx, by);
        const speed = vx * nx + vy * ny + vz * nz;
        let bias = 0;
        let mass = 1;
        let keep = 0;
        if (gapM > 0) bias = gapM / stepS;
        else if (usesBias) {
          const { biasRate, massScale, impulseScale } = k[o + IS_STIFF] === 1 ? stiff : soft;
          bias = Math.max(biasRate * Math.min(gapM + SLOP_M, 0), -PUSH_MPS);
          mass = massScale;
          keep = impulseScale;
        }
        const before = k[o + NORMAL] as number;
        const total = Math.max(before + (-(k[o + NORMAL_MASS] as number) * mass * (speed + bias) - keep * before), 0);
        const given = total - before;
        if (given > 0 && k[o + MOST] === 0 && k[o + WAS_MATCHED] === 0)
          k[o + APPROACH] = Math.min(0, k[o + KEEPS_ORDER] === 1 ? speed : (k[o + SPEED] as number));
        k[o + NORMAL] = total;
        k[o + MOST] = Math.max(k[o + MOST] as number, total);
        if (given !== 0) {
          push(a, ax, ay, az, -given * nx, -given * ny, -given * nz);
          push(b, bx, by, bz, given * nx, given * ny, given * nz);
        }

        const t0 = k[o + T_IMPULSE] as number;
        const u0 = k[o + U_IMPULSE] as number;
        // Without a normal impulse there is no friction to apply or to take back.
        if (total > 0 || t0 !== 0 || u0 !== 0) {
          const tx = k[o + T] as number;
          const ty = k[o + T + 1] as number;
          const tz = k[o + T + 2] as number;
          const ux = k[o + U] as number;
          const uy = k[o + U + 1] as number;
          const uz = k[o + U + 2] as number;
          vx = relativeX(s, a, b, ay, az, by, bz);
          vy = relativeY(s, a, b, ax, az, bx, bz);
          vz = relativeZ(s, a, b, ax, ay, bx, by);
          let t = t0 - (k[o + T_MASS] as number) * (vx * tx + vy * ty + vz * tz);
          let u = u0 - (k[o + U_MASS] as number) * (vx * ux + vy * uy + vz * uz);
          const most = (k[o + FRICTION] as number) * total;
          const length = Math.sqrt(t * t + u * u);
          if (length > most) {
            const factor = most / length;
            t *= factor;
            u *= factor;
          }
          const dt = t - t0;
          const du = u - u0;
          k[o + T_IMPULSE] = t;
          k[o + U_IMPULSE] = u;
          const x = dt * tx + du * ux;
          const y = dt * ty + du * uy;
          const z = dt * tz + du * uz;
          push(a, ax, ay, az, -x, -y, -z);
          push(b, bx, by, bz, x, y, z);
        }
        if ((k[o + ROLLING] as number) > 0) roll(o, a, b);
      }
    },
    store: (contacts) => {
      for (let i = 0; i < count; i++) {
        const c = contacts.at(i);
        const o = i * CONTACT;
        c.normalImpulse = numbers[o + NORMAL] as number;
        c.tangentImpulse = numbers[o + T_IMPULSE] as number;
        c.otherTangentImpulse = numbers[o + U_IMPULSE] as number;
        c.rollX = numbers[o + ROLL] as number;
        c.rollY = numbers[o + ROLL + 1] as number;
        c.rollZ = numbers[o + ROLL + 2] as number;
        c.maxImpulse = numbers[o + MOST] as number;
        c.approach = numbers[o + APPROACH] as number;
      }
    },
  };

  /** Applies a torque against rolling, bounded by the lever arm times the normal impulse. */
  function roll(o: number, a: number, b: number): void {
    const k = numbers;
    const s = states;
    const x0 = k[o + ROLL] as number;
    const y0 = k[o + ROLL + 1] as number;
    const z0 = k[o + ROLL + 2] as number;
    const mass = k[o + ROLL_MASS] as number;
    let x = x0 - mass * ((s[b + 3] as number) - (s[a + 3] as number));
    let y = y0 - mass * ((s[b + 4] as number) - (s[a + 4] as number));
    let z = z0 - mass * ((s[b + 5] as number) - (s[a + 5] as number));
    const most = (k[o + ROLLING] as number) * (k[o + NORMAL] as number);
    const length = Math.sqrt(x * x + y * y + z * z);
    if (length > most) {
      const factor = most / length;
      x *= factor;
      y *= factor;
      z *= factor;
    }
    turn(a, x0 - x, y0 - y, z0 - z);
    turn(b, x - x0, y - y0, z - z0);
    k[o + ROLL] = x;
    k[o + ROLL + 1] = y;
    k[o + ROLL + 2] = z;
  }
}

/** The velocity of b relative to a at the point, along x. */
function relativeX(s: Float64Array, a: number, b: number, ay: number, az: number, by: number, bz: number): number {
  const w = (s[a] as number) + (s[a + 4] as number) * az - (s[a + 5] as number) * ay;
  return (s[b] as number) + (s[b + 4] as number) * bz - (s[b + 5] as number) * by - w;
}

function relativeY(s: Float64Array, a: number, b: number, ax: number, az: number, bx: number, bz: number): number {
  const w = (s[a + 1] as number) + (s[a + 5] as number) * ax - (s[a + 3] as number) * az;
  return (s[b + 1] as number) + (s[b + 5] as number) * bx - (s[b + 3] as number) * bz - w;
}

function relativeZ(s: Float64Array, a: number, b: number, ax: number, ay: number, bx: number, by: number): number {
  const w = (s[a + 2] as number) + (s[a + 3] as number) * ay - (s[a + 4] as number) * ax;
  return (s[b + 2] as number) + (s[b + 3] as number) * by - (s[b + 4] as number) * bx - w;
}
