import type { VideoAsset, VideoPlayback } from '../../../../nodes/kit/runtime.ts';
import type { GlObjects } from '../../gl/gl-objects.ts';
import { createVideoElement, videoError } from './video-element.ts';
import { createVideoTexture } from './video-texture.ts';

/** What browsers play at without stumbling; beyond, pictures are sought one by one. */
const MIN_RATE = 0.0625;
const MAX_RATE = 16;
/** How far a running video may stray from the clock, seconds: a seek is seen, less than this is not. */
const MAX_DRIFT_S = 0.25;
/** WebM rounds times to milliseconds: a picture asked for at its exact time could be the one before. */
const ROUNDING_S = 0.001;

type Problem = Parameters<Parameters<VideoAsset['open']>[0]>[0];

/** Plays one video in one `<video>`, whose newest picture is in a texture. */
export function createPlayback(objects: GlObjects, url: string, durationS: number, onProblem: (problem: Problem) => void): VideoPlayback {
  const { element, dispose } = createVideoElement(url);
  const texture = createVideoTexture(objects);
  const lastS = Math.max(0, durationS - ROUNDING_S);
  /** The element has a picture, and may be sought. */
  let ready = false;
  let failed = false;
  /** What is asked for while the video is held, and what the element was last told to seek. */
  let wantedS = Number.NaN;
  let soughtS = Number.NaN;
  let seeking = false;
  /** The element has a picture that the texture has not. */
  let fresh = false;
  let starting = false;
  let blocked = false;
  let settled: { readonly promise: Promise<void>; readonly resolve: () => void } | null = null;

  const seek = (timeS: number): void => {
    soughtS = timeS;
    seeking = true;
    element.currentTime = Math.min(timeS + ROUNDING_S, lastS);
  };
  const isThere = (): boolean => failed || (ready && !seeking && soughtS === wantedS);
  /** One seek at a time: a newer wish waits for the one under way, so that dragging a slider shows pictures at all. */
  const proceed = (): void => {
    if (ready && !seeking && !failed && soughtS !== wantedS) seek(wantedS);
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

  const onLoaded = (): void => {
    ready = true;
    fresh = true;
    proceed();
  };
  const onSeeked = (): void => {
    seeking = false;
    fresh = true;
    if (element.paused) proceed();
  };
  const onError = (): void => {
    failed = true;
    const { message, fix } = videoError(element.error);
    onProblem({ message: `The video cannot be played on: ${message}.`, fix });
    proceed();
  };
  /** Firefox before 132 does not tell of new pictures: every frame takes one then. */
  const tells = 'requestVideoFrameCallback' in element;
  let watching = 0;
  const watch = (): void => {
    watching = element.requestVideoFrameCallback(() => {
      fresh = true;
      watch();
    });
  };
  if (tells) watch();
  element.addEventListener('loadeddata', onLoaded, { once: true });
  element.addEventListener('seeked', onSeeked);
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
          message: 'The browser does not let the video start by itself, so it is shown picture by picture until the page is tapped.',
          fix: 'Tap or click the page. Phones that save power hold videos back.',
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
    element.loop = loop;
    if (element.playbackRate !== rate) element.playbackRate = rate;
    wantedS = timeS;
    const apartS = Math.abs(element.currentTime - timeS);
    const driftS = loop ? Math.min(apartS, Math.abs(durationS - apartS)) : apartS;
    if (ready && !seeking && driftS > MAX_DRIFT_S * Math.max(1, rate)) seek(timeS);
    if (element.paused) start();
    else if (!tells) fresh = true;
    soughtS = Number.NaN;
    upload();
  };
  const hold = (timeS: number): void => {
    if (!element.paused) element.pause();
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
      element.removeEventListener('seeked', onSeeked);
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
