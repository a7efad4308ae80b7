/**
 * Hit tests: where rays meet the real room. `SessionService.openHitTest` follows a pointer or the viewer from frame to frame;
 * `SessionService.castRay` answers any ray. Types only; the runtime is in `export/runtime/spatial`.
 */

/**
 * What answered: the device's own hit test, a detected plane, a detected mesh, room depth, or the floor at y = 0. They are asked in this
 * order, and the first that has a hit answers.
 */
export type HitSource = 'session' | 'plane' | 'mesh' | 'depth' | 'floor';

/** A ray in some space; its direction may have any length. Reused: fill it, use it, keep none. */
export interface Ray {
  ox: number;
  oy: number;
  oz: number;
  dx: number;
  dy: number;
  dz: number;
}

/** `viewer`: the middle of the view. `left`, `right`: controllers or hands. `pointers`: everything that presses or hovers. */
export type RayOrigin = 'viewer' | 'left' | 'right' | 'pointers';

export interface HitTestOptions {
  readonly from: RayOrigin;
  /** Column-major 4×4, rigid: the ray in the space of its origin, along its -z axis. Default: the origin's own -z axis. Not for `pointers`. */
  readonly offsetRay?: ArrayLike<number> | null;
  /** Sources that may answer. Default: all. */
  readonly sources?: readonly HitSource[];
}

/**
 * A hit test that runs until it is closed. The node that opens it closes it in `dispose`.
 */
export interface HitTest {
  /** The hits of this frame: of one ray nearest first, of `pointers` the nearest of each. The same object every frame. */
  read(): HitList;
  /** Frees what the device holds for it; safe to call twice. */
  close(): void;
}

/** Reused from frame to frame: read it during the frame, keep no hit. */
export interface HitList {
  readonly count: number;
  /**
   * @param index From 0 to `count - 1`.
   * @throws RangeError for another index.
   */
  at(index: number): Hit;
}

export interface Hit {
  /**
   * Column-major 4×4, rigid: y is the surface's normal, towards the ray's origin. On floors and ceilings z points to the viewer; on walls
   * z points down. x is to the right as the viewer sees it.
   */
  readonly worldFromHit: Float32Array;
  /** From the ray's origin. */
  readonly distanceM: number;
  readonly source: HitSource;
  /** The device can anchor it. Other hits are anchored as poses. */
  readonly anchorable: boolean;
  /** Semantic label of the plane or mesh, or empty. */
  readonly label: string;
  /** Id of the pointer whose ray it is; 0 for other rays. */
  readonly pointer: number;
  /** Index of the frame whose measurement answered: earlier than the current one for depth that was read back from the GPU. */
  readonly frame: number;
}

/** Where a ray that no device follows is answered; owned by the caller. */
export interface HitRecord extends Hit {
  distanceM: number;
  source: HitSource;
  anchorable: boolean;
  label: string;
  pointer: number;
  frame: number;
}

/** @returns An empty record for `SessionService.castRay`. */
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
