import type { FrameClock } from '../runtime/clock.ts';
import type { DepthNoise } from './depth/depth-noise.ts';
import type { DepthSensor } from './depth/depth-sensor.ts';
import type { DepthTransform } from './depth/depth-transform.ts';
import { DISPLAY_GAIN } from './display/composite.ts';
import type { LightOptions } from './light/session-light.ts';
import type { DepthFormat, DepthUsage, DeviceName } from './profiles.ts';
import type { RoomSource } from './rooms/room-source.ts';

/** Options of `installEmulator`. All but `container` and `frameClock` are plain data, so a test can send them to a page. */
export interface EmulatorOptions {
  readonly device?: DeviceName;
  /** One view covers the framebuffer, two are side by side. Default: the device's. */
  readonly views?: 1 | 2;
  /** Session modes that the device supports. Default: AR and VR. */
  readonly modes?: readonly ('immersive-ar' | 'immersive-vr')[];
  /** What the device sees. Null is empty space without depth or surfaces. */
  readonly room?: RoomSource | null;
  /** Whether the device knows the room. If not, it detects no planes and meshes before the page calls `initiateRoomCapture`. Default: true. */
  readonly roomScanned?: boolean;
  /** `manual`: only `stepFrame` runs frames, frame N at N/`framesPerSecond` seconds. `free`: frames follow the display. */
  readonly clock?: 'free' | 'manual';
  /** Frame rate of a manual clock; a low rate makes long waits short. Default: 60. */
  readonly framesPerSecond?: number;
  /** Size of the framebuffer with all views. Default: size of the container or window when the layer is created. */
  readonly sizePx?: readonly [width: number, height: number] | null;
  /** Vertical field of view. Default: the device's. */
  readonly fovYRad?: number;
  readonly ipdM?: number;
  /** Features that this device denies, as if the user or the hardware refused. */
  readonly refuse?: readonly string[];
  /** Features beyond the device's profile, such as `camera-access` on a headset. */
  readonly extra?: readonly string[];
  readonly depth?: DepthOptions;
  readonly light?: LightOptions;
  /** Whether `requestSession` needs a user gesture, as in browsers. */
  readonly requireGesture?: boolean;
  /** Whether to show the image on the page. If false, frames are drawn for readback only. */
  readonly display?: boolean;
  /**
   * Brightness of an additive display: luminance of its white divided by that of the room's white. Where the room is bright, differences of
   * the display's light, such as negative shadows, are lost. Default: 2.
   */
  readonly displayGain?: number;
  /**
   * Whether edges of the room are antialiased. Default: only with a free clock, because it doubles the frame time on a software renderer.
   */
  readonly antialias?: boolean;
  /** Element that shows the image. Default: the whole window while a session runs. */
  readonly container?: HTMLElement | null;
  /** Default: the browser's. */
  readonly frameClock?: FrameClock | null;
}

/** Options of depth sensing. Missing values are those of the device's profile. */
export interface DepthOptions {
  readonly usages?: readonly DepthUsage[];
  readonly formats?: readonly DepthFormat[];
  /** Columns and rows of the depth buffer, in the orientation of the sensor: see `transform`. */
  readonly sizePx?: readonly [width: number, height: number];
  /** Orientation of the depth buffer relative to the view. Default: upright, covering it exactly. */
  readonly transform?: DepthTransform;
  /**
   * Content of depth textures. `meters` follows the specification. `window` follows Quest Browser: window-space depth with an infinite far
   * plane, first row at the bottom, and the non-standard attributes `depthNear`, `depthFar` and `isValid`.
   */
  readonly gpuValues?: 'meters' | 'window';
  /** The depth camera for pages that request `matchDepthView: false`. Null uses the pose and lens of the view. */
  readonly sensor?: DepthSensor | null;
  /** Delay of depth, in frames. With `matchDepthView: false` the page gets the old pose with it; else the depth is not reprojected. */
  readonly lagFrames?: number;
  /** Default: null, exact depth. */
  readonly noise?: DepthNoise | null;
  /** Depth beyond this distance is unknown, in meters. Null: only the format limits it. */
  readonly maxM?: number | null;
}

export const DEPTH_DEFAULTS = { transform: {}, gpuValues: 'meters', sensor: null, lagFrames: 0, noise: null, maxM: null } as const;

export type SettledDefaults = Required<Omit<EmulatorOptions, 'views' | 'fovYRad' | 'depth' | 'light' | 'antialias'>>;

export const EMULATOR_DEFAULTS: SettledDefaults = {
  device: 'phone',
  modes: ['immersive-ar', 'immersive-vr'],
  room: null,
  roomScanned: true,
  clock: 'free',
  framesPerSecond: 60,
  sizePx: null,
  ipdM: 0.063,
  refuse: [],
  extra: [],
  requireGesture: false,
  display: true,
  displayGain: DISPLAY_GAIN,
  container: null,
  frameClock: null,
};

/** Merges `options` over `defaults`; an `undefined` option has its default. */
export function withDefaults<O extends object, K extends keyof O>(defaults: Required<Pick<O, K>>, options: O): O & Required<Pick<O, K>> {
  const said = Object.entries(options).filter(([, value]) => value !== undefined);
  return { ...defaults, ...Object.fromEntries(said) } as O & Required<Pick<O, K>>;
}
