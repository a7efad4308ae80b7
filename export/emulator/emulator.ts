import type { XRDevice } from 'iwer';
import type { DepthState } from './depth/session-depth.ts';
import type { Pixels } from './display/composite.ts';
import type { LightState } from './light/session-light.ts';

/** The controls of an installed device. Poses are in world space: meters, y up, the floor at y = 0. */
export interface Emulator {
  /** The device of iwer, which controls controllers, hands and recordings. */
  readonly device: XRDevice;
  /** Sets the pose of the head from the next frame on. */
  setPose(pose: HeadPose): void;
  setFovY(fovYRad: number): void;
  /** Rotates the device or resizes its window: layers have this size from the next frame on, as in Chrome on Android. */
  setSize(sizePx: readonly [width: number, height: number]): void;
  /** While false, frames come without a viewer pose. */
  setTracked(tracked: boolean): void;
  /** From the next frame on: correct depth, no depth, or the last depth in every frame. */
  setDepth(state: DepthState): void;
  /** From the next frame on: what light estimation says. */
  setLight(state: LightState): void;
  /** Moves the room's strongest light, in the room itself and in what is estimated of it: a unit vector towards it; null: back. */
  moveLight(directionWorld: readonly [number, number, number] | null): void;
  setVisibility(state: 'visible' | 'visible-blurred' | 'hidden'): void;
  /** The user re-centers: `local` and `local-floor` spaces begin anew where the viewer is, and say so with `reset`. */
  recenter(): void;
  /** The system ends the session, as a home button does. */
  endSession(): Promise<void>;

  /** A finger on a handheld device's screen; normalized, origin at the top left. */
  press(x: number, y: number): void;
  move(x: number, y: number): void;
  release(): void;

  /** Resolves once the page has an immersive session with something to draw into and waits for a frame. */
  frameRequested(): Promise<void>;
  /**
   * Runs frames of a device with a manual clock, one after the other, with a turn of the event loop after each. Sessions on the page
   * get one with each, too.
   *
   * @throws Error when there is no session, or the page no longer asks for frames.
   */
  stepFrame(count?: number): Promise<void>;

  /** What the page drew in the last frame: premultiplied. */
  readLayer(): Pixels;
  /** What the device's cameras saw in the last frame. */
  readRoom(): Pixels;
  /** What the user saw in the last frame. */
  readComposite(): Pixels;
  /**
   * Casts a ray into the room.
   *
   * @param directionWorld Any length except 0.
   * @returns Meters to the first surface, or null where the ray hits nothing.
   */
  measure(originWorld: readonly number[], directionWorld: readonly number[]): number | null;
  /** GPU objects of the device's own context, for leak tests. */
  counts(): { readonly geometries: number; readonly textures: number; readonly programs: number };
  /** Ends all sessions, removes the device from the page and disposes everything. */
  uninstall(): Promise<void>;
}

/** World from head: a column-major 4×4 matrix without scale, or its parts; the quaternion is x, y, z, w. */
export type HeadPose =
  | { readonly matrix: ArrayLike<number> }
  | { readonly position: readonly [number, number, number]; readonly quaternion?: readonly [number, number, number, number] };
