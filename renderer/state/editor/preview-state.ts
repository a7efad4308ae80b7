import { createStore, type StoreApi } from 'zustand/vanilla';
import type { SessionSource } from '../../../app/contract/contract.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { type FrameTimes, timeOfFrame } from '../../../nodes/kit/frame-times.ts';
import type { PreviewStatus, PreviewTier } from '../../preview-protocol.ts';

/** Why a project's preview does not start by itself: it lost the GPU, its window ended abruptly, or the person asked for it. */
export type StopReason = 'lost' | 'broken-off' | 'asked';

/** What is known of the preview page. */
export interface PreviewState {
  /** Why there is no preview until the person starts it; null where there is one. */
  readonly stopped: StopReason | null;
  readonly ready: boolean;
  readonly status: PreviewStatus | null;
  /** Of the newest `session` message that was sent. */
  readonly request: number;
  /** Document revision of the program on screen; null before the first. */
  readonly playing: number | null;
  /** Document revision of the newest program that the driver refused; null before the first. */
  readonly refused: number | null;
  /** Of the session and of what plays. */
  readonly diagnostics: readonly Diagnostic[];
  /** What the graphics driver said of the newest program's shaders, on their authors' lines. */
  readonly shaderDiagnostics: readonly Diagnostic[];
  readonly sources: readonly SessionSource[];
  readonly sourceId: string | null;
  /** Of an emulated headset. */
  readonly views: 1 | 2;
  readonly frame: DeviceFrame;
  /** What an emulated device gives. */
  readonly tier: PreviewTier;
  /** Where the strongest light of emulated rooms is moved to; null: where the room has it. */
  readonly roomLight: LightPlace | null;
  /** The picture that stands in for a camera. */
  readonly still: File | null;
  readonly recording: boolean;
  /** Of the recording that plays; null where no moment can be gone to. */
  readonly frames: FrameTimes | null;
  /** What is played of it; null: all. */
  readonly range: FrameRange | null;
  /** From the end of what is played back to its beginning. */
  readonly loop: boolean;
  /** While held: the frame that was asked for last, which the preview may not have shown yet. */
  readonly asked: number | null;
}

/** Frames of a recording, both included; those of later rounds are counted on. */
export interface FrameRange {
  readonly from: number;
  readonly to: number;
}

/** The shape of the preview: as large as there is room, or as a device has it. */
export type DeviceFrame = 'fill' | 'phone' | 'phone-wide' | 'headset' | 'glasses';

/** As of `light/directional`: azimuth 0 from the front (+z), a quarter turn from the right (+x); elevation above the horizon. */
export interface LightPlace {
  readonly azimuthRad: number;
  readonly elevationRad: number;
}

/** A unit vector towards a light. */
export function towardsLight({ azimuthRad, elevationRad }: LightPlace): [number, number, number] {
  const horizontal = Math.cos(elevationRad);
  return [horizontal * Math.sin(azimuthRad), Math.sin(elevationRad), horizontal * Math.cos(azimuthRad)];
}

/** Where a picture may come from: what the host lists, and what this computer has itself. */
export type ChosenSource = SessionSource | { readonly id: LocalSource; readonly title: string; readonly kind: LocalSource };

export type LocalSource = 'camera' | 'still' | 'orbit';

export const LOCAL_SOURCES: readonly { readonly id: LocalSource; readonly title: string; readonly kind: LocalSource }[] = [
  { id: 'camera', title: 'Webcam', kind: 'camera' },
  { id: 'still', title: 'Image…', kind: 'still' },
  { id: 'orbit', title: 'No background (orbit)', kind: 'orbit' },
];

export type PreviewStore = StoreApi<PreviewState>;

export function createPreviewState(): PreviewStore {
  return createStore<PreviewState>(() => ({
    stopped: null,
    ready: false,
    status: null,
    request: 0,
    playing: null,
    refused: null,
    diagnostics: [],
    shaderDiagnostics: [],
    sources: [],
    sourceId: null,
    views: 1,
    frame: 'fill',
    tier: 'ar-camera',
    roomLight: null,
    still: null,
    recording: false,
    frames: null,
    range: null,
    loop: false,
    asked: null,
  }));
}

/** Of the session, seconds; 0 before it plays. */
export function timeOf({ status, frames, asked }: Pick<PreviewState, 'status' | 'frames' | 'asked'>): number {
  return frames !== null && asked !== null ? timeOfFrame(frames, asked) : (status?.timeS ?? 0);
}

/** The frame that is shown, or about to be. */
export function frameOf({ status, asked }: Pick<PreviewState, 'status' | 'asked'>): number {
  return asked ?? status?.frame ?? 0;
}

/** What was chosen last is still on its way: the picture is another's, or nobody's. */
export function isLoading({ status, request, playing }: PreviewState): boolean {
  return playing === null || status === null || status.state === 'loading' || status.request !== request;
}

export function chosenSource({ sources, sourceId }: PreviewState): ChosenSource | null {
  return sources.find((source) => source.id === sourceId) ?? LOCAL_SOURCES.find(({ id }) => id === sourceId) ?? sources[0] ?? null;
}
