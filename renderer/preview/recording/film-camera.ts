import type { FilmCamera } from '../../../export/emulator/rooms/room-film.ts';
import { setCoverCrop } from '../../../export/runtime/sessions/recorded/camera-crop.ts';
import { colorPath, type Film } from './film.ts';

/** Takes the images of a camera while they are seen: the part of them that the view shows. */
export function filmCameraImages(video: HTMLVideoElement): Film {
  const jpegs: Promise<Blob>[] = [];
  const crop = { x0: 0, y0: 0, x1: 0, y1: 0 };
  let image: CanvasImage | null = null;
  return {
    take: ({ cameraImage }, camera) => {
      if (!cameraImage) return false;
      image ??= createImage(camera);
      setCoverCrop(crop, video.videoWidth, video.videoHeight, camera.widthPx, camera.heightPx);
      const [widthPx, heightPx] = [crop.x1 - crop.x0, crop.y1 - crop.y0];
      image.context.drawImage(video, crop.x0, crop.y0, widthPx, heightPx, 0, 0, camera.widthPx, camera.heightPx);
      jpegs.push(encodeImage(image, camera));
      return true;
    },
    make: async (frames, _camera, files) => {
      const paths = frames.map((_, i) => ({ color: colorPath(i) }));
      for (const [i, jpeg] of (await Promise.all(jpegs)).entries()) files.add(colorPath(i), await bytesOf(jpeg));
      return { paths, head: {} };
    },
  };
}

/** Sessions without a background have no images: all frames share a black one. */
export function filmNothing(): Film {
  return {
    take: () => true,
    make: async (frames, camera, files) => {
      const color = colorPath(0);
      files.add(color, await bytesOf(await encodeImage(createImage(camera), camera)));
      return { paths: frames.map(() => ({ color })), head: {} };
    },
  };
}

interface CanvasImage {
  readonly canvas: OffscreenCanvas;
  readonly context: OffscreenCanvasRenderingContext2D;
}

function createImage({ widthPx, heightPx }: FilmCamera): CanvasImage {
  const canvas = new OffscreenCanvas(widthPx, heightPx);
  const context = canvas.getContext('2d', { alpha: false });
  if (!context) throw new Error('this browser draws no pictures.');
  return { canvas, context };
}

/** The image as it is now; the canvas can be drawn to at once. */
function encodeImage({ canvas }: CanvasImage, { jpegQuality }: FilmCamera): Promise<Blob> {
  return canvas.convertToBlob({ type: 'image/jpeg', quality: jpegQuality });
}

async function bytesOf(blob: Blob): Promise<Uint8Array> {
  return new Uint8Array(await blob.arrayBuffer());
}
