import type { VideoAsset, VideoPlayback } from '../../../../nodes/kit/assets.ts';
import type { FrameClock } from '../../clock.ts';
import type { GlObjects } from '../../gl/gl-objects.ts';
import { createVideoElement, videoError } from './video-element.ts';
import { createVideoTexture } from './video-texture.ts';

/** What browsers play at without stumbling; beyond, pictures are sought one by one. */
const MIN_RATE = 0.0625;
const MAX_RATE = 16;
/** How far a running video may stray from the clock, seconds: a seek is seen, less than this is not. */
const MAX_DRIFT_S = 0.25;
/** How long to wait for word of a picture that was sought, seconds, before it is sought again; then twice as long, up to the most. */
const PATIENCE_S = 0.2;
const MAX_PATIENCE_S = 2;
/** WebM rounds times to milliseconds: a picture asked for at its exact time could be the one before. */
const ROUNDING_S = 0.001;

type Problem = Parameters<Parameters<VideoAsset['open']>[0]>[0];

export interface VideoSource {
  readonly objects: GlObjects;
  readonly url: string;
  readonly durationS: number;
  readonly delay: FrameClock['delay'];
}

/** Plays one video in one `<video>`, whose newest picture is in a texture. */
export function createPlayback(source: VideoSource, onProblem: (problem: Problem) => void): VideoPlayback {
  const { objects, url, durationS, delay } = source;
  const { element, dispose } = createVideoElement(url);
  const texture = createVideoTexture(objects);
  /** Firefox before 132 does not tell of new pictures. */
  const tells = 'requestVideoFrameCallback' in element;
  let failed = false;
  /** What is asked for while the video is held, and what the element was last told to seek. */
  let wantedS: number | null = null;
  // What it shows once it has loaded.
  let soughtS: number | null = 0;
  let tries = 0;
  /**
   * What the element has yet to say of what it was told to load or seek: that it is there, and that its picture is, which often comes
   * later. Nothing else may be asked of it meanwhile.
   */
  const awaited = { event: true, picture: tells };
  /** A picture from before the seek may still have been on its way when the video ran: it is sought twice then. */
  let ran = false;
  /** The element has a picture that the texture has not. */
  let fresh = false;
  let starting = false;
  let blocked = false;
  let settled: { readonly promise: Promise<void>; readonly resolve: () => void } | null = null;

  const isIdle = (): boolean => !awaited.event && !awaited.picture;
  const isThere = (): boolean => failed || (isIdle() && wantedS !== null && soughtS === wantedS);
  const seek = (timeS: number): void => {
    soughtS = timeS;
    awaited.event = true;
    awaited.picture = tells;
    element.currentTime = Math.min(timeS + ROUNDING_S, durationS);
    void insist(++tries, PATIENCE_S);
  };
  /** Now and then Chromium forgets to tell of a picture, most often when it is the one that was there before. */
  const insist = async (mine: number, patienceS: number): Promise<void> => {
    await delay(patienceS);
    if (mine !== tries || !awaited.picture || failed) return;
    // At the very end there may be none to tell of.
    if (patienceS > MAX_PATIENCE_S || (element.ended && !awaited.event)) {
      awaited.picture = false;
      arrive();
      return;
    }
    if (!awaited.event && soughtS !== null) {
      awaited.event = true;
      element.currentTime = Math.min(soughtS + ROUNDING_S, durationS);
    }
    void insist(mine, patienceS * 2);
  };
  /** One seek at a time: a newer wish waits for the one under way, so that dragging a slider shows pictures at all. */
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
      awaited.picture = false;
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
        // A pause that came before the video had begun is no refusal.
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
    get picture() {
      return texture.picture;
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
