import type { BodyDescription, DepthFrame, JointDescription, PhysicsJoint, VoxelSettings } from '../../kit/physics.ts';

/**
 * Commands from a world node to a physics engine, which runs in a worker or on the main thread. Another engine implements `PhysicsEngine`
 * and nothing else.
 */
export type PhysicsCommand =
  /** Starts again with an empty world. */
  | { readonly kind: 'clear' }
  | { readonly kind: 'settings'; readonly settings: WorldSettings }
  /** Adds a body. `state` is its initial state, `POSE_STRIDE` numbers. */
  | { readonly kind: 'add'; readonly id: number; readonly body: BodyDescription; readonly state: ArrayLike<number> }
  | { readonly kind: 'remove'; readonly id: number }
  /** Replaces the description of a body, shape included. */
  | { readonly kind: 'shape'; readonly id: number; readonly body: BodyDescription }
  /** Moves a body to another pose at once. The matrix is column-major 4×4, rigid; the velocity is in meters per second. */
  | { readonly kind: 'move'; readonly id: number; readonly worldFromBody: ArrayLike<number>; readonly velocity: ArrayLike<number> }
  /** Sets where a kinematic body or the target of a joint shall be at the end of the next step. */
  | { readonly kind: 'target'; readonly id: number; readonly worldFromBody: ArrayLike<number> }
  /** Applies impulses to a body: nine numbers per entry, as in `ImpulseList`. */
  | { readonly kind: 'impulse'; readonly id: number; readonly values: ArrayLike<number> }
  /** Accelerates a body in the next step alone, meters per second squared. */
  | { readonly kind: 'accelerate'; readonly id: number; readonly x: number; readonly y: number; readonly z: number }
  | { readonly kind: 'joint'; readonly id: number; readonly joint: JointCommand }
  | { readonly kind: 'unjoin'; readonly id: number }
  /** Sets the room as voxels; null removes it. Other settings than before start with an empty grid. */
  | { readonly kind: 'room'; readonly room: VoxelSettings | null; readonly friction: number; readonly restitution: number }
  /** Updates the voxels of the room by a depth frame. */
  | { readonly kind: 'depth'; readonly frame: DepthFrame }
  /** Replaces the voxels of the room by those of a file (`nodes/kit/voxel-file.ts`). A file that cannot be read leaves no voxels. */
  | { readonly kind: 'load-room'; readonly file: Uint8Array; readonly worldFromFile: ArrayLike<number> }
  /** Moves the voxels of the room, because world space has moved. Rigid, column-major 4×4. */
  | { readonly kind: 'move-room'; readonly worldFromFormer: ArrayLike<number> };

export interface WorldSettings {
  /** Gravity, meters per second squared. */
  readonly gravity: readonly [number, number, number];
  /** The number of substeps in a step of 1/60 s. */
  readonly substeps: number;
  /** Solver passes per substep. */
  readonly iterations: number;
  readonly sleep: boolean;
}

export interface JointCommand {
  readonly kind: PhysicsJoint['kind'];
  readonly a: number;
  /** Id of the second body. Null: the joint links `a` to a target of its own, which has the id of the joint. */
  readonly b: number | null;
  readonly description: JointDescription;
  readonly worldFromTarget: ArrayLike<number>;
}

/** The message to the worker: commands and a step. The buffers, also those of depth frames, are transferred and return with the answer. */
export interface StepMessage {
  readonly commands: readonly PhysicsCommand[];
  /** Time to simulate, seconds; 0 only applies the commands. */
  readonly deltaS: number;
  readonly poses: Float32Array<ArrayBuffer>;
  readonly touches: Float32Array<ArrayBuffer>;
  readonly wantsVoxels: boolean;
  /** Whether the answer shall have the room as a file. */
  readonly wantsFile: boolean;
}

export interface StepAnswer {
  /** The states of the bodies: `bodyCount` entries of `POSE_STRIDE` numbers. */
  readonly poses: Float32Array<ArrayBuffer>;
  /** The contacts that began: `touchCount` entries of `TOUCH_STRIDE` numbers. */
  readonly touches: Float32Array<ArrayBuffer>;
  readonly bodyCount: number;
  readonly touchCount: number;
  /** As `PhysicsEngine.voxels`; null if they are not wanted. */
  readonly voxels: Float32Array | null;
  /** The depth of the commands, if it was transferred. */
  readonly spent: readonly Float32Array<ArrayBuffer>[];
  /** As `PhysicsEngine.roomFile`; null if it is not wanted. */
  readonly file: Uint8Array | null;
  /** The message of an error, after which the engine is lost; null otherwise. */
  readonly failure: string | null;
}

/**
 * How many numbers the state of a body has: id; position of the body's origin; quaternion x, y, z, w; velocity of the origin; angular
 * velocity; flag: 0, `ASLEEP` or `LOST`.
 */
export const POSE_STRIDE = 15;
export const ASLEEP = 1;
/** The flag of a body that has fallen out of the room. */
export const LOST = 2;
/** How many numbers a contact has: ids of both bodies (0: the room); point; normal towards the first body; impulse. */
export const TOUCH_STRIDE = 9;

/** The description of an immovable body without mass and shape. Those of the room, the floor and the targets of joints derive from it. */
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

/** The array of a command that moves to the worker and back without a copy; null for most commands. */
export function depthOf(command: PhysicsCommand): Float32Array<ArrayBuffer> | null {
  if (command.kind !== 'depth' || !ArrayBuffer.isView(command.frame.meters)) return null;
  return command.frame.meters as Float32Array<ArrayBuffer>;
}

/** A physics engine. Ids are positive integers. Commands with numbers that are not finite have no effect. */
export interface PhysicsEngine {
  /** Carries out a command. `clear` is excluded, because the caller carries it out by creating another engine. */
  apply(command: Exclude<PhysicsCommand, { kind: 'clear' }>): void;
  step(deltaS: number): void;
  readonly bodyCount: number;
  /**
   * Writes the states of all bodies.
   *
   * @param out Must have room for all bodies.
   */
  writePoses(out: Float32Array): void;
  /** Writes the contacts that began in the last step, as many as fit. Returns their number. */
  writeTouches(out: Float32Array): number;
  /** Middles of the occupied voxels of the room: x, y, z, meters. For tools of the editor. */
  voxels(): Float32Array;
  /** The voxels of the room as a file; null without a room. */
  roomFile(): Uint8Array | null;
}
