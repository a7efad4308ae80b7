import { type Body, Quaternion, SAPBroadphase, Vec3, World } from 'cannon-es';
import type { BodyDescription } from '../../kit/physics.ts';
import { ContactList, pairKey } from './contact.ts';
import { createContactMemory } from './contact-memory.ts';
import { createContactRows } from './contact-rows.ts';
import { bounce, prepareContacts } from './contact-solver.ts';
import { findContacts } from './find-contacts.ts';
import { isFiniteCommand } from './finite-command.ts';
import { push } from './impulse-math.ts';
import { aimAtTarget, integratePose, integrateVelocity } from './integrate.ts';
import { updateSleep, wakeTouched } from './islands.ts';
import { createJoint, type Joint } from './joint.ts';
import { ASLEEP, FIXED_BODY, LOST, type PhysicsEngine, POSE_STRIDE, TOUCH_STRIDE, type WorldSettings } from './protocol.ts';
import { readPose } from './read-pose.ts';
import { RigidBody } from './rigid-body.ts';
import { createRoomCollider } from './room-collider.ts';
import { sweep } from './sweep.ts';

/** The longest step. A longer frame is simulated in several steps, so that the result depends little on the frame rate. */
const STEP_S = 1 / 60;
/** The most steps per frame. The rest of the time is dropped: after a long pause the world continues instead of catching up. */
const MAX_STEPS = 4;
/** Tolerance, in steps: a frame that is a hundredth of a step longer than a step still takes one step, because frame times are rounded. */
const STEP_TOLERANCE = 0.01;

/** Limits of position (meters) and speed (meters or radians per second), beyond which numbers lose their precision. */
const FAR_M = 1e6;
const FAST = 1e4;
/** A body that is this far below everything that depth has shown of the room has fallen out of it, meters. */
const LOST_M = 0.5;
/** Contacts of bodies that meet more slowly are not reported, meters per second. */
const TOUCH_MPS = 0.02;

const TARGET: BodyDescription = { ...FIXED_BODY, mode: 'kinematic' };

// Filled and read within one call.
const scratchPosition = new Vec3();
const scratchRotation = new Quaternion();
const scratchVector = new Vec3();

/**
 * Creates the physics engine that Scrim uses: bodies and the sweep-and-prune of cannon-es, with Scrim's own contacts and solver (ADR 40).
 * Each step finds contacts once and solves them in substeps (“Small Steps in Physics Simulation”, Macklin et al. 2019; Catto, “Solver2D”,
 * 2024).
 */
export function createCannonEngine(): PhysicsEngine {
  const world = new World();
  const broadphase = new SAPBroadphase(world);
  broadphase.useBoundingBoxes = true;
  world.broadphase = broadphase;
  const byId = new Map<number, RigidBody>();
  const bodies: RigidBody[] = [];
  const joints = new Map<number, Joint>();
  const targets = new Map<number, RigidBody>();
  const linked = new Set<number>();
  const contacts = new ContactList();
  const rows = createContactRows();
  const memory = createContactMemory();
  const as: Body[] = [];
  const bs: Body[] = [];
  const velocitiesBefore = new Map<RigidBody, Vec3>();
  let settings: WorldSettings = { gravity: [0, -9.81, 0], substeps: 4, iterations: 4, sleep: true };
  const gravity = new Vec3(...settings.gravity);
  let stepBeforeS = STEP_S;
  const room = createRoomCollider();
  /** The contacts that began in the steps of the last frame, `TOUCH_STRIDE` numbers each. */
  const touches: number[] = [];

  function add(id: number, description: BodyDescription, state: ArrayLike<number>): void {
    if (byId.has(id)) return;
    const body = new RigidBody(id, description);
    byId.set(id, body);
    bodies.push(body);
    world.addBody(body);
    broadphase.axisIndex = 0;
    place(
      body,
      scratchPosition.set(at(state, 1), at(state, 2), at(state, 3)),
      scratchRotation.set(at(state, 4), at(state, 5), at(state, 6), at(state, 7)),
    );
    velocitiesBefore.set(body, new Vec3());
    body.angularVelocity.set(at(state, 11), at(state, 12), at(state, 13));
    // The velocity of a state is that of the origin.
    const { x, y, z } = leverOf(body);
    const w = body.angularVelocity;
    body.velocity.set(at(state, 8) + w.y * z - w.z * y, at(state, 9) + w.z * x - w.x * z, at(state, 10) + w.x * y - w.y * x);
    if (at(state, 14) === ASLEEP && body.isDynamic) body.rest();
  }
  /** Moves a body so that the origin of its description has this position and rotation, and stops it. */
  function place(body: RigidBody, position: Vec3, rotation: Quaternion): void {
    rotation.normalize();
    body.quaternion.copy(rotation);
    body.position.copy(position);
    body.position.vadd(leverOf(body), body.position);
    body.positionBefore.copy(body.position);
    body.velocity.setZero();
    body.angularVelocity.setZero();
    body.hasTarget = false;
    body.updateBounds();
    body.updateInertia();
    body.wake();
  }
  /** The vector from the origin of the description to the center of mass, in world axes. */
  function leverOf(body: RigidBody): Vec3 {
    body.quaternion.vmult(body.centerM, scratchVector);
    return scratchVector;
  }
  /** Wakes the bodies that may have rested on a body that has moved or has been removed. */
  function wakeAround(body: RigidBody): void {
    for (const other of bodies) if (other.sleeps && other.aabb.overlaps(body.aabb)) wakeIsland(other);
  }
  function wakeIsland(body: RigidBody): void {
    body.wake();
    for (const other of bodies) if (other.sleeps && other.aabb.overlaps(body.aabb)) wakeIsland(other);
  }
  function remove(id: number): void {
    const body = byId.get(id);
    if (!body) return;
    byId.delete(id);
    bodies.splice(bodies.indexOf(body), 1);
    velocitiesBefore.delete(body);
    world.removeBody(body);
    wakeAround(body);
    for (const [joint, { a, b }] of joints) if (a === body || b === body) joints.delete(joint);
  }
  function setTarget(body: RigidBody, matrix: ArrayLike<number>): void {
    readPose(matrix, body.targetPosition, body.targetRotation);
    body.targetRotation.vmult(body.centerM, scratchVector);
    body.targetPosition.vadd(scratchVector, body.targetPosition);
    body.hasTarget = true;
  }

  /** Wakes the bodies beside voxels that have become occupied or free, because their support may be gone. */
  function wakeWhereChanged(): void {
    for (const body of bodies) {
      if (!body.sleeps) continue;
      const { lowerBound: l, upperBound: u } = body.aabb;
      if (room.hasChanged(l.x, l.y, l.z, u.x, u.y, u.z)) wakeIsland(body);
    }
  }
  function apply(command: Parameters<PhysicsEngine['apply']>[0]): void {
    if (!isFiniteCommand(command)) return;
    const body = 'id' in command ? byId.get(command.id) : undefined;
    switch (command.kind) {
      case 'settings':
        settings = command.settings;
        gravity.set(...settings.gravity);
        for (const each of bodies) if (each.isDynamic) each.wake();
        break;
      case 'add':
        add(command.id, command.body, command.state);
        break;
      case 'remove':
        remove(command.id);
        break;
      case 'shape':
        if (!body) break;
        body.describe(command.body);
        wakeAround(body);
        break;
      case 'move':
        if (!body) break;
        wakeAround(body);
        readPose(command.worldFromBody, scratchPosition, scratchRotation);
        place(body, scratchPosition, scratchRotation);
        if (body.isDynamic) body.velocity.set(at(command.velocity, 0), at(command.velocity, 1), at(command.velocity, 2));
        break;
      case 'target': {
        const target = body ?? targets.get(command.id);
        if (!target) break;
        setTarget(target, command.worldFromBody);
        // A body that is held still falls asleep, and follows again when what holds it moves.
        for (const { a, b } of joints.values()) {
          if (b === target && a.sleeps) wakeIsland(a);
          if (a === target && b.sleeps) wakeIsland(b);
        }
        break;
      }
      case 'impulse':
        if (!body?.isDynamic) break;
        if (body.sleeps) wakeIsland(body);
        for (let i = 0; i + 8 < command.values.length; i += 9) applyEntry(body, command.values, i);
        break;
      case 'accelerate':
        if (!body?.isDynamic) break;
        body.wake();
        body.force.set(command.x * body.mass, command.y * body.mass, command.z * body.mass);
        break;
      case 'joint': {
        const { kind, a, b, description, worldFromTarget } = command.joint;
        const first = byId.get(a);
        let second = b === null ? targets.get(command.id) : byId.get(b);
        if (b === null && !second) {
          second = new RigidBody(-command.id, TARGET);
          targets.set(command.id, second);
          readPose(worldFromTarget, second.position, second.quaternion);
        }
        if (!first || !second) break;
        first.wake();
        second.wake();
        joints.set(command.id, createJoint(kind, first, second, description));
        if (kind === 'hinge' || kind === 'lock') linked.add(pairKey(first, second));
        break;
      }
      case 'unjoin': {
        const joint = joints.get(command.id);
        joint?.a.wake();
        joint?.b.wake();
        if (joint) linked.delete(pairKey(joint.a, joint.b));
        joints.delete(command.id);
        targets.delete(command.id);
        break;
      }
      case 'room':
      case 'load-room':
      case 'move-room':
        room.apply(command);
        for (const each of bodies) if (each.isDynamic) each.wake();
        break;
      case 'depth':
        room.apply(command);
        wakeWhereChanged();
        break;
    }
  }

  function advance(stepS: number): void {
    as.length = 0;
    bs.length = 0;
    broadphase.collisionPairs(world, as, bs);
    contacts.clear();
    findContacts(as, bs, stepS, linked, contacts);
    for (const body of bodies) if (body.isDynamic && !body.sleeps) room.collide(body, stepS, contacts);
    wakeTouched(contacts, stepS);
    prepareContacts(contacts);
    memory.recall(contacts, stepS / stepBeforeS);
    stepBeforeS = stepS;
    const active = [...joints.values()].filter((joint) => joint.isActive);
    for (const body of bodies) begin(body, stepS);
    for (const target of targets.values()) begin(target, stepS);
    const { iterations } = settings;
    const substeps = Math.max(1, settings.substeps);
    const subS = stepS / substeps;
    for (const joint of active) joint.prepare(subS);
    rows.load(contacts);
    for (let i = 0; i < substeps; i++) {
      for (const body of bodies) if (body.isDynamic && !body.sleeps) integrateVelocity(body, gravity, subS);
      for (const joint of active) joint.warmStart();
      rows.readBodies();
      rows.warmStart();
      for (let n = 0; n < iterations; n++) solve(active, subS, true);
      rows.writeBodies();
      for (const body of bodies) if (!body.sleeps) integratePose(body, subS);
      for (const target of targets.values()) integratePose(target, subS);
      // Removes the velocity with which overlap was pushed apart. Half as many passes leave no more than they can see.
      rows.readBodies();
      for (let n = 0; n < iterations; n += 2) solve(active, subS, false);
      rows.writeBodies();
    }
    rows.store(contacts);
    bounce(contacts);
    for (const body of bodies) end(body);
    reportTouches();
    updateSleep(bodies, contacts, pairsOf(active), settings.sleep, stepS);
    memory.keep(contacts);
  }
  /** Solves joints and contacts once. */
  function solve(active: readonly Joint[], subS: number, usesBias: boolean): void {
    if (active.length > 0) {
      rows.writeBodies();
      for (const joint of active) joint.solve(subS, usesBias);
      rows.readBodies();
    }
    rows.solve(subS, usesBias);
  }
  function begin(body: RigidBody, stepS: number): void {
    if (!body.isDynamic) aimAtTarget(body, stepS);
    body.movedM.setZero();
    body.turnedRad.setZero();
    body.positionBefore.copy(body.position);
    velocitiesBefore.get(body)?.copy(body.velocity);
  }
  function end(body: RigidBody): void {
    if (body.sleeps) {
      // What passes close by has pressed on it in the solver.
      if (body.isDynamic) body.rest();
      return;
    }
    if (!isFiniteState(body)) restore(body);
    const before = velocitiesBefore.get(body);
    if (body.isDynamic && before) sweep(body, before, bodies, room.cast);
    body.updateBounds();
  }
  function reportTouches(): void {
    for (let i = 0; i < contacts.count; i++) {
      const c = contacts.at(i);
      if (c.maxImpulse === 0 || c.approach > -TOUCH_MPS || memory.touched(c.pair)) continue;
      // Only the strongest contact of a pair.
      let isStrongest = true;
      for (let j = 0; j < contacts.count; j++) {
        const other = contacts.at(j);
        if (other.pair === c.pair && (other.maxImpulse > c.maxImpulse || (other.maxImpulse === c.maxImpulse && j < i))) isStrongest = false;
      }
      if (!isStrongest) continue;
      const { a, b } = c;
      touches.push(a.key, b.key, a.position.x + c.ax, a.position.y + c.ay, a.position.z + c.az, -c.nx, -c.ny, -c.nz, c.maxImpulse);
    }
  }

  return {
    apply,
    step: (deltaS) => {
      touches.length = 0;
      if (!(deltaS > 0) || !Number.isFinite(deltaS)) return;
      const count = Math.min(Math.max(1, Math.ceil(deltaS / STEP_S - STEP_TOLERANCE)), MAX_STEPS);
      const stepS = Math.min(deltaS / count, STEP_S);
      for (let i = 0; i < count; i++) advance(stepS);
      for (const body of bodies) body.force.setZero();
    },
    get bodyCount() {
      return bodies.length;
    },
    writePoses: (out) => {
      bodies.forEach((body, i) => {
        const o = i * POSE_STRIDE;
        const { x, y, z } = leverOf(body);
        const { position: p, quaternion: q, velocity: v, angularVelocity: w } = body;
        out[o] = body.key;
        out[o + 1] = p.x - x;
        out[o + 2] = p.y - y;
        out[o + 3] = p.z - z;
        out[o + 4] = q.x;
        out[o + 5] = q.y;
        out[o + 6] = q.z;
        out[o + 7] = q.w;
        out[o + 8] = v.x - (w.y * z - w.z * y);
        out[o + 9] = v.y - (w.z * x - w.x * z);
        out[o + 10] = v.z - (w.x * y - w.y * x);
        out[o + 11] = w.x;
        out[o + 12] = w.y;
        out[o + 13] = w.z;
        out[o + 14] = body.isDynamic && p.y < room.lowestM - LOST_M ? LOST : body.sleeps ? ASLEEP : 0;
      });
    },
    voxels: room.voxels,
    roomFile: room.file,
    writeTouches: (out) => {
      const count = Math.min(Math.floor(out.length / TOUCH_STRIDE), touches.length / TOUCH_STRIDE);
      for (let i = 0; i < count * TOUCH_STRIDE; i++) out[i] = touches[i] ?? 0;
      return count;
    },
  };
}

function* pairsOf(joints: readonly Joint[]): Iterable<readonly [RigidBody, RigidBody]> {
  for (const { a, b } of joints) yield [a, b];
}

function applyEntry(body: RigidBody, values: ArrayLike<number>, i: number): void {
  const { x, y, z } = body.position;
  body.wake();
  push(body, at(values, i + 6) - x, at(values, i + 7) - y, at(values, i + 8) - z, at(values, i), at(values, i + 1), at(values, i + 2));
  const m = body.inverseWorld;
  const w = body.angularVelocity;
  const [p, q, r] = [at(values, i + 3), at(values, i + 4), at(values, i + 5)];
  w.set(w.x + m.xx * p + m.xy * q + m.xz * r, w.y + m.xy * p + m.yy * q + m.yz * r, w.z + m.xz * p + m.yz * q + m.zz * r);
}

function at(list: ArrayLike<number>, index: number): number {
  return list[index] ?? 0;
}

function isFiniteState({ position: p, quaternion: q, velocity: v, angularVelocity: w }: RigidBody): boolean {
  const farM = Math.abs(p.x) + Math.abs(p.y) + Math.abs(p.z);
  const fast = Math.abs(v.x) + Math.abs(v.y) + Math.abs(v.z) + Math.abs(w.x) + Math.abs(w.y) + Math.abs(w.z);
  return farM < FAR_M && fast < FAST && Math.abs(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w - 1) < 0.01;
}

/** Stops a body that is lost or whose numbers have overflowed, at its position before the step. */
function restore(body: RigidBody): void {
  body.position.copy(body.positionBefore);
  body.quaternion.set(0, 0, 0, 1);
  body.velocity.setZero();
  body.angularVelocity.setZero();
  body.updateInertia();
}
