/**
 * Hit tests: where rays meet the real room. `SessionService.openHitTest` follows a pointer or the viewer from frame to frame;
 * `SessionService.castRay` answers any ray. Types only; the runtime is in `export/runtime/spatial`.
 */

/**
 * The source of a hit: the device's own hit test, a detected plane, a detected mesh, room depth, the voxels of a physics room, or the floor
 * at y = 0. The sources are asked in this order, and the first that has a hit answers.
 */
export type HitSource = 'session' | 'plane' | 'mesh' | 'depth' | 'voxels' | 'floor';

/** A ray as six numbers, in a space that its user defines; the direction may have any length. Such objects are reused: do not keep one. */
export interface Ray {
  ox: number;
  oy: number;
  oz: number;
  dx: number;
  dy: number;
  dz: number;
}

/** Where a ray meets a surface: the distance along the ray in meters, and the normal, which may have any length. */
export interface RayMeeting {
  distanceM: number;
  nx: number;
  ny: number;
  nz: number;
}

/** A room that a node measures, which answers the source `voxels`. The node offers it by `SessionService.answerRays`. */
export interface MeasuredRoom {
  /** Whether rays may come: hit tests are open, or the last frame has cast rays. Set once per frame, before nodes are updated. */
  isAsked: boolean;
  /**
   * Follows a ray, whose direction has the length 1, to the first surface.
   *
   * @returns False if it meets nothing; `out` is then unchanged.
   */
  cast(out: RayMeeting, ray: Ray): boolean;
}

/**
 * Where a hit test casts its rays from. `viewer`: the middle of the view. `left`, `right`: controllers or hands. `pointers`: everything
 * that presses or hovers.
 */
export type RayOrigin = 'viewer' | 'left' | 'right' | 'pointers';

export interface HitTestOptions {
  readonly from: RayOrigin;
  /**
   * The ray relative to its origin: column-major 4×4, rigid; it points along its own -z axis. Default: the origin's -z axis. Ignored for
   * `pointers`.
   */
  readonly offsetRay?: ArrayLike<number> | null;
  /** The sources whose answers are accepted. Default: all. */
  readonly sources?: readonly HitSource[];
}

/**
 * A hit test that runs until it is closed. The node that opens it closes it in `dispose`.
 */
export interface HitTest {
  /**
   * Returns the hits of this frame. For one ray: nearest first. For `pointers`: the nearest hit of each pointer. The same object every
   * frame.
   */
  read(): HitList;
  /** Releases what the device holds for the hit test. Safe to call twice. */
  close(): void;
}

/** The hits of one frame. The object is reused from frame to frame: read it during the frame, keep no hit. */
export interface HitList {
  readonly count: number;
  /**
   * Returns one of the hits.
   *
   * @param index From 0 to `count - 1`.
   * @throws RangeError for another index.
   */
  at(index: number): Hit;
}

export interface Hit {
  /**
   * The pose of the hit: column-major 4×4, rigid. y is the surface's normal, towards the ray's origin. On floors and ceilings z points to
   * the viewer; on walls z points down. x is to the right as the viewer sees it.
   */
  readonly worldFromHit: Float32Array;
  /** Distance from the ray's origin. */
  readonly distanceM: number;
  readonly source: HitSource;
  /** Whether the device can anchor this hit itself. Other hits are anchored as poses. */
  readonly anchorable: boolean;
  /** Semantic label of the plane or mesh, or empty. */
  readonly label: string;
  /** Id of the pointer whose ray it is; 0 for other rays. */
  readonly pointer: number;
  /** Index of the frame whose measurement answered: earlier than the current one for depth that was read back from the GPU. */
  readonly frame: number;
}

/** A hit that its owner creates once, and that `SessionService.castRay` fills. */
export interface HitRecord extends Hit {
  distanceM: number;
  source: HitSource;
  anchorable: boolean;
  label: string;
  pointer: number;
  frame: number;
}

/**
 * Creates an empty record for `SessionService.castRay`.
 *
 * @example
 * const hit = createHit();
 * if (ctx.session.castRay(worldFromRay, hit)) outputs.distanceM.value = hit.distanceM;
 */
export function createHit(): HitRecord {
  return {
    worldFromHit: Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1),
    distanceM: 0,
    source: 'floor',
    anchorable: false,
    label: '',
    pointer: 0,
    frame: 0,
  };
}
