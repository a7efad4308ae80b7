import type { VideoAsset } from '../../../../nodes/kit/assets.ts';
import type { FrameClock } from '../../clock.ts';
import type { GlObjects } from '../../gl/gl-objects.ts';
import { createVideoElement, VideoError, videoError } from './video-element.ts';
import { createPlayback } from './video-playback.ts';

export interface LoadedVideo extends VideoAsset {
  dispose(): void;
}

/**
 * Keeps a video file in memory and reads its duration and size; frames are decoded during playback. A file in memory supports seeking on
 * any host and needs no network.
 *
 * @throws VideoError, as a rejection, if the browser cannot play it.
 */
export async function loadVideo(objects: GlObjects, bytes: ArrayBuffer, delay: FrameClock['delay']): Promise<LoadedVideo> {
  const url = URL.createObjectURL(new Blob([bytes], { type: mediaTypeOf(bytes) }));
  try {
    const { durationS, widthPx, heightPx } = await measure(url);
    return {
      durationS,
      widthPx,
      heightPx,
      open: (onProblem) => createPlayback({ objects, url, durationS, delay }, onProblem),
      dispose: () => URL.revokeObjectURL(url),
    };
  } catch (error) {
    URL.revokeObjectURL(url);
    throw error;
  }
}

/**
 * Detects MP4 (ISO 14496-12 §4.3) or WebM (RFC 8794 §11.2) by the first bytes, because browsers rely on the type of a blob. Throws a
 * VideoError for other files.
 */
function mediaTypeOf(bytes: ArrayBuffer): string {
  const view = new DataView(bytes);
  if (bytes.byteLength > 12 && view.getUint32(4) === 0x66747970) return 'video/mp4';
  if (bytes.byteLength > 12 && view.getUint32(0) === 0x1a45dfa3) return 'video/webm';
  throw new VideoError('it is neither an MP4 nor a WebM file');
}

interface Measured {
  readonly durationS: number;
  readonly widthPx: number;
  readonly heightPx: number;
}

/** A time after the end of any video. A seek to it makes the browser find the end, and so the duration. */
const BEYOND_THE_END_S = 1e7;

async function measure(url: string): Promise<Measured> {
  const video = createVideoElement(url);
  try {
    await until(video, 'loadedmetadata');
    const { videoWidth: widthPx, videoHeight: heightPx } = video.element;
    if (widthPx === 0 || heightPx === 0) throw new VideoError('it holds no picture that this browser can decode');
    if (video.element.duration === Number.POSITIVE_INFINITY) {
      // Files recorded by a browser do not contain the duration; it is known after a seek to the end.
      const known = until(video, 'durationchange');
      video.element.currentTime = BEYOND_THE_END_S;
      await known;
    }
    const { duration } = video.element;
    if (!Number.isFinite(duration) || duration <= 0) throw new VideoError('it does not say how long it is');
    return { durationS: duration, widthPx, heightPx };
  } finally {
    video.dispose();
  }
}

function until({ element }: { readonly element: HTMLVideoElement }, event: 'loadedmetadata' | 'durationchange'): Promise<void> {
  return new Promise((resolve, reject) => {
    element.addEventListener(event, () => resolve(), { once: true });
    element.addEventListener('error', () => reject(videoError(element.error)), { once: true });
  });
}
