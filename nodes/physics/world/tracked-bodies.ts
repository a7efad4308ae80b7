import type { BodyList, BodyWorld, PhysicsBody, PhysicsJoint, PhysicsRoom, Touch } from '../../kit/physics.ts';
import { MAX_TOUCHES } from '../../kit/physics.ts';
import { createVersionWatch } from '../../kit/version-watch.ts';
import { ASLEEP, LOST, type PhysicsCommand, POSE_STRIDE, type StepAnswer, TOUCH_STRIDE } from './protocol.ts';

/** The bodies of a world, with the state that the engine has of each. */
export interface TrackedBodies {
  readonly count: number;
  /** The number of bodies that are not asleep. */
  readonly awakeCount: number;
  /** Adds the commands that tell the engine what has changed since the last call. */
  writeCommands(lists: readonly BodyList[], out: PhysicsCommand[]): void;
  /** Whether the room shall be written to a file. Reading it ends the request. */
  takeFileRequest(): boolean;
  /** Copies an answer to the bodies and the room. */
  take(answer: StepAnswer): void;
  /**
   * Moves the bodies on by their velocities, for a frame in which the answer of the engine is late. `aheadS` are the seconds since the last
   * answer.
   */
  continueFor(aheadS: number): void;
  clearTouches(): void;
  /** Adds the commands that build the whole world in a new engine, in the state after the last answer. */
  writeAll(out: PhysicsCommand[]): void;
  /** Forgets all bodies, as before the first frame. */
  clear(): void;
}

interface Tracked {
  readonly id: number;
  readonly body: PhysicsBody;
  version: number;
  jumps: number;
  /** The state of the body in the last answer of the engine, or its initial state. */
  readonly state: Float64Array;
  /** The target that was last sent to the engine, for bodies that their nodes move. */
  readonly target: Float64Array;
  isListed: boolean;
}

interface TrackedJoint {
  readonly id: number;
  readonly joint: PhysicsJoint;
  version: number;
  readonly target: Float64Array;
  isListed: boolean;
}

export function createTrackedBodies(world: BodyWorld): TrackedBodies {
  const byBody = new Map<PhysicsBody, Tracked>();
  const byId = new Map<number, Tracked>();
  const joints = new Map<PhysicsJoint, TrackedJoint>();
  let watch = createVersionWatch();
  let nextId = 1;
  /** The room whose settings were last sent to the engine; `roomVersion` is their version. */
  let sentRoom: PhysicsRoom | null = null;
  let roomVersion = -1;
  /** `PhysicsRoom.changes` when the file was asked for that comes with the next answer. */
  let askedChanges = 0;

  function readLists(lists: readonly BodyList[], out: PhysicsCommand[]): void {
    for (const tracked of byBody.values()) tracked.isListed = false;
    for (const { bodies } of lists) {
      for (const body of bodies) {
        let tracked = byBody.get(body);
        if (!tracked) {
          tracked = {
            id: nextId++,
            body,
            version: body.version,
            jumps: body.jumps,
            state: stateOf(body),
            target: body.worldFromTarget.slice(),
            isListed: true,
          };
          byBody.set(body, tracked);
          byId.set(tracked.id, tracked);
          body.world = world;
          out.push({ kind: 'add', id: tracked.id, body: body.description, state: tracked.state });
        }
        tracked.isListed = true;
      }
    }
    for (const [body, tracked] of byBody) {
      if (tracked.isListed) continue;
      byBody.delete(body);
      byId.delete(tracked.id);
      body.world = null;
      out.push({ kind: 'remove', id: tracked.id });
    }
  }
  function writeChanges(tracked: Tracked, out: PhysicsCommand[]): void {
    const { id, body, target } = tracked;
    if (tracked.version !== body.version) {
      tracked.version = body.version;
      out.push({ kind: 'shape', id, body: body.description });
    }
    const hasMoved = body.description.mode !== 'dynamic' && !isEqual(target, body.worldFromTarget);
    const hasJumped = tracked.jumps !== body.jumps;
    if (hasJumped || hasMoved) {
      tracked.jumps = body.jumps;
      target.set(body.worldFromTarget);
      const isTarget = body.description.mode === 'kinematic' && !hasJumped;
      if (isTarget) out.push({ kind: 'target', id, worldFromBody: target.slice() });
      else out.push({ kind: 'move', id, worldFromBody: target.slice(), velocity: body.targetVelocity.slice() });
    }
    const { impulses } = body;
    if (impulses.count > 0) out.push({ kind: 'impulse', id, values: impulses.values.slice(0, 9 * impulses.count) });
    impulses.count = 0;
    const [x = 0, y = 0, z = 0] = body.acceleration;
    if (x !== 0 || y !== 0 || z !== 0) out.push({ kind: 'accelerate', id, x, y, z });
    body.acceleration.fill(0);
  }
  function writeJoints(out: PhysicsCommand[]): void {
    for (const tracked of joints.values()) tracked.isListed = false;
    for (const body of byBody.keys()) {
      for (const joint of body.joints) {
        if (!joint.isOn || (joint.b && !byBody.has(joint.b))) continue;
        let tracked = joints.get(joint);
        if (!tracked || tracked.version !== joint.version) {
          tracked = { id: tracked?.id ?? nextId++, joint, version: joint.version, target: joint.worldFromTarget.slice(), isListed: true };
          joints.set(joint, tracked);
          writeJoint(tracked, out);
        } else if (!joint.b && !isEqual(tracked.target, joint.worldFromTarget)) {
          tracked.target.set(joint.worldFromTarget);
          out.push({ kind: 'target', id: tracked.id, worldFromBody: tracked.target.slice() });
        }
        tracked.isListed = true;
      }
    }
    for (const [joint, { id, isListed }] of joints) {
      if (isListed) continue;
      joints.delete(joint);
      out.push({ kind: 'unjoin', id });
    }
  }
  function writeRoom(room: PhysicsRoom | null, out: PhysicsCommand[]): void {
    if (!room) {
      if (sentRoom) out.push({ kind: 'room', room: null, friction: 0, restitution: 0 });
      sentRoom = null;
      return;
    }
    const { settings, friction, restitution, version, frames, edits } = room;
    if (sentRoom !== room || roomVersion !== version) out.push({ kind: 'room', room: { ...settings }, friction, restitution });
    sentRoom = room;
    roomVersion = version;
    for (const edit of edits) {
      if (edit.kind === 'load') out.push({ kind: 'load-room', file: edit.file, worldFromFile: edit.worldFromFile });
      else out.push({ kind: 'move-room', worldFromFormer: edit.worldFromFormer });
    }
    edits.length = 0;
    for (const frame of frames) out.push({ kind: 'depth', frame });
    frames.length = 0;
  }
  function writeJoint({ id, joint, target }: TrackedJoint, out: PhysicsCommand[]): void {
    const a = byBody.get(joint.a);
    const b = joint.b ? byBody.get(joint.b) : null;
    if (!a || b === undefined) return;
    const { kind, description } = joint;
    out.push({
      kind: 'joint',
      id,
      joint: { kind, a: a.id, b: b?.id ?? null, description: { ...description }, worldFromTarget: target.slice() },
    });
  }
  function addTouch(id: number, otherId: number, values: Float32Array, o: number, sign: number): void {
    const tracked = byId.get(id);
    if (!tracked) return;
    const { touches } = tracked.body;
    if (touches.count === MAX_TOUCHES) return;
    let touch = touches.entries[touches.count];
    if (!touch) {
      touch = { otherKey: '', pointWorld: new Float64Array(3), normalWorld: new Float64Array(3), impulseNs: 0 } satisfies Touch;
      touches.entries.push(touch);
    }
    touches.count++;
    touch.otherKey = byId.get(otherId)?.body.key ?? '';
    for (let i = 0; i < 3; i++) {
      touch.pointWorld[i] = values[o + 2 + i] ?? 0;
      touch.normalWorld[i] = sign * (values[o + 5 + i] ?? 0);
    }
    touch.impulseNs = values[o + 8] ?? 0;
  }

  return {
    get count() {
      return byBody.size;
    },
    get awakeCount() {
      let count = 0;
      for (const { isAsleep, description } of byBody.keys()) if (!isAsleep && description.mode !== 'static') count++;
      return count;
    },
    writeCommands: (lists, out) => {
      if (watch.changed(lists)) readLists(lists, out);
      for (const tracked of byBody.values()) writeChanges(tracked, out);
      writeJoints(out);
      // A world has one room: the first that is connected.
      writeRoom(lists.find((list) => list.room)?.room ?? null, out);
    },
    takeFileRequest: () => {
      const wants = sentRoom?.wantsFile ?? false;
      if (!sentRoom || !wants) return false;
      sentRoom.wantsFile = false;
      askedChanges = sentRoom.changes;
      return true;
    },
    take: ({ poses, touches, bodyCount, touchCount, file, spent }) => {
      for (const depth of spent) sentRoom?.spent.push(depth);
      if (file && sentRoom) {
        sentRoom.file = file;
        sentRoom.fileChanges = askedChanges;
      }
      for (let i = 0; i < bodyCount; i++) {
        const o = i * POSE_STRIDE;
        const tracked = byId.get(poses[o] ?? 0);
        if (!tracked) continue;
        for (let j = 0; j < POSE_STRIDE; j++) tracked.state[j] = poses[o + j] ?? 0;
        writeBody(tracked.body, tracked.state, 0);
      }
      for (let i = 0; i < touchCount; i++) {
        const o = i * TOUCH_STRIDE;
        const a = touches[o] ?? 0;
        const b = touches[o + 1] ?? 0;
        addTouch(a, b, touches, o, 1);
        addTouch(b, a, touches, o, -1);
      }
    },
    continueFor: (aheadS) => {
      for (const { body, state } of byBody.values()) if (body.description.mode !== 'static') writeBody(body, state, aheadS);
    },
    clearTouches: () => {
      for (const { touches } of byBody.keys()) touches.count = 0;
    },
    writeAll: (out) => {
      for (const { id, body, state } of byBody.values()) out.push({ kind: 'add', id, body: body.description, state });
      for (const tracked of joints.values()) writeJoint(tracked, out);
      // The next frame sends the settings of the room again; depth fills it anew.
      sentRoom = null;
    },
    clear: () => {
      for (const body of byBody.keys()) body.world = null;
      byBody.clear();
      byId.clear();
      joints.clear();
      watch = createVersionWatch();
      nextId = 1;
      sentRoom = null;
    },
  };
}

/** The state of a body at its target. */
function stateOf({ worldFromTarget: m, targetVelocity }: PhysicsBody): Float64Array {
  const at = (i: number) => m[i] ?? 0;
  const state = new Float64Array(POSE_STRIDE);
  state.set([0, at(12), at(13), at(14)]);
  writeRotation(m, state);
  state.set(targetVelocity, 8);
  return state;
}

/** Writes the quaternion of a rotation matrix to elements 4 to 7 of a state (Shepperd, “Quaternion from Rotation Matrix”, 1978). */
function writeRotation(m: Float64Array, out: Float64Array): void {
  const at = (i: number) => m[i] ?? 0;
  const trace = at(0) + at(5) + at(10);
  if (trace > 0) {
    const s = 0.5 / Math.sqrt(trace + 1);
    out.set([(at(6) - at(9)) * s, (at(8) - at(2)) * s, (at(1) - at(4)) * s, 0.25 / s], 4);
  } else if (at(0) > at(5) && at(0) > at(10)) {
    const s = 2 * Math.sqrt(1 + at(0) - at(5) - at(10));
    out.set([0.25 * s, (at(4) + at(1)) / s, (at(8) + at(2)) / s, (at(6) - at(9)) / s], 4);
  } else if (at(5) > at(10)) {
    const s = 2 * Math.sqrt(1 + at(5) - at(0) - at(10));
    out.set([(at(4) + at(1)) / s, 0.25 * s, (at(9) + at(6)) / s, (at(8) - at(2)) / s], 4);
  } else {
    const s = 2 * Math.sqrt(1 + at(10) - at(0) - at(5));
    out.set([(at(8) + at(2)) / s, (at(9) + at(6)) / s, 0.25 * s, (at(1) - at(4)) / s], 4);
  }
}

/** Writes a state to a body, moved on by its velocity for `aheadS`. */
function writeBody(body: PhysicsBody, state: Float64Array, aheadS: number): void {
  const at = (i: number) => state[i] ?? 0;
  const m = body.worldFromBody;
  // No arrays: this runs for each body in each frame.
  const p = at(11) * aheadS * 0.5;
  const q = at(12) * aheadS * 0.5;
  const r = at(13) * aheadS * 0.5;
  let x = at(4) + p * at(7) + q * at(6) - r * at(5);
  let y = at(5) + q * at(7) + r * at(4) - p * at(6);
  let z = at(6) + r * at(7) + p * at(5) - q * at(4);
  let w = at(7) - p * at(4) - q * at(5) - r * at(6);
  if (aheadS > 0) {
    const length = Math.hypot(x, y, z, w);
    x /= length;
    y /= length;
    z /= length;
    w /= length;
  }
  m[0] = 1 - 2 * (y * y + z * z);
  m[1] = 2 * (x * y + z * w);
  m[2] = 2 * (x * z - y * w);
  m[4] = 2 * (x * y - z * w);
  m[5] = 1 - 2 * (x * x + z * z);
  m[6] = 2 * (y * z + x * w);
  m[8] = 2 * (x * z + y * w);
  m[9] = 2 * (y * z - x * w);
  m[10] = 1 - 2 * (x * x + y * y);
  for (let i = 0; i < 3; i++) {
    m[12 + i] = at(1 + i) + at(8 + i) * aheadS;
    body.velocity[i] = at(8 + i);
    body.angularVelocity[i] = at(11 + i);
  }
  body.isAsleep = at(14) === ASLEEP;
  body.isLost = at(14) === LOST;
}

function isEqual(a: Float64Array, b: Float64Array): boolean {
  for (let i = 0; i < a.length; i++) if (a[i] !== b[i]) return false;
  return true;
}
