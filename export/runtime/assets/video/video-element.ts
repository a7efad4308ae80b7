/** Says what is wrong with a video, going on after "cannot be decoded: ", and what to do. */
export class VideoError extends Error {
  readonly fix = 'Save it as MP4 with H.264, or as WebM with VP9, which browsers play everywhere.';
}

/** Why a `<video>` gave up, for people. */
export function videoError(error: MediaError | null): VideoError {
  // The codes of the HTML standard, "Media error codes": 3 is MEDIA_ERR_DECODE, 4 MEDIA_ERR_SRC_NOT_SUPPORTED.
  if (error?.code === 4) return new VideoError('this browser has no decoder for it');
  return new VideoError(error?.code === 3 ? 'a part of it is damaged' : 'the browser gave it up');
}

export interface VideoElement {
  readonly element: HTMLVideoElement;
  dispose(): void;
}

/** Off the page and silent, as browsers ask of videos that start by themselves. */
export function createVideoElement(url: string): VideoElement {
  const element = document.createElement('video');
  element.muted = true;
  element.playsInline = true;
  element.preload = 'auto';
  element.disablePictureInPicture = true;
  element.src = url;
  return {
    element,
    dispose: () => {
      element.pause();
      // The decoder is freed at once, not when the element is collected.
      element.removeAttribute('src');
      element.load();
    },
  };
}
