import type { BodyDescription, BodyShape, JointDescription, PhysicsJoint, Triple } from '../../../nodes/kit/physics.ts';
import { boxShape, sphereShape } from '../../../nodes/physics/body/solids.ts';
import { createCannonEngine } from '../../../nodes/physics/world/cannon-engine.ts';
import { ASLEEP, LOST, type PhysicsEngine, POSE_STRIDE, TOUCH_STRIDE, type WorldSettings } from '../../../nodes/physics/world/protocol.ts';

export const STEEL: Omit<BodyDescription, 'shapes'> = {
  mode: 'dynamic',
  massKg: 1,
  densityKgPerM3: 1000,
  friction: 0.5,
  rollingM: 0,
  restitution: 0,
  linearDamping: 0,
  angularDamping: 0,
  gravityFactor: 1,
};

export interface LabBody {
  readonly positionM: Triple;
  readonly rotation: readonly [x: number, y: number, z: number, w: number];
  readonly velocity: Triple;
  readonly spin: Triple;
  readonly isAsleep: boolean;
  readonly isLost: boolean;
}

/** An engine with bodies by id, for tests that compare motion with formulas. */
export interface Lab {
  readonly engine: PhysicsEngine;
  add(description: Partial<BodyDescription> & { readonly shapes: readonly BodyShape[] }, at: Partial<LabBody>): number;
  floor(friction?: number, restitution?: number): number;
  join(kind: PhysicsJoint['kind'], a: number, b: number | null, description: Partial<JointDescription>, at?: Triple): number;
  /** Runs seconds at 60 frames per second. */
  run(seconds: number, each?: (frame: number) => void): void;
  body(id: number): LabBody;
  all(): Map<number, LabBody>;
  touches(): { readonly a: number; readonly b: number; readonly impulse: number }[];
}

export function createLab(settings: Partial<WorldSettings> = {}, engine: PhysicsEngine = createCannonEngine()): Lab {
  engine.apply({ kind: 'settings', settings: { gravity: [0, -9.81, 0], substeps: 4, iterations: 4, sleep: false, ...settings } });
  let next = 1;
  const buffer = () => {
    const poses = new Float32Array(engine.bodyCount * POSE_STRIDE);
    engine.writePoses(poses);
    return poses;
  };
  const add: Lab['add'] = (description, { positionM = [0, 0, 0], rotation = [0, 0, 0, 1], velocity = [0, 0, 0], spin = [0, 0, 0] }) => {
    const id = next++;
    engine.apply({ kind: 'add', id, body: { ...STEEL, ...description }, state: [id, ...positionM, ...rotation, ...velocity, ...spin, 0] });
    return id;
  };
  return {
    engine,
    add,
    floor: (friction = 0.5, restitution = 0) => add({ mode: 'static', shapes: [{ kind: 'plane' }], friction, restitution }, {}),
    join: (kind, a, b, description, at = [0, 0, 0]) => {
      const id = next++;
      const worldFromTarget = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, ...at, 1];
      const defaults = { anchorA: [0, 0, 0], anchorB: [0, 0, 0], axisA: [0, 1, 0], axisB: [0, 1, 0] } as const;
      const numbers = { lengthM: 1, frequencyHz: 2, dampingRatio: 0.5, maxForceN: 0 };
      engine.apply({ kind: 'joint', id, joint: { kind, a, b, description: { ...defaults, ...numbers, ...description }, worldFromTarget } });
      return id;
    },
    run: (seconds, each) => {
      for (let i = 0; i < Math.round(seconds * 60); i++) {
        engine.step(1 / 60);
        each?.(i);
      }
    },
    body: (id) => {
      const poses = buffer();
      return bodyAt(
        poses,
        poses.findIndex((value, i) => i % POSE_STRIDE === 0 && value === id),
      );
    },
    all: () => {
      const poses = buffer();
      return new Map(Array.from({ length: engine.bodyCount }, (_, i) => [poses[i * POSE_STRIDE] ?? 0, bodyAt(poses, i * POSE_STRIDE)]));
    },
    touches: () => {
      const out = new Float32Array(TOUCH_STRIDE * 64);
      const count = engine.writeTouches(out);
      return Array.from({ length: count }, (_, i) => {
        const n = (j: number) => out[i * TOUCH_STRIDE + j] ?? 0;
        return { a: n(0), b: n(1), impulse: n(8) };
      });
    },
  };
}

function bodyAt(poses: Float32Array, o: number): LabBody {
  const n = (i: number) => poses[o + i] ?? Number.NaN;
  return {
    positionM: [n(1), n(2), n(3)],
    rotation: [n(4), n(5), n(6), n(7)],
    velocity: [n(8), n(9), n(10)],
    spin: [n(11), n(12), n(13)],
    isAsleep: n(14) === ASLEEP,
    isLost: n(14) === LOST,
  };
}

export const cube = (sizeM: number): BodyShape[] => [boxShape([sizeM, sizeM, sizeM])];
export const ball = (radiusM: number): BodyShape[] => [sphereShape(radiusM)];

/** A rotation about an axis. */
export function turned(axis: Triple, angleRad: number): readonly [number, number, number, number] {
  const s = Math.sin(angleRad / 2);
  return [axis[0] * s, axis[1] * s, axis[2] * s, Math.cos(angleRad / 2)];
}
