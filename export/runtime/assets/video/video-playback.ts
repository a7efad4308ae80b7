import type { VideoAsset, VideoPlayback } from '../../../../nodes/kit/assets.ts';
import type { FrameClock } from '../../clock.ts';
import type { GlObjects } from '../../gl/gl-objects.ts';
import { createVideoElement, videoError } from './video-element.ts';
import { createVideoTexture } from './video-texture.ts';

/** Lowest playback rate that browsers play smoothly; below it, frames are sought one by one. */
const MIN_RATE = 0.0625;
const MAX_RATE = 16;
/** Maximum drift of a playing video from the clock, seconds; a larger one causes a seek. Seeks are visible, smaller drifts are not. */
const MAX_DRIFT_S = 0.25;
/** How long to wait for the frame of a seek, seconds. Then the seek is repeated with twice the timeout, until it exceeds the maximum. */
const PATIENCE_S = 0.2;
const MAX_PATIENCE_S = 2;
/** Added to the time of a seek, seconds: WebM rounds times to milliseconds, so a seek to the exact time could show the previous frame. */
const ROUNDING_S = 0.001;

type Problem = Parameters<Parameters<VideoAsset['open']>[0]>[0];

export interface VideoSource {
  readonly objects: GlObjects;
  readonly url: string;
  readonly durationS: number;
  readonly delay: FrameClock['delay'];
}

/** Plays one video in a `<video>` whose current frame is in a texture. */
export function createPlayback(source: VideoSource, onProblem: (problem: Problem) => void): VideoPlayback {
  const { objects, url, durationS, delay } = source;
  const { element, dispose } = createVideoElement(url);
  const texture = createVideoTexture(objects);
  /** Whether the browser reports new frames; Firefox before 132 does not. */
  const tells = 'requestVideoFrameCallback' in element;
  let failed = false;
  /** The time requested while the video is held, and the time of the last seek. */
  let wantedS: number | null = null;
  // The frame shown after loading.
  let soughtS: number | null = 0;
  let tries = 0;
  /**
   * What the element has not yet reported since the last load or seek: `event`, the end of the load or seek, and `image`, its frame, which
   * often comes later. The next seek starts after both.
   */
  const awaited = { event: true, image: tells };
  /** Whether the video was playing before the seek. If so, a frame from before the seek may arrive after it, so the seek is repeated. */
  let ran = false;
  /** Whether the element has a frame that the texture does not have. */
  let fresh = false;
  let starting = false;
  let blocked = false;
  let settled: { readonly promise: Promise<void>; readonly resolve: () => void } | null = null;

  const isIdle = (): boolean => !awaited.event && !awaited.image;
  const isThere = (): boolean => failed || (isIdle() && wantedS !== null && soughtS === wantedS);
  const seek = (timeS: number): void => {
    soughtS = timeS;
    awaited.event = true;
    awaited.image = tells;
    element.currentTime = Math.min(timeS + ROUNDING_S, durationS);
    void insist(++tries, PATIENCE_S);
  };
  /**
   * Repeats the seek if its frame was not reported in time. Chromium sometimes does not report a frame, mostly if it is the same as before.
   */
  const insist = async (mine: number, patienceS: number): Promise<void> => {
    await delay(patienceS);
    if (mine !== tries || !awaited.image || failed) return;
    // At the very end there may be no frame.
    if (patienceS > MAX_PATIENCE_S || (element.ended && !awaited.event)) {
      awaited.image = false;
      arrive();
      return;
    }
    if (!awaited.event && soughtS !== null) {
      awaited.event = true;
      element.currentTime = Math.min(soughtS + ROUNDING_S, durationS);
    }
    void insist(mine, patienceS * 2);
  };
  /**
   * Starts the requested seek unless one is running; else uploads the frame. A newer request waits for the current seek, so frames appear
   * while a slider is dragged.
   */
  const proceed = (): void => {
    if (isIdle() && !failed && wantedS !== null && soughtS !== wantedS) seek(wantedS);
    if (!isThere()) return;
    upload();
    settled?.resolve();
    settled = null;
  };
  const upload = (): void => {
    if (!fresh || failed || element.readyState < HTMLMediaElement.HAVE_CURRENT_DATA) return;
    fresh = false;
    texture.upload(element);
  };
  const arrive = (): void => {
    if (!isIdle()) return;
    fresh = true;
    if (!element.paused) return;
    if (ran) soughtS = null;
    ran = false;
    proceed();
  };

  let watching = 0;
  const watch = (): void => {
    watching = element.requestVideoFrameCallback(() => {
      fresh = true;
      awaited.image = false;
      arrive();
      watch();
    });
  };
  if (tells) watch();
  const onEvent = (): void => {
    awaited.event = false;
    arrive();
  };
  const onError = (): void => {
    failed = true;
    const { message, fix } = videoError(element.error);
    onProblem({ message: `The video cannot be played on: ${message}.`, fix });
    proceed();
  };
  const onLoaded = (): void => {
    onEvent();
    void insist(++tries, PATIENCE_S);
  };
  element.addEventListener('loadeddata', onLoaded, { once: true });
  element.addEventListener('seeked', onEvent);
  element.addEventListener('error', onError);

  const start = (): void => {
    if (starting) return;
    starting = true;
    element
      .play()
      .catch((error: unknown) => {
        // A pause before the start is not a refusal.
        if (!(error instanceof DOMException) || error.name !== 'NotAllowedError') return;
        blocked = true;
        document.addEventListener('pointerdown', unblock, { once: true });
        onProblem({
          message: 'The browser blocks the video from starting by itself. It is shown frame by frame until the page is tapped.',
          fix: 'Tap or click the page. If that does not help, turn power saving off.',
        });
      })
      .finally(() => {
        starting = false;
      });
  };
  const unblock = (): void => {
    blocked = false;
  };
  const run = (timeS: number, rate: number, loop: boolean): void => {
    wantedS = null;
    ran = true;
    element.loop = loop;
    if (element.playbackRate !== rate) element.playbackRate = rate;
    const apartS = Math.abs(element.currentTime - timeS);
    const driftS = loop ? Math.min(apartS, Math.abs(durationS - apartS)) : apartS;
    if (isIdle() && driftS > MAX_DRIFT_S * Math.max(1, rate)) seek(timeS);
    if (element.paused) start();
    else if (!tells) fresh = true;
    upload();
  };
  const hold = (timeS: number): void => {
    if (!element.paused) element.pause();
    if (ran) soughtS = null;
    wantedS = timeS;
    proceed();
  };

  return {
    get image() {
      return texture.image;
    },
    get version() {
      return texture.version;
    },
    follow: (timeS, rate, loop) => {
      if (failed) return;
      if (rate >= MIN_RATE && rate <= MAX_RATE && !blocked) run(timeS, rate, loop);
      else hold(timeS);
    },
    settle: () => {
      if (isThere()) return null;
      if (!settled) {
        let resolve = (): void => {};
        const promise = new Promise<void>((done) => {
          resolve = done;
        });
        settled = { promise, resolve };
      }
      return settled.promise;
    },
    dispose: () => {
      element.removeEventListener('loadeddata', onLoaded);
      element.removeEventListener('seeked', onEvent);
      element.removeEventListener('error', onError);
      if (tells) element.cancelVideoFrameCallback(watching);
      document.removeEventListener('pointerdown', unblock);
      failed = true;
      settled?.resolve();
      texture.dispose();
      dispose();
    },
  };
}
