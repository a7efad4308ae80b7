/** Constraints of the stream: the rear camera if there are several, in a size that phones and computers deliver easily. */
const WISHES: MediaStreamConstraints = {
  audio: false,
  video: { facingMode: { ideal: 'environment' }, width: { ideal: 1280 }, height: { ideal: 720 }, frameRate: { ideal: 30 } },
};

/** The video stream of the camera, which is on from `start` to `stop`. */
export interface CameraStream {
  readonly video: HTMLVideoElement;
  /** Resolves with the first image; rejects as `getUserMedia` does. */
  start(): Promise<void>;
  stop(): void;
}

/** Creates the stream. `onLost` is called if the camera is unplugged, or if the system or the visitor stops it. */
export function createCameraStream(document: Document, media: MediaDevices, onLost: () => void): CameraStream {
  const video = document.createElement('video');
  video.muted = true;
  // Without it, iOS plays the video in its own full-screen player.
  video.playsInline = true;
  let stream: MediaStream | null = null;
  /** Number of calls of `start` and `stop`. The result of a request that an earlier call made is dropped. */
  let generation = 0;

  const lost = (): void => {
    if (stream) onLost();
  };
  const stop = (): void => {
    generation++;
    for (const track of stream?.getTracks() ?? []) {
      track.removeEventListener('ended', lost);
      track.stop();
    }
    stream = null;
    video.srcObject = null;
  };
  return {
    video,
    start: async () => {
      stop();
      const started = generation;
      const granted = await media.getUserMedia(WISHES);
      if (started !== generation) {
        for (const track of granted.getTracks()) track.stop();
        return;
      }
      stream = granted;
      for (const track of granted.getTracks()) track.addEventListener('ended', lost);
      video.srcObject = granted;
      try {
        await video.play();
      } catch (error) {
        // Stopped meanwhile, which is not an error.
        if (started !== generation) return;
        stop();
        throw error;
      }
    },
    stop,
  };
}
