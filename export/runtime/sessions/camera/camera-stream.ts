/** The camera on the device's back where it has several, in a size that phones and computers give without effort. */
const WISHES: MediaStreamConstraints = {
  audio: false,
  video: { facingMode: { ideal: 'environment' }, width: { ideal: 1280 }, height: { ideal: 720 }, frameRate: { ideal: 30 } },
};

/** The camera's pictures. Its light is on from `start` to `stop`. */
export interface CameraStream {
  readonly video: HTMLVideoElement;
  /** Resolves when the first picture is there; rejects as `getUserMedia` does. */
  start(): Promise<void>;
  stop(): void;
}

/** `onLost`: the camera was unplugged, or taken away by the system or the visitor. */
export function createCameraStream(document: Document, media: MediaDevices, onLost: () => void): CameraStream {
  const video = document.createElement('video');
  video.muted = true;
  // Else iOS shows it in a player of its own.
  video.playsInline = true;
  let stream: MediaStream | null = null;
  /** Counts starts and stops: what was asked for before the last of them is wanted no more. */
  let turn = 0;

  const lost = (): void => {
    if (stream) onLost();
  };
  const stop = (): void => {
    turn++;
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
      const mine = turn;
      const granted = await media.getUserMedia(WISHES);
      if (mine !== turn) {
        for (const track of granted.getTracks()) track.stop();
        return;
      }
      stream = granted;
      for (const track of granted.getTracks()) track.addEventListener('ended', lost);
      video.srcObject = granted;
      try {
        await video.play();
      } catch (error) {
        // Stopped meanwhile, which is no failure.
        if (mine !== turn) return;
        stop();
        throw error;
      }
    },
    stop,
  };
}
