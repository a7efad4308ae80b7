import type { Capability } from '../../../../nodes/kit/definition.ts';
import type { Result } from '../../../../nodes/kit/diagnostics.ts';
import { type FrameTimes, frameAtTime, timeOfFrame } from '../../../../nodes/kit/frame-times.ts';
import type { Session, SessionEvent, SessionFrame } from '../../../../nodes/kit/session.ts';
import type { AssetSource } from '../../assets/asset-source.ts';
import type { FrameClock } from '../../clock.ts';
import { createPageInput, type PageInput } from '../input/page-input.ts';
import { createSessionFrame } from '../session-frame.ts';
import { createFrameCache, type DecodedFrame, type FrameCache } from './frame-cache.ts';
import { createPictureTextures, type PictureTextures } from './picture-textures.ts';
import { brokenSession } from './read-session-file.ts';
import { createRecordedView, type RecordedView } from './recorded-view.ts';
import { openRecording, type Recording } from './recording.ts';
import { createPlayback, type PlayRange } from './session-playback.ts';

export interface RecordedSessionOptions {
  readonly gl: WebGL2RenderingContext;
  /** The session folder. */
  readonly files: AssetSource;
  /** `clock`: plays in time, from the start again at the end. `manual`: a frame for each `step`. */
  readonly mode: { readonly kind: 'clock'; readonly clock: FrameClock } | { readonly kind: 'manual' };
  /** Decoded frames kept in memory; 60 frames of 640 × 480 with depth take 147 MB. */
  readonly budgetBytes?: number;
  /** `clock` only: a range has been played that does not loop, and its last frame stays as long as the clock stands. */
  readonly onEnd?: () => void;
  /** `clock` only: a frame was not decoded in its turn, and now is. */
  readonly onArrival?: () => void;
}

export interface RecordingInfo {
  readonly title: string;
  readonly frames: FrameTimes;
}

/** Plays a recorded session folder on the whole canvas, cutting the pictures to its shape. */
export interface RecordedSession extends Session {
  /**
   * When the folder has been read and its first frame decoded; `capabilities` are complete then. Never rejects: a broken folder
   * gives SCR054 and no output.
   */
  readonly ready: Promise<Result<RecordingInfo>>;
  /** Manual only, once ready and started: delivers frame `index`. False where its picture is broken, which an event says. */
  step(index: number): Promise<boolean>;
  /** The same for a moment, seconds since the first frame, later rounds included: shows the frame that it falls into. */
  stepTo(timeS: number): Promise<boolean>;
  /** Of `clock`: what is shown, or comes next, in seconds since the first frame, later rounds included. */
  readonly playheadS: number;
  /** Of `clock`: the picture that was shown last is an earlier frame's, because its own is not decoded yet. */
  readonly isLate: boolean;
  /** Goes on from frame `index`, and says so with a `reset`. */
  seek(index: number): void;
  /** Goes on from a moment, seconds since its first frame, later rounds included; says so with a `reset`. */
  seekTime(timeS: number): void;
  /** To the next frame, counted over all rounds, with the time until then; one for each call. */
  stepOn(): void;
  setRange(range: PlayRange | null): void;
  /** Goes to the start of the range where the playhead is outside, and says so with a `reset`. */
  enterRange(): void;
  /** Decodes all frames that the budget holds. */
  preload(): Promise<void>;
}

const DEFAULT_BUDGET_BYTES = 512 * 1024 * 1024;

/** Frames decoded ahead of the one shown, so that playing rarely waits. */
const LOOK_AHEAD = 4;

/** An open recording. */
interface Reel extends Recording {
  readonly cache: FrameCache;
  textures: PictureTextures;
  view: RecordedView;
}

export function createRecordedSession(options: RecordedSessionOptions): RecordedSession {
  const { gl, files, mode } = options;
  const capabilities = new Set<Capability>();
  const frame = createSessionFrame();
  let reel: Reel | null = null;
  let onFrame: ((frame: SessionFrame) => void) | null = null;
  let onEvent: ((event: SessionEvent) => void) | null = null;
  let ended = false;
  /** What the textures hold. */
  let shown: DecodedFrame | null = null;
  let isLate = false;
  /** Null after a jump: no time has passed since. */
  let deliveredS: number | null = null;
  const problems: string[] = [];
  let input: PageInput | null = null;

  const say = (message: string): void => {
    if (onEvent) onEvent({ kind: 'problem', message });
    else problems.push(message);
  };
  const deliver = (current: Reel, decoded: DecodedFrame, index: number, timeS: number): boolean => {
    if (gl.drawingBufferWidth === 0 || gl.drawingBufferHeight === 0) return false;
    if (decoded !== shown) current.textures.upload(decoded);
    shown = decoded;
    frame.index = index;
    frame.timeS = timeS;
    frame.deltaS = deliveredS === null ? 0 : Math.max(0, timeS - deliveredS);
    frame.light = current.lights[decoded.index] ?? null;
    frame.surfaces = current.surfaces;
    deliveredS = timeS;
    current.view.fill(frame, decoded);
    input?.fill(frame);
    onFrame?.(frame);
    return true;
  };
  const show = (playheadS: number): boolean => {
    if (!reel) return false;
    const { file, cache, frames } = reel;
    const number = frameAtTime(frames, playheadS);
    const index = number % file.frames.length;
    for (let ahead = 0; ahead <= LOOK_AHEAD; ahead++) cache.prefetch((index + ahead) % file.frames.length);
    // A frame that is not decoded yet delays nothing: the previous frame stays.
    const mine = cache.get(index);
    if (!mine && options.onArrival) void cache.request(index).then((arrived) => arrived && options.onArrival?.());
    isLate = cache.isComing(index);
    const decoded = mine ?? shown ?? cache.get(0);
    return decoded !== null && deliver(reel, decoded, number, playheadS);
  };
  const jumped = (): void => {
    deliveredS = null;
    onEvent?.({ kind: 'reset' });
  };
  const playback =
    mode.kind === 'clock'
      ? createPlayback(mode.clock, {
          durationS: () => reel?.frames.durationS ?? null,
          show,
          onRepeat: () => onEvent?.({ kind: 'reset' }),
          onLoop: jumped,
          onEnd: () => options.onEnd?.(),
        })
      : null;
  const open = async (): Promise<Result<RecordingInfo>> => {
    const { output: recording, diagnostics } = await openRecording(files);
    if (!recording) return { output: null, diagnostics };
    const { file } = recording;
    const cache = createFrameCache(files, file, options.budgetBytes ?? DEFAULT_BUDGET_BYTES, say);
    const first = await cache.request(0);
    if (!first || ended) {
      cache.dispose();
      return { output: null, diagnostics: [...diagnostics, brokenSession(problems[0] ?? 'The session ended before it was read.')] };
    }
    const textures = createPictureTextures(gl, file);
    reel = { ...recording, cache, textures, view: createRecordedView(gl, file, textures) };
    capabilities.add('camera-image');
    if (file.depth) capabilities.add('depth');
    if (recording.lights.some((light) => light !== null)) capabilities.add('light-estimation');
    if (recording.surfaces) capabilities.add('planes');
    if (onFrame) playback?.start();
    return { output: { title: file.title, frames: recording.frames }, diagnostics };
  };
  /** The context is back, and empty. */
  const restore = (): void => {
    if (!reel) return;
    reel.textures = createPictureTextures(gl, reel.file);
    reel.view = createRecordedView(gl, reel.file, reel.textures);
    shown = null;
  };
  const seekTime = (timeS: number): void => {
    playback?.seek(Math.max(0, timeS));
    jumped();
  };
  const stepTo = async (timeS: number): Promise<boolean> => {
    const current = reel;
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
      // A canvas on no page, as renders have, is tapped by nobody.
      if (mode.kind === 'clock' && 'ownerDocument' in gl.canvas) input ??= createPageInput(gl.canvas);
      for (const message of problems.splice(0)) say(message);
      if (reel) playback?.start();
    },
    step: async (index) => {
      if (reel && !reel.file.frames[index]) throw new RangeError(`The session has no frame ${index}.`);
      return stepTo(reel ? timeOfFrame(reel.frames, index) : 0);
    },
    stepTo,
    get playheadS() {
      return playback?.playheadS ?? 0;
    },
    get isLate() {
      return isLate;
    },
    seek: (index) => {
      if (reel) seekTime(timeOfFrame(reel.frames, index));
    },
    seekTime,
    stepOn: () => {
      if (reel && playback) playback.advanceTo(timeOfFrame(reel.frames, frameAtTime(reel.frames, playback.playheadS) + 1));
    },
    setRange: (range) => playback?.setRange(range),
    enterRange: () => {
      if (playback?.enterRange()) jumped();
    },
    preload: async () => {
      const count = reel ? Math.min(reel.file.frames.length, reel.cache.capacity) : 0;
      for (let i = 0; i < count; i++) await reel?.cache.request(i);
    },
    end: async () => {
      if (ended) return;
      ended = true;
      playback?.stop();
      input?.dispose();
      gl.canvas.removeEventListener('webglcontextrestored', restore);
      reel?.cache.dispose();
      reel?.textures.dispose();
      reel = null;
      shown = null;
      onEvent?.({ kind: 'ended', by: 'page' });
    },
  };
}
