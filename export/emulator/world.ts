import type { XRDevice } from 'iwer';
import type { DepthState } from './depth/session-depth.ts';
import type { RoomView } from './display/room-view.ts';
import type { Screen } from './display/screen.ts';
import type { FrameSource } from './frame-source.ts';
import type { ScreenInput } from './input/screen-input.ts';
import type { LayerCompositor } from './layers/layer-compositor.ts';
import type { RoomLight } from './light/room-light.ts';
import type { LightOptions, LightState } from './light/session-light.ts';
import type { DepthOptions } from './options.ts';
import type { DeviceProfile } from './profiles.ts';
import type { PrimaryLight, Room } from './rooms/room.ts';
import type { PersistentAnchors } from './session/persistent-anchors.ts';

/** The emulated device and its surroundings; they outlive sessions. */
export interface World {
  readonly device: XRDevice;
  readonly profile: DeviceProfile;
  readonly settings: WorldSettings;
  readonly frames: FrameSource;
  readonly screen: Screen;
  readonly screenInput: ScreenInput;
  /** The room, its view and its light estimate; created on first use. */
  readonly roomServices: () => RoomServices;
  /** Whether the device has tracking. */
  tracked: boolean;
  depthState: DepthState;
  lightState: LightState;
  /** Whether the device sees its anchors. */
  anchorState: 'tracked' | 'lost';
  readonly persistentAnchors: PersistentAnchors;
  /** How reference spaces move against the room while a session runs. */
  drift: Drift;
}

/** Per minute of the session's time. */
export interface Drift {
  /** In the room's axes, meters. */
  readonly offsetM: readonly [number, number, number];
  /** About the vertical through the room's origin. */
  readonly yawRad: number;
}

export interface WorldSettings {
  readonly views: 1 | 2;
  readonly features: ReadonlySet<string>;
  /** Whether the device knows the room without a capture. */
  readonly roomScanned: boolean;
  /** Size of the screen; null for the window's size when a layer is created. */
  sizePx: readonly [width: number, height: number] | null;
  readonly depth: Required<DepthOptions>;
  readonly light: Required<LightOptions>;
  readonly display: boolean;
  /** Brightness of an additive display: luminance of its white divided by that of the room's white. */
  readonly displayGain: number;
  readonly requireGesture: boolean;
}

export interface RoomServices {
  readonly room: Room | null;
  readonly view: RoomView;
  readonly light: () => RoomLight | null;
  /** The compositor of the device, created on first use. */
  readonly compositor: () => LayerCompositor;
  /** How often `moveLight` was called. */
  readonly lightMoves: number;
  moveLight(directionWorld: PrimaryLight['directionWorld'] | null): void;
}

/** Current size of the framebuffer with all views. The width is even, so that two views have equal sizes. */
export function framebufferSizePx({ settings, screen }: World, scale: number): [widthPx: number, heightPx: number] {
  const [widthPx, heightPx] = settings.sizePx ?? screen.sizePx();
  return [Math.max(2, Math.round((widthPx * scale) / 2) * 2), Math.max(1, Math.round(heightPx * scale))];
}
