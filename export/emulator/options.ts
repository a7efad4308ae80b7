import type { FrameClock } from '../runtime/clock.ts';
import type { DepthNoise } from './depth/depth-noise.ts';
import type { DepthSensor } from './depth/depth-sensor.ts';
import type { DepthTransform } from './depth/depth-transform.ts';
import type { LightOptions } from './light/session-light.ts';
import type { DepthFormat, DepthUsage, DeviceName } from './profiles.ts';
import type { RoomSource } from './rooms/room-source.ts';

/** What `installEmulator` takes. Plain data but for `container` and `frameClock`, so that a test can send it into a page. */
export interface EmulatorOptions {
  readonly device?: DeviceName;
  /** One view covers the framebuffer; two stand side by side. Default: what the device has. */
  readonly views?: 1 | 2;
  /** What kinds of session it has: AR and VR unless given. */
  readonly modes?: readonly ('immersive-ar' | 'immersive-vr')[];
  /** What the device sees; null is an endless void without depth or surfaces. */
  readonly room?: RoomSource | null;
  /** `manual`: frames come from `stepFrame` alone, frame N at N/`framesPerSecond`. `free`: with the display. */
  readonly clock?: 'free' | 'manual';
  /** Of a manual clock: few make long waits short. Default: 60. */
  readonly framesPerSecond?: number;
  /** Framebuffer, both views together; default: that of the container or window when the layer is made. */
  readonly sizePx?: readonly [width: number, height: number] | null;
  /** Vertical field of view. Default: the device's. */
  readonly fovYRad?: number;
  readonly ipdM?: number;
  /** Feature descriptors that this device does not grant, as if the user or the hardware had refused. */
  readonly refuse?: readonly string[];
  /** Feature descriptors granted beyond what the device's profile has: camera access on a headset, say. */
  readonly extra?: readonly string[];
  readonly depth?: DepthOptions;
  readonly light?: LightOptions;
  /** `requestSession` needs a user gesture, as in browsers. */
  readonly requireGesture?: boolean;
  /** Copy the picture to the screen; off, frames are drawn for reading back alone. */
  readonly display?: boolean;
  /** Smooth edges of the room. Default: with a free clock alone, where people look; on the CPU it doubles a frame's time. */
  readonly antialias?: boolean;
  /** Where the picture is shown; default: over the whole window while a session runs. */
  readonly container?: HTMLElement | null;
  /** Default: the browser's. */
  readonly frameClock?: FrameClock | null;
}

/** What is left out is as the device's profile has it. */
export interface DepthOptions {
  readonly usages?: readonly DepthUsage[];
  readonly formats?: readonly DepthFormat[];
  /** Columns and rows of the depth buffer, which is that of the turned sensor: see `transform`. */
  readonly sizePx?: readonly [width: number, height: number];
  /** How the depth buffer lies against the view; default: upright, covering it exactly. */
  readonly transform?: DepthTransform;
  /**
   * What depth textures hold. `meters`: as the specification says. `window`: as Quest Browser does, values of a depth buffer with
   * an endless far plane, its first row at the bottom, and the attributes `depthNear`, `depthFar` and `isValid` that no specification has.
   */
  readonly gpuValues?: 'meters' | 'window';
  /** The camera that measures, for pages that ask for `matchDepthView: false`; null: it stands where the view is, and sees as the view does. */
  readonly sensor?: DepthSensor | null;
  /** Frames by which depth comes late. Pages that ask for depth of the view get the late picture as if it were of now; others are told where it was taken. */
  readonly lagFrames?: number;
  /** Default: none, depth is exact. */
  readonly noise?: DepthNoise | null;
  /** Nothing is known of what is farther; null: no limit but the format's. */
  readonly maxM?: number | null;
}

export const DEPTH_DEFAULTS = { transform: {}, gpuValues: 'meters', sensor: null, lagFrames: 0, noise: null, maxM: null } as const;

export type SettledDefaults = Required<Omit<EmulatorOptions, 'views' | 'fovYRad' | 'depth' | 'light' | 'antialias'>>;

export const EMULATOR_DEFAULTS: SettledDefaults = {
  device: 'phone',
  modes: ['immersive-ar', 'immersive-vr'],
  room: null,
  clock: 'free',
  framesPerSecond: 60,
  sizePx: null,
  ipdM: 0.063,
  refuse: [],
  extra: [],
  requireGesture: false,
  display: true,
  container: null,
  frameClock: null,
};

/** `defaults` overlaid with what `options` really says: `undefined` says nothing. */
export function withDefaults<O extends object, K extends keyof O>(defaults: Required<Pick<O, K>>, options: O): O & Required<Pick<O, K>> {
  const said = Object.entries(options).filter(([, value]) => value !== undefined);
  return { ...defaults, ...Object.fromEntries(said) } as O & Required<Pick<O, K>>;
}
