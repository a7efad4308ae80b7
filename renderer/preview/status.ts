import type { FrameClock } from '../../export/runtime/clock.ts';
import { type FrameTimes, frameAtTime } from '../../nodes/kit/frame-times.ts';
import type { SessionFrame } from '../../nodes/kit/session.ts';
import type { FromPreview, PreviewStatus } from '../preview-protocol.ts';

/** Tells the editor how the preview runs, at most ten times a second; while it is held, of every frame that is another one. */
export interface Status {
  setState(state: PreviewStatus['state']): void;
  setRequest(request: number): void;
  /** Around the drawing of a frame. */
  begin(): void;
  end(frame: SessionFrame, late: boolean): void;
  /** Frames and time count from the next frame on; frames that repeat a held moment do not count. `frames`: of a recording. */
  rewind(frames: FrameTimes | null): void;
}

const INTERVAL_S = 0.1;
/** Of a new frame's time in the mean. */
const WEIGHT = 0.1;

export function createStatus(clock: FrameClock, send: (message: FromPreview) => void): Status {
  const status = {
    state: 'loading' as PreviewStatus['state'],
    request: null as PreviewStatus['request'],
    frame: 0,
    late: false,
    timeS: 0,
    frameMs: 0,
    widthPx: 0,
    heightPx: 0,
  };
  let sentS = Number.NEGATIVE_INFINITY;
  let beganS = 0;
  let originS: number | null = null;
  let lastS = 0;
  let frames: FrameTimes | null = null;
  let seen: SessionFrame | null = null;
  const tell = () => {
    sentS = clock.nowS();
    const [view] = seen?.views ?? [];
    send({ kind: 'status', status: { ...status, worldFromView: view ? [...view.worldFromView] : null } });
  };
  return {
    setState: (state) => {
      status.state = state;
      tell();
    },
    setRequest: (request) => {
      if (status.request === request) return;
      status.request = request;
      tell();
    },
    begin: () => {
      beganS = clock.nowS();
    },
    end: (frame, late) => {
      const nowS = clock.nowS();
      const tookMs = (nowS - beganS) * 1000;
      const moved = originS === null || frame.timeS !== lastS;
      const arrived = status.late && !late;
      status.late = late;
      if (originS === null) status.frame = 0;
      else if (moved) status.frame++;
      // A recording says its own time; others begin when they are begun.
      originS ??= frames ? 0 : frame.timeS;
      lastS = frame.timeS;
      seen = frame;
      status.timeS = frame.timeS - originS;
      if (frames) status.frame = frameAtTime(frames, status.timeS);
      status.frameMs = status.frameMs === 0 ? tookMs : status.frameMs * (1 - WEIGHT) + tookMs * WEIGHT;
      status.widthPx = frame.framebufferWidthPx;
      status.heightPx = frame.framebufferHeightPx;
      if (nowS - sentS >= INTERVAL_S || ((moved || arrived) && status.state === 'paused')) tell();
    },
    rewind: (of) => {
      originS = null;
      frames = of;
    },
  };
}
