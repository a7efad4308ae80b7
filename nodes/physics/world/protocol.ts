import type { BodyDescription, DepthFrame, JointDescription, PhysicsJoint, VoxelSettings } from '../../kit/physics.ts';

/**
 * Messages between a world node and an engine, which runs in a worker or on the main thread. Another engine implements `PhysicsEngine`
 * and nothing else.
 */
export type PhysicsCommand =
  /** Begins anew with an empty world. */
  | { readonly kind: 'clear' }
  | { readonly kind: 'settings'; readonly settings: WorldSettings }
  /** `state` begins a body with the numbers of `POSE_STRIDE`. */
  | { readonly kind: 'add'; readonly id: number; readonly body: BodyDescription; readonly state: ArrayLike<number> }
  | { readonly kind: 'remove'; readonly id: number }
  /** Another description, shape included. */
  | { readonly kind: 'shape'; readonly id: number; readonly body: BodyDescription }
  /** To another pose at once. Column-major 4×4; meters per second. */
  | { readonly kind: 'move'; readonly id: number; readonly worldFromBody: ArrayLike<number>; readonly velocity: ArrayLike<number> }
  /** Of kinematic bodies: the pose at the end of the next step. Also of the targets of joints. */
  | { readonly kind: 'target'; readonly id: number; readonly worldFromBody: ArrayLike<number> }
  /** Nine numbers per entry, as in `ImpulseList`. */
  | { readonly kind: 'impulse'; readonly id: number; readonly values: ArrayLike<number> }
  /** Meters per second squared, for the next step alone. */
  | { readonly kind: 'accelerate'; readonly id: number; readonly x: number; readonly y: number; readonly z: number }
  | { readonly kind: 'joint'; readonly id: number; readonly joint: JointCommand }
  | { readonly kind: 'unjoin'; readonly id: number }
  /** The room as voxels; null removes it. Others settings begin with an empty grid. */
  | { readonly kind: 'room'; readonly room: VoxelSettings | null; readonly friction: number; readonly restitution: number }
  /** Depth that the room is updated with. */
  | { readonly kind: 'depth'; readonly frame: DepthFrame };

export interface WorldSettings {
  /** Meters per second squared. */
  readonly gravity: readonly [number, number, number];
  /** Parts of a step of 1/60 s. */
  readonly substeps: number;
  /** Solver passes per substep. */
  readonly iterations: number;
  readonly sleep: boolean;
}

export interface JointCommand {
  readonly kind: PhysicsJoint['kind'];
  readonly a: number;
  /** Null: the joint has a target of its own, whose id is that of the joint. */
  readonly b: number | null;
  readonly description: JointDescription;
  readonly worldFromTarget: ArrayLike<number>;
}

/** Sent to the worker; the buffers are transferred and return with the answer. */
export interface StepMessage {
  readonly commands: readonly PhysicsCommand[];
  /** Seconds to simulate; 0 only applies the commands. */
  readonly deltaS: number;
  readonly poses: Float32Array<ArrayBuffer>;
  readonly touches: Float32Array<ArrayBuffer>;
}

export interface StepAnswer {
  /** `bodyCount` entries of `POSE_STRIDE` numbers. */
  readonly poses: Float32Array<ArrayBuffer>;
  /** `touchCount` entries of `TOUCH_STRIDE` numbers. */
  readonly touches: Float32Array<ArrayBuffer>;
  readonly bodyCount: number;
  readonly touchCount: number;
  /** The message of an error, after which the engine is lost; null otherwise. */
  readonly failure: string | null;
}

/** Id; position of the origin of the body; quaternion x, y, z, w; velocity of the origin; angular velocity; 0, `ASLEEP` or `LOST`. */
export const POSE_STRIDE = 15;
export const ASLEEP = 1;
/** The body has fallen out of the room that was seen. */
export const LOST = 2;
/** Ids of both bodies (0: the room); point; normal towards the first; impulse. */
export const TOUCH_STRIDE = 9;

/** A body without mass and shape that does not move; the room, the floor and the targets of joints are variants of it. */
export const FIXED_BODY: BodyDescription = {
  mode: 'static',
  shapes: [],
  massKg: 0,
  densityKgPerM3: 0,
  friction: 0,
  rollingM: 0,
  restitution: 0,
  linearDamping: 0,
  angularDamping: 0,
  gravityFactor: 0,
};

/** A physics engine. Ids are positive integers. Commands with numbers that are not finite have no effect. */
export interface PhysicsEngine {
  /** Every command but `clear`, which creates another engine. */
  apply(command: Exclude<PhysicsCommand, { kind: 'clear' }>): void;
  step(deltaS: number): void;
  readonly bodyCount: number;
  /** @param out Has room for all bodies. */
  writePoses(out: Float32Array): void;
  /** Contacts that began in the last step, as many as fit. Gives their number. */
  writeTouches(out: Float32Array): number;
}
