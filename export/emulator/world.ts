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

/** The emulated device and what is around it; sessions come and go in it. */
export interface World {
  readonly device: XRDevice;
  readonly profile: DeviceProfile;
  readonly settings: WorldSettings;
  readonly frames: FrameSource;
  readonly screen: Screen;
  readonly screenInput: ScreenInput;
  /** The room, its picture and its light; made when first needed. */
  readonly roomServices: () => RoomServices;
  /** Whether the device knows where it is. */
  tracked: boolean;
  depthState: DepthState;
  lightState: LightState;
}

export interface WorldSettings {
  readonly views: 1 | 2;
  readonly features: ReadonlySet<string>;
  /** Of the screen, while that may change; null: the window's when a layer is made. */
  sizePx: readonly [width: number, height: number] | null;
  readonly depth: Required<DepthOptions>;
  readonly light: Required<LightOptions>;
  readonly display: boolean;
  readonly requireGesture: boolean;
}

export interface RoomServices {
  readonly room: Room | null;
  readonly view: RoomView;
  readonly light: () => RoomLight | null;
  /** Made when first needed. */
  readonly compositor: () => LayerCompositor;
  /** How often its light was moved. */
  readonly lightMoves: number;
  moveLight(directionWorld: PrimaryLight['directionWorld'] | null): void;
}
