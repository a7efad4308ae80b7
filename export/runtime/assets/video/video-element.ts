/** A problem of a video. The message follows “cannot be decoded: ” and includes the remedy. */
export class VideoError extends Error {
  readonly fix = 'Save it as MP4 with H.264, or as WebM with VP9, which browsers play everywhere.';
}

/** The reason why a `<video>` failed, as text for the user. */
export function videoError(error: MediaError | null): VideoError {
  // Media error codes of the HTML standard: 3 is MEDIA_ERR_DECODE, 4 MEDIA_ERR_SRC_NOT_SUPPORTED.
  if (error?.code === 4) return new VideoError('this browser has no decoder for it');
  return new VideoError(error?.code === 3 ? 'a part of it is damaged' : 'the browser gave it up');
}

export interface VideoElement {
  readonly element: HTMLVideoElement;
  dispose(): void;
}

/** A detached and muted element, which browsers allow to start without a gesture. */
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
      // Frees the decoder at once instead of at garbage collection.
      element.removeAttribute('src');
      element.load();
    },
  };
}
