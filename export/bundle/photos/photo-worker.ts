import { parentPort, workerData } from 'node:worker_threads';
import { type Photo, resample } from '../../captures/undistort.ts';
import { createAvifCodec } from './avif.ts';
import { decodePhoto } from './decode-photo.ts';
import { createJpegDecoder } from './jpeg.ts';
import type { PhotoAnswer, PhotoResults, PhotoTask } from './photo-task.ts';
import { reducePhoto } from './reduce-photo.ts';

/* Entry of the worker threads for photographs. `workerData` is the folder with Scrim's sources and `node_modules`. */

/** PSNR and SSIM of photographs are those of JPEG files of quality 92 and 75, or better. */
const QUALITY = { pack: 82, reduce: 65 } as const;

const avif = createAvifCodec(String(workerData));
const jpeg = createJpegDecoder(String(workerData));

parentPort?.on('message', (task: PhotoTask) => {
  void answer(task).then((reply) => parentPort?.postMessage(reply));
});

async function answer(task: PhotoTask): Promise<PhotoAnswer> {
  try {
    return { ok: true, result: await resultOf(task) };
  } catch (error) {
    return { ok: false, reason: error instanceof Error ? error.message : String(error) };
  }
}

async function resultOf(task: PhotoTask): Promise<PhotoResults[PhotoTask['kind']]> {
  const photo = await decodePhoto(task.file, jpeg, avif);
  if (task.kind === 'decode') return photo;
  return avif.encode(task.kind === 'reduce' ? reducePhoto(photo) : packed(photo, task), QUALITY[task.kind]);
}

function packed(photo: Photo, { lens, pinhole }: PhotoTask & { readonly kind: 'pack' }): Photo {
  return lens ? resample(photo, lens, pinhole) : photo;
}
