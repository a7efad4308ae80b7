import type { XRDevice } from 'iwer';
import type { DepthState } from './depth/session-depth.ts';
import type { Pixels } from './display/composite.ts';
import type { LightState } from './light/session-light.ts';
import type { Drift } from './world.ts';

/** Controls of an installed device. Poses are in world space: meters, y up, the floor at y = 0. */
export interface Emulator {
  /** The underlying device of iwer, whose interface controls controllers, hands and recordings. */
  readonly device: XRDevice;
  /** Sets the pose of the head from the next frame on. */
  setPose(pose: HeadPose): void;
  /** Pose of the first view in the room in the last frame, column-major 4×4; null before the first. Drift does not affect it. */
  viewPose(): Float32Array | null;
  /** Sets the vertical field of view, in radians. */
  setFovY(fovYRad: number): void;
  /** Rotates the device or resizes its window: layers have this size from the next frame on, as in Chrome on Android. */
  setSize(sizePx: readonly [width: number, height: number]): void;
  /** Sets whether the device has tracking. Without tracking, frames have no viewer pose. */
  setTracked(tracked: boolean): void;
  /** Sets what depth sensing returns from the next frame on: correct depth, no depth, or the last depth in every frame. */
  setDepth(state: DepthState): void;
  /**
   * Sets what light estimation returns from the next frame on: the room's light, no estimate, the last estimate in every frame, or changes
   * to the room's light.
   */
  setLight(state: LightState): void;
  /**
   * Moves the room's strongest light, in the images, where it is seen as a lamp, and in the light estimate: a unit vector from the scene towards the light. Null
   * restores it.
   */
  moveLight(directionWorld: readonly [number, number, number] | null): void;
  /** Sets whether anchors have poses from the next frame on. */
  setAnchors(state: 'tracked' | 'lost'): void;
  /** Deletes all anchors of the session, as the system of a device does when it forgets the room. */
  deleteAnchors(): void;
  /**
   * Makes tracking drift at once: moves reference spaces relative to the room, without an event; anchors stay at their points of the room.
   * Drifts add up.
   *
   * @param offsetM In the room's axes, meters.
   * @param yawRad About the vertical through the room's origin.
   */
  drift(offsetM: readonly [number, number, number], yawRad: number): void;
  /**
   * Makes tracking drift steadily from now on, for example by 2 cm and 1° per minute; null ends the drift.
   *
   * @param drift Offset and angle per minute of the session's time, with the axes of `drift`.
   */
  setDrift(drift: Drift | null): void;
  /** Deletes the anchors that the device keeps after sessions, as when the visitor clears the device's data. */
  forgetPersistentAnchors(): void;
  setVisibility(state: 'visible' | 'visible-blurred' | 'hidden'): void;
  /** Re-centers: `local` and `local-floor` spaces move to the viewer and dispatch `reset`. */
  recenter(): void;
  /** Ends the session as the system does, such as by a home button. */
  endSession(): Promise<void>;

  /**
   * Touches the screen of a handheld device. Coordinates are normalized, with the origin at the top left.
   *
   * @param finger 0 or 1. Default: 0.
   * @throws Error if this finger touches the screen already.
   */
  press(x: number, y: number, finger?: number): void;
  /** Moves the touch; same coordinates as `press`. */
  move(x: number, y: number, finger?: number): void;
  release(finger?: number): void;

  /** Sets what the visitor uses from the next frame on: controllers or bare hands. */
  setInput(mode: 'controllers' | 'hands'): void;
  /**
   * Shapes a bare hand from the next frame on. A pinch selects, as on a device.
   *
   * @param gesture A gesture of `HandGesture`, or the name of a capture.
   * @throws Error if there is no such gesture.
   */
  setGesture(side: 'left' | 'right', gesture: string): void;
  /**
   * Adds a gesture from a captured left hand; the right one is its mirror image.
   *
   * @param capture In iwer's public form (`hand-capture.ts`).
   * @throws Error that names what is wrong in the capture.
   */
  addGesture(name: string, capture: unknown): void;
  /** Sets whether the device sees a bare hand. */
  setHandTracked(side: 'left' | 'right', tracked: boolean): void;
  /** The last haptic pulse that the page sent to a controller; null for none. */
  lastPulse(side: 'left' | 'right'): { readonly strength: number; readonly durationS: number } | null;

  /** Resolves once the page has an immersive session with a layer and has requested a frame. */
  frameRequested(): Promise<void>;
  /**
   * Runs `count` frames of a device with a manual clock. The event loop runs after each. Without an immersive session, inline sessions get
   * the frames.
   *
   * @throws Error if there is no session, if the page has requested no frame, or if the clock is not manual.
   */
  stepFrame(count?: number): Promise<void>;

  /**
   * What the page drew in the last frame, premultiplied.
   *
   * @throws Error if there is no session with a layer.
   */
  readLayer(): Pixels;
  /**
   * What the device's cameras saw in the last frame.
   *
   * @throws Error if there is no session with a layer.
   */
  readRoom(): Pixels;
  /**
   * What the user saw in the last frame.
   *
   * @throws Error if there is no session with a layer.
   */
  readComposite(): Pixels;
  /**
   * Casts a ray into the room.
   *
   * @param originWorld Meters.
   * @param directionWorld Any length except 0.
   * @returns Meters to the first surface, or null if the ray hits nothing.
   */
  measure(originWorld: readonly number[], directionWorld: readonly number[]): number | null;
  /** Numbers of GPU objects in the device's own context, for leak tests. */
  counts(): { readonly geometries: number; readonly textures: number; readonly programs: number };
  /** Ends all sessions, removes the device from the page and disposes everything. */
  uninstall(): Promise<void>;
}

/** Pose of the head in world space: a column-major 4×4 matrix without scale, or position in meters and quaternion as x, y, z, w. */
export type HeadPose =
  | { readonly matrix: ArrayLike<number> }
  | { readonly position: readonly [number, number, number]; readonly quaternion?: readonly [number, number, number, number] };
