import type { Capability } from '../../../../nodes/kit/definition.ts';
import type { Result } from '../../../../nodes/kit/diagnostics.ts';
import { type FrameTimes, frameAtTime, timeOfFrame } from '../../../../nodes/kit/frame-times.ts';
import type { Session, SessionEvent, SessionFrame } from '../../../../nodes/kit/session.ts';
import type { AssetSource } from '../../assets/asset-source.ts';
import type { FrameClock } from '../../clock.ts';
import type { PageInput } from '../input/page-input.ts';
import type { SessionInputs } from '../input/session-inputs.ts';
import { createSessionFrame } from '../session-frame.ts';
import { createFrameCache, type DecodedFrame, type FrameCache } from './frame-cache.ts';
import { createFrameTextures, type FrameTextures } from './frame-textures.ts';
import { brokenSession } from './read-session-file.ts';
import { createRecordedView, type RecordedView } from './recorded-view.ts';
import { openRecording, type Recording } from './recording.ts';
import { createInputReplay, type InputReplay } from './replay-input.ts';
import { createPlayback, type PlayRange } from './session-playback.ts';

export interface RecordedSessionOptions {
  readonly gl: WebGL2RenderingContext;
  /** The session folder. */
  readonly files: AssetSource;
  /** `clock` plays in real time and repeats. `manual` draws a frame for each `step`. */
  readonly mode: { readonly kind: 'clock'; readonly clock: FrameClock } | { readonly kind: 'manual' };
  /** Memory for decoded frames; 60 frames of 640 × 480 with depth take 147 MB. */
  readonly budgetBytes?: number;
  /** `clock` only: called at the end of a range that does not loop. The last frame stays visible. */
  readonly onEnd?: () => void;
  /** `clock` only: called when a frame that was late is decoded. */
  readonly onArrival?: () => void;
  /** Functions that read input; absent or null: frames have no input. */
  readonly inputs?: SessionInputs | null;
}

export interface RecordingInfo {
  readonly title: string;
  readonly frames: FrameTimes;
  /** Width of its images divided by their height. */
  readonly shape: number;
}

/**
 * Plays a recorded session folder on the whole canvas, cropping images to the canvas's aspect ratio. Times are seconds since the first
 * frame and continue over repeats.
 */
export interface RecordedSession extends Session {
  /**
   * Resolves when the folder is read and the first frame is decoded; `capabilities` are complete then. Never rejects: an invalid folder
   * gives SCR054 and no output.
   */
  readonly ready: Promise<Result<RecordingInfo>>;
  /**
   * `manual` only, after `ready` and `start`: draws frame `index`. Resolves to false if its image is invalid, which a `problem` event
   * reports.
   *
   * @throws RangeError if there is no such frame, Error if the session is not manual, ready and started.
   */
  step(index: number): Promise<boolean>;
  /** Draws the frame at a time, as `step` does for an index. */
  stepTo(timeS: number): Promise<boolean>;
  /** `clock` only: time of the current frame, or of the next after a seek. */
  readonly playheadS: number;
  /** `clock` only: whether an earlier frame is shown because the current one is not decoded yet. */
  readonly isLate: boolean;
  /** Continues at frame `index` and dispatches `reset`. */
  seek(index: number): void;
  /** Continues at a time and dispatches `reset`. */
  seekTime(timeS: number): void;
  /** Advances to the next frame as if the time until then had passed. */
  nextFrame(): void;
  setRange(range: PlayRange | null): void;
  /** Continues at the start of the range and dispatches `reset` if the playhead is outside the range. */
  enterRange(): void;
  /** Decodes as many frames as the budget holds. */
  preload(): Promise<void>;
}

const DEFAULT_BUDGET_BYTES = 512 * 1024 * 1024;

/** Frames decoded ahead of the current one. */
const LOOK_AHEAD = 4;

/** An open recording with its GPU resources. */
interface OpenRecording extends Recording {
  readonly cache: FrameCache;
  /** Replays recorded input; null if the recording has none. */
  readonly replay: InputReplay | null;
  textures: FrameTextures;
  view: RecordedView;
}

export function createRecordedSession(options: RecordedSessionOptions): RecordedSession {
  const { gl, files, mode } = options;
  const capabilities = new Set<Capability>();
  const frame = createSessionFrame();
  let opened: OpenRecording | null = null;
  let onFrame: ((frame: SessionFrame) => void) | null = null;
  let onEvent: ((event: SessionEvent) => void) | null = null;
  let ended = false;
  /** The frame that the textures contain. */
  let shown: DecodedFrame | null = null;
  let isLate = false;
  /** Time of the frame delivered last; null after a seek, so that the time step is 0. */
  let deliveredS: number | null = null;
  const problems: string[] = [];
  let input: PageInput | null = null;

  const reportProblem = (message: string): void => {
    if (onEvent) onEvent({ kind: 'problem', message });
    else problems.push(message);
  };
  const deliver = (current: OpenRecording, decoded: DecodedFrame, index: number, timeS: number): boolean => {
    if (gl.drawingBufferWidth === 0 || gl.drawingBufferHeight === 0) return false;
    if (decoded !== shown) {
      current.textures.upload(decoded);
      frame.version = (frame.version ?? -1) + 1;
    }
    shown = decoded;
    frame.index = index;
    frame.timeS = timeS;
    frame.deltaS = deliveredS === null ? 0 : Math.max(0, timeS - deliveredS);
    frame.light = current.lights[decoded.index] ?? null;
    frame.surfaces = current.surfaces;
    frame.roomFile = current.room;
    deliveredS = timeS;
    current.view.fill(frame, decoded);
    if (input) input.fill(frame);
    else frame.input.pointerCount = 0;
    current.replay?.fill(frame.input, index);
    onFrame?.(frame);
    return true;
  };
  const show = (playheadS: number): boolean => {
    if (!opened) return false;
    const { file, cache, frames } = opened;
    const number = frameAtTime(frames, playheadS);
    const index = number % file.frames.length;
    for (let ahead = 0; ahead <= LOOK_AHEAD; ahead++) cache.prefetch((index + ahead) % file.frames.length);
    // Playback does not wait for decoding: the previous frame stays visible.
    const current = cache.get(index);
    if (!current && options.onArrival) void cache.request(index).then((arrived) => arrived && options.onArrival?.());
    isLate = cache.isPending(index);
    const decoded = current ?? shown ?? cache.get(0);
    return decoded !== null && deliver(opened, decoded, number, playheadS);
  };
  const resetTime = (): void => {
    deliveredS = null;
    opened?.replay?.reset();
    frame.jumps++;
    onEvent?.({ kind: 'reset', cause: 'restart' });
  };
  const playback =
    mode.kind === 'clock'
      ? createPlayback(mode.clock, {
          durationS: () => opened?.frames.durationS ?? null,
          show,
          onRepeat: () => {
            frame.jumps++;
            onEvent?.({ kind: 'reset', cause: 'repeat' });
          },
          onLoop: resetTime,
          onEnd: () => options.onEnd?.(),
        })
      : null;
  const open = async (): Promise<Result<RecordingInfo>> => {
    const { output: recording, diagnostics } = await openRecording(files);
    if (!recording) return { output: null, diagnostics };
    const { file } = recording;
    const cache = createFrameCache(files, file, options.budgetBytes ?? DEFAULT_BUDGET_BYTES, reportProblem);
    const first = await cache.request(0);
    if (!first || ended) {
      cache.dispose();
      return { output: null, diagnostics: [...diagnostics, brokenSession(problems[0] ?? 'The session ended before it was read.')] };
    }
    const textures = createFrameTextures(gl, file);
    opened = { ...recording, cache, replay: createInputReplay(file), textures, view: createRecordedView(gl, file, textures) };
    capabilities.add('camera-image');
    if (file.depth) capabilities.add('depth');
    if (recording.lights.some((light) => light !== null)) capabilities.add('light-estimation');
    if (recording.surfaces) capabilities.add('planes');
    if (file.frames.some((each) => each.input?.leftHand || each.input?.rightHand)) capabilities.add('hands');
    if (onFrame) playback?.start();
    const shape = file.color.widthPx / file.color.heightPx;
    return { output: { title: file.title, frames: recording.frames, shape }, diagnostics };
  };
  /** Recreates the textures after the WebGL context was restored. */
  const restore = (): void => {
    if (!opened) return;
    opened.textures = createFrameTextures(gl, opened.file);
    opened.view = createRecordedView(gl, opened.file, opened.textures);
    shown = null;
  };
  const seekTime = (timeS: number): void => {
    playback?.seek(Math.max(0, timeS));
    resetTime();
  };
  const stepTo = async (timeS: number): Promise<boolean> => {
    const current = opened;
    if (mode.kind !== 'manual' || !current || !onFrame) throw new Error('Only a manual session that is ready and started can be stepped.');
    const number = frameAtTime(current.frames, timeS);
    const decoded = await current.cache.request(number % current.file.frames.length);
    return decoded !== null && !ended && deliver(current, decoded, number, timeS);
  };
  gl.canvas.addEventListener('webglcontextrestored', restore);
  return {
    kind: 'recorded',
    capabilities,
    world: 'image',
    blend: 'opaque',
    ready: open(),
    start: (frameHandler, eventHandler) => {
      onFrame = frameHandler;
      onEvent = eventHandler;
      // A canvas outside a page, as for renders, receives no taps.
      if (mode.kind === 'clock' && 'ownerDocument' in gl.canvas) input ??= options.inputs?.page(gl.canvas) ?? null;
      for (const message of problems.splice(0)) reportProblem(message);
      if (opened) playback?.start();
    },
    step: async (index) => {
      if (opened && !opened.file.frames[index]) throw new RangeError(`The session has no frame ${index}.`);
      return stepTo(opened ? timeOfFrame(opened.frames, index) : 0);
    },
    stepTo,
    get playheadS() {
      return playback?.playheadS ?? 0;
    },
    get isLate() {
      return isLate;
    },
    seek: (index) => {
      if (opened) seekTime(timeOfFrame(opened.frames, index));
    },
    seekTime,
    nextFrame: () => {
      if (opened && playback) playback.advanceTo(timeOfFrame(opened.frames, frameAtTime(opened.frames, playback.playheadS) + 1));
    },
    setRange: (range) => playback?.setRange(range),
    enterRange: () => {
      if (playback?.enterRange()) resetTime();
    },
    preload: async () => {
      const count = opened ? Math.min(opened.file.frames.length, opened.cache.capacity) : 0;
      for (let i = 0; i < count; i++) await opened?.cache.request(i);
    },
    end: async () => {
      if (ended) return;
      ended = true;
      playback?.stop();
      input?.dispose();
      gl.canvas.removeEventListener('webglcontextrestored', restore);
      opened?.cache.dispose();
      opened?.textures.dispose();
      opened = null;
      shown = null;
      onEvent?.({ kind: 'ended', by: 'page' });
    },
  };
}
