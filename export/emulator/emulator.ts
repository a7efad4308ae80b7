import type { XRDevice } from 'iwer';
import type { DepthState } from './depth/session-depth.ts';
import type { Pixels } from './display/composite.ts';
import type { LightState } from './light/session-light.ts';

/** An installed device, and the hand that moves it. */
export interface Emulator {
  /** iwer's device: controllers, hands and recordings are moved through it. */
  readonly device: XRDevice;
  /** Takes effect with the next frame. */
  setPose(pose: HeadPose): void;
  setFovY(fovYRad: number): void;
  /** The device is turned, or its window changes: layers are of this size from the next frame on, as in Chrome on Android. */
  setSize(sizePx: readonly [width: number, height: number]): void;
  /** While false, frames come without a viewer pose. */
  setTracked(tracked: boolean): void;
  /** From the next frame on: depth as it should be, none, or the last one again and again. */
  setDepth(state: DepthState): void;
  /** From the next frame on: what light estimation says. */
  setLight(state: LightState): void;
  /** Moves the room's strongest light, in the room itself and in what is estimated of it: a unit vector towards it; null: back. */
  moveLight(directionWorld: readonly [number, number, number] | null): void;
  setVisibility(state: 'visible' | 'visible-blurred' | 'hidden'): void;
  /** The user re-centres: `local` and `local-floor` spaces begin anew where the viewer is, and say so with `reset`. */
  recenter(): void;
  /** The system ends the session, as a home button does. */
  endSession(): Promise<void>;

  /** A finger on a handheld device's screen; normalised, origin at the top left. */
  press(x: number, y: number): void;
  move(x: number, y: number): void;
  release(): void;

  /** Resolves once the page has a session with a base layer and waits for a frame. */
  frameRequested(): Promise<void>;
  /**
   * Runs frames of a device with a manual clock, one after the other, with a turn of the event loop after each.
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
  /** Distance to the first solid of the room, or null. */
  measure(originWorld: readonly number[], directionWorld: readonly number[]): number | null;
  /** What the device holds on its own GPU context, for leak tests. */
  counts(): { readonly geometries: number; readonly textures: number; readonly programs: number };
  /** Ends the session, takes the device out of the page and frees everything. */
  uninstall(): Promise<void>;
}

/** World from head: a column-major 4×4 matrix without scale, or its parts; the quaternion is x, y, z, w. */
export type HeadPose =
  | { readonly matrix: ArrayLike<number> }
  | { readonly position: readonly [number, number, number]; readonly quaternion?: readonly [number, number, number, number] };
