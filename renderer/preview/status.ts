import type { FrameClock } from '../../export/runtime/clock.ts';
import { type FrameTimes, frameAtTime } from '../../nodes/kit/frame-times.ts';
import { tangentsOf } from '../../nodes/kit/poster-framing.ts';
import type { SessionFrame } from '../../nodes/kit/session.ts';
import type { FromPreview, PreviewStatus } from '../preview-protocol.ts';

/** Sends the status of the preview at most ten times a second; while paused, for each new frame. */
export interface Status {
  setState(state: PreviewStatus['state']): void;
  setRequest(request: number): void;
  /** Called before and after a frame. Frames that were not drawn, because nothing had changed, have no part in the mean frame time. */
  begin(): void;
  end(frame: SessionFrame, late: boolean, drawn?: boolean): void;
  /**
   * Restarts the frame count and the time at the next frame. While time is paused, repeated frames do not count. `frames`: frame times of
   * the recording; null for other sessions.
   */
  rewind(frames: FrameTimes | null): void;
}

const INTERVAL_S = 0.1;
/** Time over which the frame rate is measured. */
const RATE_INTERVAL_S = 0.5;
/** Weight of a new frame in the mean frame time. */
const WEIGHT = 0.1;

export function createStatus(clock: FrameClock, send: (message: FromPreview) => void): Status {
  const status = {
    state: 'loading' as PreviewStatus['state'],
    request: null as PreviewStatus['request'],
    frame: 0,
    late: false,
    timeS: 0,
    frameMs: 0,
    framesPerS: 0,
    widthPx: 0,
    heightPx: 0,
  };
  let sentS = Number.NEGATIVE_INFINITY;
  let beganS = 0;
  let originS: number | null = null;
  let lastS = 0;
  let frames: FrameTimes | null = null;
  let seen: SessionFrame | null = null;
  /** Start of the current measurement of the frame rate, and the frames since. */
  let measuredS: number | null = null;
  let drawn = 0;
  const post = () => {
    sentS = clock.nowS();
    const [view] = seen?.views ?? [];
    send({
      kind: 'status',
      status: { ...status, worldFromView: view ? [...view.worldFromView] : null, tangents: view ? tangentsOf(view.clipFromView) : null },
    });
  };
  const measureRate = (nowS: number) => {
    if (measuredS === null) {
      measuredS = nowS;
      drawn = 0;
      return;
    }
    drawn++;
    if (nowS - measuredS < RATE_INTERVAL_S) return;
    status.framesPerS = drawn / (nowS - measuredS);
    measuredS = nowS;
    drawn = 0;
  };
  return {
    setState: (state) => {
      status.state = state;
      if (state !== 'playing') {
        measuredS = null;
        status.framesPerS = 0;
      }
      post();
    },
    setRequest: (request) => {
      if (status.request === request) return;
      status.request = request;
      post();
    },
    begin: () => {
      beganS = clock.nowS();
    },
    end: (frame, late, drawn = true) => {
      const nowS = clock.nowS();
      const tookMs = (nowS - beganS) * 1000;
      const moved = originS === null || frame.timeS !== lastS;
      const arrived = status.late && !late;
      status.late = late;
      if (originS === null) status.frame = 0;
      else if (moved) status.frame++;
      // The time of a recording is absolute; other sessions count from their first frame.
      originS ??= frames ? 0 : frame.timeS;
      lastS = frame.timeS;
      seen = frame;
      status.timeS = frame.timeS - originS;
      if (frames) status.frame = frameAtTime(frames, status.timeS);
      if (drawn) status.frameMs = status.frameMs === 0 ? tookMs : status.frameMs * (1 - WEIGHT) + tookMs * WEIGHT;
      if (status.state === 'playing') measureRate(nowS);
      status.widthPx = frame.framebufferWidthPx;
      status.heightPx = frame.framebufferHeightPx;
      if (nowS - sentS >= INTERVAL_S || ((moved || arrived) && status.state === 'paused')) post();
    },
    rewind: (of) => {
      originS = null;
      frames = of;
    },
  };
}
