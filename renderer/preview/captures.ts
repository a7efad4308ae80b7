import type { FromPreview } from '../preview-protocol.ts';
import type { PosterPlace } from './posters.ts';

/** Pictures and videos of what is shown, as it is shown. */
export interface Captures {
  screenshot(place: PosterPlace | null): void;
  record(on: boolean, place: PosterPlace | null): void;
  beforeFrame(place: PosterPlace | null): void;
  afterFrame(place: PosterPlace | null): void;
}

/** Best first; what the browser has. `avc3` bears a preview that changes its size. */
const VIDEO_TYPES = ['video/mp4;codecs=avc3.42E01E', 'video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'];
const BITS_PER_PIXEL_S = 4;

/** `wake` asks for another frame, also of a preview that is held. */
export function createCaptures(send: (message: FromPreview) => void, wake: () => void): Captures {
  /** An emulated device shows its picture when the frame is over. */
  let wish: 'none' | 'new' | 'drawn' = 'none';
  let recorder: MediaRecorder | null = null;
  const take = ({ canvas }: PosterPlace) => {
    wish = 'none';
    const picture = new OffscreenCanvas(canvas.width, canvas.height);
    picture.getContext('2d')?.drawImage(canvas, 0, 0);
    void picture.convertToBlob({ type: 'image/png' }).then(
      (file) => send({ kind: 'captured', what: 'screenshot', file }),
      () => send({ kind: 'captured', what: 'screenshot', file: null }),
    );
  };
  const answer = (file: Blob | null) => send({ kind: 'captured', what: 'video', file });
  const begin = ({ canvas }: PosterPlace) => {
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
      wish = 'new';
      wake();
    },
    record: (on, place) => {
      if (!on) recorder?.stop();
      else if (!place) answer(null);
      else if (!recorder) begin(place);
    },
    beforeFrame: (place) => {
      if (wish === 'drawn' && place) take(place);
    },
    afterFrame: (place) => {
      if (wish !== 'new' || !place) return;
      if (place.shows === 'in the frame') take(place);
      else {
        wish = 'drawn';
        wake();
      }
    },
  };
}
