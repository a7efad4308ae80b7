import { Vec3 } from 'cannon-es';
import type { RigidBody } from './rigid-body.ts';

// Filled and read within one call.
const scratchMomentum = new Vec3();
const scratchSpin = new Vec3();

/** Changes the velocities of a body by gravity, forces and damping. */
export function integrateVelocity(body: RigidBody, gravity: Vec3, stepS: number): void {
  const { velocity: v, angularVelocity: w, force, invMass, description } = body;
  const g = description.gravityFactor * stepS;
  const s = invMass * stepS;
  v.set(v.x + gravity.x * g + force.x * s, v.y + gravity.y * g + force.y * s, v.z + gravity.z * g + force.z * s);
  if (description.linearDamping > 0) v.scale((1 - description.linearDamping) ** stepS, v);
  if (description.angularDamping > 0) w.scale((1 - description.angularDamping) ** stepS, w);
}

/**
 * Moves and rotates a body by its velocities. The angular momentum is constant, so the angular velocity changes with the rotated inertia:
 * the gyroscopic term, which cannon-es leaves out. The rotation uses the angular velocity at the middle of the step.
 */
export function integratePose(body: RigidBody, stepS: number): void {
  const { position: p, velocity: v, angularVelocity: w, movedM, turnedRad } = body;
  p.set(p.x + v.x * stepS, p.y + v.y * stepS, p.z + v.z * stepS);
  movedM.set(movedM.x + v.x * stepS, movedM.y + v.y * stepS, movedM.z + v.z * stepS);
  if (!body.isDynamic) {
    turnedRad.set(turnedRad.x + w.x * stepS, turnedRad.y + w.y * stepS, turnedRad.z + w.z * stepS);
    turnBy(body, w, stepS);
    return;
  }
  const i = body.inertiaWorld;
  scratchMomentum.set(i.xx * w.x + i.xy * w.y + i.xz * w.z, i.xy * w.x + i.yy * w.y + i.yz * w.z, i.xz * w.x + i.yz * w.y + i.zz * w.z);
  const { x, y, z, w: s } = body.quaternion;
  turnBy(body, w, stepS / 2);
  body.updateInertia();
  spinOf(body, scratchMomentum, scratchSpin);
  body.quaternion.set(x, y, z, s);
  turnBy(body, scratchSpin, stepS);
  turnedRad.set(turnedRad.x + scratchSpin.x * stepS, turnedRad.y + scratchSpin.y * stepS, turnedRad.z + scratchSpin.z * stepS);
  body.updateInertia();
  spinOf(body, scratchMomentum, w);
}

function spinOf({ inverseWorld: m }: RigidBody, momentum: Vec3, out: Vec3): void {
  const { x, y, z } = momentum;
  out.set(m.xx * x + m.xy * y + m.xz * z, m.xy * x + m.yy * y + m.yz * z, m.xz * x + m.yz * y + m.zz * z);
}

/** Rotates a body by a constant angular velocity over a step, exactly. */
function turnBy(body: RigidBody, spin: Vec3, stepS: number): void {
  const rate = Math.hypot(spin.x, spin.y, spin.z);
  const half = 0.5 * rate * stepS;
  if (half === 0) return;
  const k = Math.sin(half) / rate;
  const dx = spin.x * k;
  const dy = spin.y * k;
  const dz = spin.z * k;
  const dw = Math.cos(half);
  const { x, y, z, w } = body.quaternion;
  body.quaternion.set(
    dw * x + dx * w + dy * z - dz * y,
    dw * y + dy * w + dz * x - dx * z,
    dw * z + dz * w + dx * y - dy * x,
    dw * w - dx * x - dy * y - dz * z,
  );
  body.quaternion.normalize();
}

/** Sets the velocity of a kinematic body so that it reaches its target at the end of the step; 0 if it has arrived. */
export function aimAtTarget(body: RigidBody, stepS: number): void {
  if (!body.hasTarget) {
    body.velocity.setZero();
    body.angularVelocity.setZero();
    return;
  }
  const { position: p, targetPosition: to, quaternion: q, targetRotation: r } = body;
  body.velocity.set((to.x - p.x) / stepS, (to.y - p.y) / stepS, (to.z - p.z) / stepS);
  // r · q⁻¹, the short way round.
  let x = -r.w * q.x + r.x * q.w - r.y * q.z + r.z * q.y;
  let y = -r.w * q.y + r.y * q.w - r.z * q.x + r.x * q.z;
  let z = -r.w * q.z + r.z * q.w - r.x * q.y + r.y * q.x;
  let w = r.w * q.w + r.x * q.x + r.y * q.y + r.z * q.z;
  if (w < 0) {
    x = -x;
    y = -y;
    z = -z;
    w = -w;
  }
  const sine = Math.hypot(x, y, z);
  const k = sine > 1e-9 ? (2 * Math.atan2(sine, w)) / (sine * stepS) : 0;
  body.angularVelocity.set(x * k, y * k, z * k);
  body.hasTarget = false;
}
