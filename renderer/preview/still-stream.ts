import type { CameraStream } from '../../export/runtime/sessions/camera/camera-stream.ts';

/** A still image as a camera stream. `start` rejects if the file is not an image. */
export function createStillStream(document: Document, file: Blob): CameraStream {
  const video = document.createElement('video');
  video.muted = true;
  video.playsInline = true;
  let stream: MediaStream | null = null;
  const stop = () => {
    for (const track of stream?.getTracks() ?? []) track.stop();
    stream = null;
    video.srcObject = null;
  };
  return {
    video,
    start: async () => {
      stop();
      const image = await createImageBitmap(file);
      const canvas = document.createElement('canvas');
      canvas.width = image.width;
      canvas.height = image.height;
      const context = canvas.getContext('2d');
      stream = canvas.captureStream();
      video.srcObject = stream;
      // A canvas stream has no frame until something is drawn after it started.
      context?.drawImage(image, 0, 0);
      image.close();
      await video.play();
    },
    stop,
  };
}
