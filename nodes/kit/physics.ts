/**
 * What a `body` wire carries. Nodes fill the lists; the world that the wire reaches simulates them (ADR 40). Only the node that outputs a
 * list changes it, and it raises `version` when it adds or removes entries.
 *
 * @example
 * ctx.outputs.body.bodies.push(body);
 * ctx.outputs.body.version++;
 */
export interface BodyList {
  version: number;
  readonly bodies: PhysicsBody[];
  /** Whether a physics world reads the list. The world writes it in each frame, also while its engine has not answered yet. */
  isInWorld?: boolean;
  /** The room that all bodies of the world collide with; absent if none is measured. */
  room?: PhysicsRoom;
}

/** The shape of the real room, which the physics world builds from depth images as a voxel grid. */
export interface PhysicsRoom {
  settings: VoxelSettings;
  friction: number;
  restitution: number;
  /** A number that is raised with each change of the room's settings, and to start again with an empty grid. */
  version: number;
  /** Depth images since the last frame; the world reads them and empties the list. */
  readonly frames: DepthFrame[];
  /** Arrays of depth frames that the worker of the world has read. The room uses them again and removes them. */
  readonly spent: Float32Array<ArrayBuffer>[];
  /** Changes of the whole grid, oldest first, before the depth of this frame; the world carries them out and empties the list. */
  readonly edits: RoomEdit[];
  /** Whether the world shall write the grid to `file`. The world then sets it to false. */
  wantsFile: boolean;
  /** The grid as a file (`nodes/kit/voxel-file.ts`) when it was last asked for; null until then. */
  file: Uint8Array | null;
  /** How often the whole grid was changed or begun again so far. The room counts. */
  changes: number;
  /** `changes` when `file` was asked for: with another number, the file is that of a former grid or of a former world space. */
  fileChanges: number;
}

/**
 * Creates a room that no depth image has been added to.
 *
 * @example
 * const room = createPhysicsRoom({ edgeM: 0.05, threshold: 0.5, speed: 0.2, farM: 4 }, 0.6, 0);
 */
export function createPhysicsRoom(settings: VoxelSettings, friction: number, restitution: number): PhysicsRoom {
  return {
    settings,
    friction,
    restitution,
    version: 0,
    frames: [],
    spent: [],
    edits: [],
    wantsFile: false,
    file: null,
    changes: 0,
    fileChanges: 0,
  };
}

/** A change of all voxels of the room. The matrices are rigid, column-major 4×4. */
export type RoomEdit =
  /** The voxels are those of a file. */
  | { readonly kind: 'load'; readonly file: Uint8Array; readonly worldFromFile: ArrayLike<number> }
  /** World space has moved. */
  | { readonly kind: 'move'; readonly worldFromFormer: ArrayLike<number> };

/** Settings of the voxel grid that depth images fill; the letters are those of equation 1 of the mixed-reality paper (section 3.6). */
export interface VoxelSettings {
  readonly edgeM: number;
  /** T: voxels of at least this weight are occupied. */
  readonly threshold: number;
  /** U at 30 depth frames per second. */
  readonly speed: number;
  /** Depth beyond this distance is ignored. */
  readonly farM: number;
  /** Whether bodies collide with a smooth surface through the voxels instead of with the sides of the cubes. */
  readonly isSmooth?: boolean;
}

/** A depth image with the pose and rays of its texels. */
export interface DepthFrame {
  /**
   * Depth along the axis of the view, rows from the bottom; 0 is unknown. A typed array moves to the worker of the world without a copy: it
   * is then empty here, and its buffer comes back in `PhysicsRoom.spent`.
   */
  readonly meters: ArrayLike<number>;
  readonly widthPx: number;
  readonly heightPx: number;
  /** The pose of the depth camera: column-major 4×4, rigid; the view looks along -z. */
  readonly worldFromDepth: ArrayLike<number>;
  /** The ray (x, y, -1) of a texel (i, j): x = r0 i + r1 j + r2, y = r3 i + r4 j + r5. */
  readonly rayFromTexel: ArrayLike<number>;
  /** Seconds since the previous depth frame. */
  readonly deltaS: number;
}

/** How a body moves: by forces; as its node says, with a velocity; not at all. */
export type BodyMode = 'dynamic' | 'kinematic' | 'static';

/** The shape of a part of a body, in the axes of the body, meters. */
export type BodyShape =
  | { readonly kind: 'sphere'; readonly centerM: Triple; readonly radiusM: number }
  /** A convex polyhedron. `faces` lists the vertices of each flat face counterclockwise, seen from outside. */
  | { readonly kind: 'hull'; readonly verticesM: readonly Triple[]; readonly faces: readonly (readonly number[])[] }
  /** The half-space below the plane through the origin of the body whose normal is y. Only of bodies that are not dynamic. */
  | { readonly kind: 'plane' }
  /** Triangles, of which both sides collide: x, y, z of each vertex, and three indices per triangle. Only of bodies that are not dynamic. */
  | { readonly kind: 'mesh'; readonly positionsM: Float32Array; readonly indices: Uint32Array };

export type Triple = readonly [x: number, y: number, z: number];

/** What the engine needs to know of a body. Immutable: a change replaces the description and increments the `version` of its list. */
export interface BodyDescription {
  readonly mode: BodyMode;
  /** The parts of a rigid body. Their frame is that of the body, whose origin need not be the center of mass. */
  readonly shapes: readonly BodyShape[];
  /** Mass in kilograms. At 0 the mass follows from the density. */
  readonly massKg: number;
  /** Kilograms per cubic meter. */
  readonly densityKgPerM3: number;
  /** Coulomb coefficient; the coefficient of a contact is the geometric mean of both bodies. */
  readonly friction: number;
  /** Rolling resistance as a lever arm, meters. A contact has the greater value of both bodies. */
  readonly rollingM: number;
  /** Bounciness, in [0, 1]. A contact has the greater value of both bodies. */
  readonly restitution: number;
  /** The part of the velocity that is lost in a second, in [0, 1). */
  readonly linearDamping: number;
  readonly angularDamping: number;
  /** Factor on the gravity of the world for this body. */
  readonly gravityFactor: number;
}

/** A body as nodes and the physics world share it. The world reads the fields up to `acceleration`, and `joints`, and writes the others. */
export interface PhysicsBody {
  /** Key of the body, unique within the graph: node id and key of the object. */
  readonly key: string;
  description: BodyDescription;
  /** A number that is raised whenever `description` is replaced. */
  version: number;
  /**
   * The initial pose of the body; for a kinematic body, the pose that it shall have at the end of this frame. Column-major 4×4, rigid. A
   * matrix that is not finite is ignored.
   */
  readonly worldFromTarget: Float64Array;
  /** A number that is raised to move the body to `worldFromTarget` at once, with the velocity `targetVelocity`. */
  jumps: number;
  /** The velocity of a dynamic body at its start and after a jump, meters per second, world space. */
  readonly targetVelocity: Float64Array;
  /** Impulses since the last frame; the world empties the list. */
  readonly impulses: ImpulseList;
  /** Acceleration by force fields in the next step, meters per second squared, world space; the world resets it to 0. */
  readonly acceleration: Float64Array;

  /** The pose of the body after the last step: column-major 4×4, rigid. The world writes it before the node that owns the body updates. */
  readonly worldFromBody: Float64Array;
  /** Velocity in meters per second and angular velocity in radians per second, world space. */
  readonly velocity: Float64Array;
  readonly angularVelocity: Float64Array;
  isAsleep: boolean;
  /** Whether the body has fallen out of the room that depth has shown. */
  isLost: boolean;
  /** Contacts that began in the last step. */
  readonly touches: TouchList;
  /** The joints whose first body (`a`) is this one. Nodes add and remove them; the world reads them. */
  readonly joints: PhysicsJoint[];
  /** The world that simulates the body; null until one does. */
  world: BodyWorld | null;
}

/** The physics world, as far as the nodes of its bodies use it. */
export interface BodyWorld {
  /** Copies the result of the last step to all bodies, at most once per frame. Nodes with bodies call it first in `update`. */
  applyPoses(): void;
  readonly control: WorldControl;
  /** Mass and center of mass of a body, in the axes of the body. Only for tools: it is computed with each call. */
  massOf(body: PhysicsBody): { readonly massKg: number; readonly centerM: Triple };
}

/** What tools of the editor ask of a world and read of it. Pages do not use it. */
export interface WorldControl {
  /** The bodies stand still, whatever the graph says. */
  isPaused: boolean;
  /** Steps of 1/60 s to simulate while it is paused. The world sets it to 0. */
  steps: number;
  /** All bodies shall begin anew. The world sets it to false. */
  wantsReset: boolean;
  wantsVoxels: boolean;
  /** Middles of the occupied voxels of the room after the last step (x, y, z, meters), if they are wanted; null otherwise. */
  voxels: Float32Array | null;
  /** Edge of a voxel, meters. */
  edgeM: number;
}

/**
 * Creates the controls of a world that plays.
 *
 * @example
 * const control = createWorldControl();
 * control.isPaused = true;
 * control.steps = 1;
 */
export function createWorldControl(): WorldControl {
  return { isPaused: false, steps: 0, wantsReset: false, wantsVoxels: false, voxels: null, edgeM: 0 };
}

/** The impulses and forces on a body in a frame, in a buffer that is reused. */
export interface ImpulseList {
  count: number;
  /** Per entry: impulse x, y, z (newton seconds), angular impulse x, y, z (newton meter seconds), point x, y, z (world space). */
  readonly values: Float64Array;
}

/** The contacts of a body that began in a frame, in a buffer that is reused. */
export interface TouchList {
  count: number;
  readonly entries: Touch[];
}

/** A contact that began in the last step. */
export interface Touch {
  /** Key of the other body; empty for the room. */
  otherKey: string;
  /** Where the bodies touch and the normal of the contact, world space; the normal points towards this body. */
  readonly pointWorld: Float64Array;
  readonly normalWorld: Float64Array;
  /** The impulse of the contact, newton seconds. */
  impulseNs: number;
}

/** The most entries of an impulse list. */
export const MAX_IMPULSES = 16;
/** The most contacts of a body per frame that are reported as pulses. */
export const MAX_TOUCHES = 16;

/** A link between two bodies, or a body and a pose. */
export interface PhysicsJoint {
  readonly key: string;
  readonly kind: 'hinge' | 'spring' | 'rope' | 'lock' | 'drag';
  readonly a: PhysicsBody;
  /** The second body. Null: the joint links `a` to the pose `worldFromTarget`. */
  readonly b: PhysicsBody | null;
  readonly description: JointDescription;
  /** The pose to which the joint links `a` if there is no `b`; column-major 4×4, rigid. */
  readonly worldFromTarget: Float64Array;
  /** Whether the joint acts. While it is off, the bodies are free. */
  isOn: boolean;
  /** A number that is raised with each change of the description. */
  version: number;
}

/** The settings of a joint. Each kind of joint reads some of them. */
export interface JointDescription {
  /** Where the joint is attached to each body, in the axes of that body, or of the target if there is no `b`. */
  anchorA: Triple;
  anchorB: Triple;
  /** Only for hinges: the axis as a unit vector, in the axes of `a`, and in those of `b` or the target. */
  axisA: Triple;
  axisB: Triple;
  /** The greatest length of a rope, or the length of a spring at rest. */
  lengthM: number;
  /** Only for springs and drags: oscillations per second, and damping as a fraction of critical damping. */
  frequencyHz: number;
  dampingRatio: number;
  /** Only for drags and locks: the greatest force; 0 is unlimited. */
  maxForceN: number;
}

/**
 * Creates a body. The node that creates it adds it to its list, calls `world?.applyPoses()` at the start of each `update`, and reads
 * `worldFromBody` after that.
 *
 * @param key Unique within the graph.
 *
 * @example
 * const body = createPhysicsBody(`${ctx.node}/${item.key}`, description);
 */
export function createPhysicsBody(key: string, description: BodyDescription): PhysicsBody {
  return {
    key,
    description,
    version: 0,
    worldFromTarget: Float64Array.of(...IDENTITY),
    jumps: 0,
    targetVelocity: new Float64Array(3),
    acceleration: new Float64Array(3),
    impulses: { count: 0, values: new Float64Array(9 * MAX_IMPULSES) },
    worldFromBody: Float64Array.of(...IDENTITY),
    velocity: new Float64Array(3),
    angularVelocity: new Float64Array(3),
    isAsleep: false,
    isLost: false,
    touches: { count: 0, entries: [] },
    joints: [],
    world: null,
  };
}

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] as const;

/**
 * Adds an impulse to a body, for the next step. A body takes at most `MAX_IMPULSES` in a frame; later ones are dropped.
 *
 * @param impulse Newton-seconds, world space.
 * @param angular Newton-meter-seconds, world space.
 * @param pointWorld Where the impulse acts; null: the origin of the body.
 *
 * @example
 * addImpulse(body, [0, 2, 0], [0, 0, 0], null);
 */
export function addImpulse(
  { impulses, worldFromBody }: PhysicsBody,
  impulse: ArrayLike<number>,
  angular: ArrayLike<number>,
  pointWorld: ArrayLike<number> | null,
): void {
  if (impulses.count === MAX_IMPULSES) return;
  const o = 9 * impulses.count++;
  for (let i = 0; i < 3; i++) {
    impulses.values[o + i] = impulse[i] ?? 0;
    impulses.values[o + 3 + i] = angular[i] ?? 0;
    impulses.values[o + 6 + i] = (pointWorld ? pointWorld[i] : worldFromBody[12 + i]) ?? 0;
  }
}
