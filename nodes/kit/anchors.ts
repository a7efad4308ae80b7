import type { Hit } from './hit-test.ts';

/**
 * Creates and restores anchors: poses that stay at their point of the real room. Types only; the runtime is in `export/runtime/spatial`.
 */
export interface AnchorService {
  /**
   * Asks the session for an anchor. Returns at once: the anchor's `state` changes when the session answers.
   *
   * @param at A hit of this frame, or a pose in world space: column-major 4×4, rigid.
   * @returns An anchor, which the caller deletes.
   * @param keepAs Asks the device to keep it for later visits of the page, under this name. It replaces an earlier one of that name.
   * @throws RangeError for a pose that is not 16 finite numbers.
   */
  create(at: Hit | ArrayLike<number>, keepAs?: string): Anchor;
  /**
   * Asks the device for the anchor that was kept under a name, in this visit or an earlier one.
   *
   * @returns An anchor without a pose until it is `tracked`, and `deleted` if the device no longer has it; null if none is kept, or the
   * session keeps none.
   */
  restore(name: string): Anchor | null;
  /** Stops keeping the anchor of that name. An anchor in use stays until it is deleted. */
  forget(name: string): void;
}

/**
 * Whether the device keeps an anchor for later visits. `not-asked`: nothing asked it to. `pending`: it has not answered. `kept`: it does.
 * `refused`: it refused, or keeps no anchors at all.
 */
export type AnchorKeeping = 'not-asked' | 'pending' | 'kept' | 'refused';

/**
 * - `pending`: the device has not confirmed the anchor yet.
 * - `tracked`: `worldFromAnchor` is of this frame.
 * - `lost`: the device does not see it at present; the last pose stays.
 * - `deleted`: the node, the device or the end of the session has removed it; the last pose stays.
 * - `unsupported`: the session has no anchors, or refused this one; the pose is the one it was created with.
 */
export type AnchorState = 'pending' | 'tracked' | 'lost' | 'deleted' | 'unsupported';

export interface Anchor {
  /** Id of the anchor, unique within the page. */
  readonly id: string;
  readonly state: AnchorState;
  /**
   * The pose of the anchor: column-major 4×4, rigid. Until the device confirms the anchor, the pose that it was created with. The same
   * array every frame.
   */
  readonly worldFromAnchor: Float32Array;
  readonly keeping: AnchorKeeping;
  /** How many older anchors the device had to forget to keep this one. */
  readonly evicted: number;
  /** Deletes the anchor. Safe to call twice. */
  delete(): void;
}
