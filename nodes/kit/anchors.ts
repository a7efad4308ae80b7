import type { Hit } from './hit-test.ts';

/** Poses that stay at their point of the room. Types only; the runtime is in `export/runtime/spatial`. */
export interface AnchorService {
  /**
   * Asks the session for an anchor. Returns at once; promises resolve inside.
   *
   * @param at A hit of this frame, or a pose in world space: column-major 4×4, rigid.
   * @returns An anchor, which the caller deletes.
   * @throws RangeError for a pose that is not 16 finite numbers.
   */
  create(at: Hit | ArrayLike<number>): Anchor;
}

/**
 * - `pending`: the device has not confirmed it yet.
 * - `tracked`: `worldFromAnchor` is of this frame.
 * - `lost`: the device does not see it at present; the last pose stays.
 * - `deleted`: it is gone, by the node, the device or the end of the session; the last pose stays.
 * - `unsupported`: the session has no anchors, or refused this one; the pose is the one it was created with.
 */
export type AnchorState = 'pending' | 'tracked' | 'lost' | 'deleted' | 'unsupported';

export interface Anchor {
  /** Unique within the page. */
  readonly id: string;
  readonly state: AnchorState;
  /** Column-major 4×4, rigid. Until the device confirms it, the pose that it was created with. The same array every frame. */
  readonly worldFromAnchor: Float32Array;
  /** Safe to call twice. */
  delete(): void;
}
