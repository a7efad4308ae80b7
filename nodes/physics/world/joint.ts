import { Vec3 } from 'cannon-es';
import type { JointDescription, PhysicsJoint } from '../../kit/physics.ts';
import { type Softness, softness } from './contact-solver.ts';
import { applyImpulse, effectiveMass, type Levers } from './impulse-math.ts';
import type { RigidBody } from './rigid-body.ts';

/** Stiffness of rigid joints, cycles per second. A substep that is too long for it lowers it. */
const RIGID_HZ = 60;
const RIGID_DAMPING = 2;

/** One direction, linear or angular, in which a joint holds two bodies. */
interface Row extends Levers {
  isAngular: boolean;
  x: number;
  y: number;
  z: number;
  /** Deviation from the held position, meters or radians, at the start of the step. */
  error: number;
  mass: number;
  impulse: number;
  /** Whether the row only pulls, as a rope does. */
  onlyPulls: boolean;
}

/** A joint as the solver uses it. */
export interface Joint {
  readonly a: RigidBody;
  readonly b: RigidBody;
  readonly isActive: boolean;
  /** Measures the deviations. Call it before the substeps of a step. */
  prepare(stepS: number): void;
  warmStart(): void;
  solve(stepS: number, usesBias: boolean): void;
}

const AXES = [new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1)] as const;

// Filled and read within one call.
const scratchA = new Vec3();
const scratchB = new Vec3();
const scratchAxisA = new Vec3();
const scratchAxisB = new Vec3();
const scratchTangent = new Vec3();
const scratchOther = new Vec3();

/** Creates a joint between two bodies; `b` is a body or the target of the joint. The current relative rotation is the one that is held. */
export function createJoint(kind: PhysicsJoint['kind'], a: RigidBody, b: RigidBody, description: JointDescription): Joint {
  const { anchorA, anchorB, axisA, axisB, lengthM, frequencyHz, dampingRatio, maxForceN } = description;
  const localA = new Vec3(...anchorA);
  const localB = new Vec3(...anchorB);
  const hingeA = new Vec3(...axisA);
  const hingeB = new Vec3(...axisB);
  // b⁻¹ · a, as it is to stay.
  const rest = b.quaternion.inverse().mult(a.quaternion);
  const isLine = kind === 'rope' || kind === 'spring';
  const rows = Array.from({ length: kind === 'hinge' ? 5 : isLine ? 1 : 6 }, () => createRow(a, b));
  const isSoft = kind === 'spring' || kind === 'drag';
  let soft: Softness = softness(RIGID_HZ, RIGID_DAMPING, 1 / 240);
  let limit = Number.POSITIVE_INFINITY;

  function setLevers(row: Row): void {
    row.ax = scratchA.x;
    row.ay = scratchA.y;
    row.az = scratchA.z;
    row.bx = scratchB.x;
    row.by = scratchB.y;
    row.bz = scratchB.z;
  }
  function setRow(row: Row | undefined, axis: Vec3, error: number, isAngular: boolean): void {
    if (!row) return;
    row.x = axis.x;
    row.y = axis.y;
    row.z = axis.z;
    row.error = error;
    row.isAngular = isAngular;
    setLevers(row);
    row.mass = isAngular ? angularMass(row) : effectiveMass(row, axis.x, axis.y, axis.z);
  }

  return {
    a,
    b,
    get isActive() {
      return !(a.sleeps || !a.isDynamic) || !(b.sleeps || !b.isDynamic);
    },
    prepare: (stepS) => {
      soft = isSoft ? softness(frequencyHz, dampingRatio, stepS) : softness(Math.min(RIGID_HZ, 0.25 / stepS), RIGID_DAMPING, stepS);
      limit = maxForceN > 0 ? maxForceN * stepS : Number.POSITIVE_INFINITY;
      leverOf(a, localA, scratchA);
      leverOf(b, localB, scratchB);
      const dx = b.position.x + scratchB.x - a.position.x - scratchA.x;
      const dy = b.position.y + scratchB.y - a.position.y - scratchA.y;
      const dz = b.position.z + scratchB.z - a.position.z - scratchA.z;
      if (isLine) {
        const distance = Math.hypot(dx, dy, dz);
        if (distance > 1e-9) scratchTangent.set(dx / distance, dy / distance, dz / distance);
        else scratchTangent.set(0, 1, 0);
        setRow(rows[0], scratchTangent, distance - lengthM, false);
        if (rows[0]) rows[0].onlyPulls = kind === 'rope';
        return;
      }
      setRow(rows[0], AXES[0], dx, false);
      setRow(rows[1], AXES[1], dy, false);
      setRow(rows[2], AXES[2], dz, false);
      if (kind === 'hinge') {
        a.quaternion.vmult(hingeA, scratchAxisA);
        b.quaternion.vmult(hingeB, scratchAxisB);
        scratchAxisA.tangents(scratchTangent, scratchOther);
        // To align the axes, a turns about their cross product.
        const cx = scratchAxisA.y * scratchAxisB.z - scratchAxisA.z * scratchAxisB.y;
        const cy = scratchAxisA.z * scratchAxisB.x - scratchAxisA.x * scratchAxisB.z;
        const cz = scratchAxisA.x * scratchAxisB.y - scratchAxisA.y * scratchAxisB.x;
        setRow(rows[3], scratchTangent, cx * scratchTangent.x + cy * scratchTangent.y + cz * scratchTangent.z, true);
        setRow(rows[4], scratchOther, cx * scratchOther.x + cy * scratchOther.y + cz * scratchOther.z, true);
        return;
      }
      // The rotation of b relative to where a wants it, the short way round.
      const wanted = a.quaternion.mult(rest.inverse());
      const turn = b.quaternion.mult(wanted.inverse());
      const sign = turn.w < 0 ? -2 : 2;
      setRow(rows[3], AXES[0], sign * turn.x, true);
      setRow(rows[4], AXES[1], sign * turn.y, true);
      setRow(rows[5], AXES[2], sign * turn.z, true);
    },
    warmStart: () => {
      for (const row of rows) give(row, row.impulse);
    },
    solve: (stepS, usesBias) => {
      for (const row of rows) solveRow(row, soft, limit, stepS, usesBias || isSoft);
    },
  };
}

function createRow(a: RigidBody, b: RigidBody): Row {
  const levers = { ax: 0, ay: 0, az: 0, bx: 0, by: 0, bz: 0 };
  return { a, b, ...levers, isAngular: false, x: 0, y: 0, z: 0, error: 0, mass: 0, impulse: 0, onlyPulls: false };
}

/** Writes the vector from a body's center of mass to an anchor, which is given in the axes of the description. */
function leverOf(body: RigidBody, local: Vec3, out: Vec3): void {
  local.vsub(body.centerM, out);
  body.quaternion.vmult(out, out);
}

function angularMass({ a, b, x, y, z }: Row): number {
  const p = a.inverseWorld;
  const q = b.inverseWorld;
  const kx = (p.xx + q.xx) * x + (p.xy + q.xy) * y + (p.xz + q.xz) * z;
  const ky = (p.xy + q.xy) * x + (p.yy + q.yy) * y + (p.yz + q.yz) * z;
  const kz = (p.xz + q.xz) * x + (p.yz + q.yz) * y + (p.zz + q.zz) * z;
  const k = kx * x + ky * y + kz * z;
  return k > 0 ? 1 / k : 0;
}

function solveRow(row: Row, soft: Softness, limit: number, stepS: number, usesBias: boolean): void {
  const { a, b, x, y, z } = row;
  const v = b.angularVelocity;
  const w = a.angularVelocity;
  const s = b.turnedRad;
  const t = a.turnedRad;
  let speed: number;
  let error = row.error;
  if (row.isAngular) {
    speed = (v.x - w.x) * x + (v.y - w.y) * y + (v.z - w.z) * z;
    error += (s.x - t.x) * x + (s.y - t.y) * y + (s.z - t.z) * z;
  } else {
    const { ax, ay, az, bx, by, bz } = row;
    speed =
      (b.velocity.x + v.y * bz - v.z * by - a.velocity.x - w.y * az + w.z * ay) * x +
      (b.velocity.y + v.z * bx - v.x * bz - a.velocity.y - w.z * ax + w.x * az) * y +
      (b.velocity.z + v.x * by - v.y * bx - a.velocity.z - w.x * ay + w.y * ax) * z;
    error +=
      (b.movedM.x + s.y * bz - s.z * by - a.movedM.x - t.y * az + t.z * ay) * x +
      (b.movedM.y + s.z * bx - s.x * bz - a.movedM.y - t.z * ax + t.x * az) * y +
      (b.movedM.z + s.x * by - s.y * bx - a.movedM.z - t.x * ay + t.y * ax) * z;
  }
  const isSlack = row.onlyPulls && error < 0;
  const bias = isSlack ? error / stepS : usesBias ? soft.biasRate * error : 0;
  const scale = usesBias && !isSlack ? soft.massScale : 1;
  const keep = usesBias && !isSlack ? soft.impulseScale : 0;
  const wanted = row.impulse - row.mass * scale * (speed + bias) - keep * row.impulse;
  const total = Math.min(Math.max(wanted, -limit), row.onlyPulls ? 0 : limit);
  const given = total - row.impulse;
  row.impulse = total;
  give(row, given);
}

function give(row: Row, impulse: number): void {
  const { a, b } = row;
  const x = row.x * impulse;
  const y = row.y * impulse;
  const z = row.z * impulse;
  if (!row.isAngular) {
    applyImpulse(row, x, y, z);
    return;
  }
  const p = a.inverseWorld;
  const q = b.inverseWorld;
  const w = a.angularVelocity;
  const v = b.angularVelocity;
  w.set(w.x - p.xx * x - p.xy * y - p.xz * z, w.y - p.xy * x - p.yy * y - p.yz * z, w.z - p.xz * x - p.yz * y - p.zz * z);
  v.set(v.x + q.xx * x + q.xy * y + q.xz * z, v.y + q.xy * x + q.yy * y + q.yz * z, v.z + q.xz * x + q.yz * y + q.zz * z);
}
