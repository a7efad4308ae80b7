import type { FromPreview } from '../preview-protocol.ts';
import type { CaptureSource } from './posters.ts';

/** Takes screenshots and records videos of the preview. */
export interface Captures {
  screenshot(place: CaptureSource | null): void;
  record(on: boolean, place: CaptureSource | null): void;
  /** Whether a screenshot waits for a frame, or a video for every frame. */
  readonly busy: boolean;
  beforeFrame(place: CaptureSource | null): void;
  afterFrame(place: CaptureSource | null): void;
}

/** Candidates in order of preference. `avc3` allows the preview to change its size. */
const VIDEO_TYPES = ['video/mp4;codecs=avc3.42E01E', 'video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'];
const BITS_PER_PIXEL_S = 4;

/**
 * Creates the object that takes screenshots and videos.
 *
 * @param wake Requests another frame, also while the preview is paused.
 */
export function createCaptures(send: (message: FromPreview) => void, wake: () => void): Captures {
  /**
   * State of the requested screenshot. An emulated device composites its image after the frame, so the screenshot is taken before the
   * next one.
   */
  let screenshotState: 'none' | 'new' | 'drawn' = 'none';
  let recorder: MediaRecorder | null = null;
  const takeScreenshot = ({ canvas }: CaptureSource) => {
    screenshotState = 'none';
    const image = new OffscreenCanvas(canvas.width, canvas.height);
    image.getContext('2d')?.drawImage(canvas, 0, 0);
    void image.convertToBlob({ type: 'image/png' }).then(
      (file) => send({ kind: 'captured', what: 'screenshot', file }),
      () => send({ kind: 'captured', what: 'screenshot', file: null }),
    );
  };
  const answer = (file: Blob | null) => send({ kind: 'captured', what: 'video', file });
  const begin = ({ canvas }: CaptureSource) => {
    const type = VIDEO_TYPES.find((candidate) => MediaRecorder.isTypeSupported(candidate));
    if (type === undefined) return answer(null);
    const parts: Blob[] = [];
    const stream = canvas.captureStream();
    const made = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: canvas.width * canvas.height * BITS_PER_PIXEL_S });
    made.ondataavailable = ({ data }) => void parts.push(data);
    made.onerror = () => made.stop();
    made.onstop = () => {
      for (const track of stream.getTracks()) track.stop();
      if (recorder === made) recorder = null;
      const file = new Blob(parts, { type });
      answer(file.size === 0 ? null : file);
    };
    recorder = made;
    made.start();
  };
  return {
    screenshot: (place) => {
      if (!place) return send({ kind: 'captured', what: 'screenshot', file: null });
      screenshotState = 'new';
      wake();
    },
    record: (on, place) => {
      if (!on) recorder?.stop();
      else if (!place) answer(null);
      else if (!recorder) begin(place);
    },
    get busy() {
      return screenshotState !== 'none' || recorder !== null;
    },
    beforeFrame: (place) => {
      if (screenshotState === 'drawn' && place) takeScreenshot(place);
    },
    afterFrame: (place) => {
      if (screenshotState !== 'new' || !place) return;
      if (place.shows === 'in the frame') takeScreenshot(place);
      else {
        screenshotState = 'drawn';
        wake();
      }
    },
  };
}
