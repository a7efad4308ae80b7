import { createStore, type StoreApi } from 'zustand/vanilla';
import type { SessionSource } from '../../../app/contract/contract.ts';
import type { DeviceKind } from '../../../export/program/devices/device-facts.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { type FrameTimes, timeOfFrame } from '../../../nodes/kit/frame-times.ts';
import type { PreviewStatus, PreviewTier } from '../../preview-protocol.ts';

/**
 * Why the preview of a project does not start: the graphics device was lost, Scrim ended during playback, or the user held Shift
 * while opening.
 */
export type StopReason = 'lost' | 'broken-off' | 'asked';

/** State of the preview. */
export interface PreviewState {
  /** Why the preview waits for the user; null if it runs. */
  readonly stopped: StopReason | null;
  readonly ready: boolean;
  readonly status: PreviewStatus | null;
  /** Counter of the newest `session` message. */
  readonly request: number;
  /** Document revision of the program on screen; null before the first. */
  readonly playing: number | null;
  /** Whether the picture on screen is still that of another project. */
  readonly foreign: boolean;
  /** Document revision of the newest program that the driver rejected; null before the first. */
  readonly refused: number | null;
  /** Diagnostics of the session and of the running program. */
  readonly diagnostics: readonly Diagnostic[];
  /** Errors of the graphics driver in the newest program, mapped to source lines. */
  readonly shaderDiagnostics: readonly Diagnostic[];
  readonly sources: readonly SessionSource[];
  readonly sourceId: string | null;
  /** Number of views of an emulated headset. */
  readonly views: 1 | 2;
  /** `auto`: a phone in emulated rooms, which would otherwise have the shape of the panel, and that of the panel for other sources. */
  readonly frame: DeviceFrame | 'auto';
  /** Whether the preview has a window of its own. */
  readonly poppedOut: boolean;
  /** Whether the safe areas of phones are drawn. */
  readonly safeAreas: boolean;
  /** Tier of an emulated device. */
  readonly tier: PreviewTier;
  /** The kind of device whose features an emulated device has; null for all features. */
  readonly deviceKind: DeviceKind | null;
  /** Direction of the main light of emulated rooms; null for that of the room. */
  readonly roomLight: LightPlace | null;
  /** The image that replaces the camera. */
  readonly still: File | null;
  readonly recording: boolean;
  /** The recording of a session: none, in progress, or its images are being made. */
  readonly sessionRecording: 'no' | 'recording' | 'filming';
  readonly physics: PhysicsChoice;
  /** Frame times of the recording; null if the source is not a recording. */
  readonly frames: FrameTimes | null;
  /** Width of the images of the recording or camera divided by their height; null if the source has no shape of its own. */
  readonly shape: number | null;
  /** The play range; null for the whole recording. */
  readonly range: FrameRange | null;
  /** Whether the play range repeats. */
  readonly loop: boolean;
  /** While paused: the frame that was requested last and may not be shown yet. */
  readonly asked: number | null;
}

/** Physics in the preview, apart from the source. */
export interface PhysicsChoice {
  readonly paused: boolean;
  readonly showsBodies: boolean;
  readonly showsVoxels: boolean;
}

/** A range of frames of a recording, both included. Frame numbers continue to count when the recording loops. */
export interface FrameRange {
  readonly from: number;
  readonly to: number;
}

/** Shape of the preview: that of the panel, or of a device. */
export const DEVICE_FRAMES = ['fill', 'phone', 'phone-wide', 'headset', 'glasses'] as const;
export type DeviceFrame = (typeof DEVICE_FRAMES)[number];

/** Width ÷ height of an upright phone. */
export const PHONE_SHAPE = 9 / 19.5;

/** Width ÷ height of the screens of devices. A headset has two views of 1680 × 1760. */
const FRAME_SHAPES: Readonly<Record<Exclude<DeviceFrame, 'fill'>, number>> = {
  phone: PHONE_SHAPE,
  'phone-wide': 1 / PHONE_SHAPE,
  headset: 3360 / 1760,
  glasses: 3 / 2,
};

/**
 * Direction of a light as in `light/directional`. Azimuth 0 is the front (+z), π/2 the right (+x); elevation is the angle above the
 * horizon.
 */
export interface LightPlace {
  readonly azimuthRad: number;
  readonly elevationRad: number;
}

/** Unit vector toward the light. */
export function towardsLight({ azimuthRad, elevationRad }: LightPlace): [number, number, number] {
  const horizontal = Math.cos(elevationRad);
  return [horizontal * Math.sin(azimuthRad), Math.sin(elevationRad), horizontal * Math.cos(azimuthRad)];
}

/** A preview source: one that the host lists, or one of this computer. */
export type ChosenSource = SessionSource | { readonly id: LocalSource; readonly title: string; readonly kind: LocalSource };

export type LocalSource = 'camera' | 'still' | 'orbit';

export const LOCAL_SOURCES: readonly { readonly id: LocalSource; readonly title: string; readonly kind: LocalSource }[] = [
  { id: 'camera', title: 'Webcam', kind: 'camera' },
  { id: 'still', title: 'Image…', kind: 'still' },
  { id: 'orbit', title: 'No background (orbit)', kind: 'orbit' },
];

export type PreviewStore = StoreApi<PreviewState>;

export function createPreviewState(frame: PreviewState['frame'] = 'auto'): PreviewStore {
  return createStore<PreviewState>(() => ({
    stopped: null,
    ready: false,
    status: null,
    request: 0,
    playing: null,
    foreign: false,
    refused: null,
    diagnostics: [],
    shaderDiagnostics: [],
    sources: [],
    sourceId: null,
    views: frame === 'headset' ? 2 : 1,
    frame,
    poppedOut: false,
    safeAreas: true,
    tier: 'ar-camera',
    deviceKind: null,
    roomLight: null,
    still: null,
    recording: false,
    sessionRecording: 'no',
    physics: { paused: false, showsBodies: false, showsVoxels: false },
    frames: null,
    shape: null,
    range: null,
    loop: false,
    asked: null,
  }));
}

/** Time of the preview in seconds since the session began; 0 before it plays. */
export function timeOf({ status, frames, asked }: Pick<PreviewState, 'status' | 'frames' | 'asked'>): number {
  return frames !== null && asked !== null ? timeOfFrame(frames, asked) : (status?.timeS ?? 0);
}

/** The frame that is shown or requested. */
export function frameOf({ status, asked }: Pick<PreviewState, 'status' | 'asked'>): number {
  return asked ?? status?.frame ?? 0;
}

/** Whether the chosen source or program is not on screen yet. */
export function isLoading({ status, request, playing }: PreviewState): boolean {
  return playing === null || status === null || status.state === 'loading' || status.request !== request;
}

/** The frame around the preview. */
export function shownFrame(state: PreviewState): DeviceFrame {
  const { frame, views } = state;
  if (frame !== 'auto') return frame;
  return chosenSource(state)?.kind === 'room' && views === 1 ? 'phone' : 'fill';
}

/** Width of the picture divided by its height; null if it has the shape of the panel. */
export function shownShape(state: PreviewState): number | null {
  const frame = shownFrame(state);
  return frame === 'fill' ? state.shape : FRAME_SHAPES[frame];
}

/** Puts the preview into a frame, with the views of that device and all its features. */
export function chooseFrame(preview: PreviewStore, frame: DeviceFrame): void {
  preview.setState({ frame, views: frame === 'headset' ? 2 : 1, deviceKind: null });
}

export function chosenSource({ sources, sourceId }: PreviewState): ChosenSource | null {
  return sources.find((source) => source.id === sourceId) ?? LOCAL_SOURCES.find(({ id }) => id === sourceId) ?? sources[0] ?? null;
}
