import type { Locator } from 'playwright-core';
import { type Direction, uprightPose } from '../../nodes/kit/panorama/capture-targets.ts';
import type { PanoramaPixels } from '../../nodes/kit/panorama/pixels.ts';
import type { XrPage } from '../xr/xr-page.ts';

/** A place in world space, meters. */
export type Place = readonly [x: number, y: number, z: number];

/** At four frames per second: a photo takes 0.4 s after the camera has stopped. */
const FRAMES_PER_PHOTO = 3;

/** The head at a place, upright, looking in a direction. */
export function poseFrom(eye: Place, direction: Direction): { readonly matrix: number[] } {
  const pose = uprightPose(direction);
  pose.set(eye, 12);
  return { matrix: [...pose] };
}

/** Looks at the targets one after the other, each as long as a photo takes at four frames per second. */
export async function takePhotos(xr: XrPage, eye: Place, targets: readonly Direction[]): Promise<void> {
  for (const target of targets) {
    await xr.setPose(poseFrom(eye, target));
    await xr.step(FRAMES_PER_PHOTO);
  }
}

/** The bar that the page shows while it takes a panorama. */
export const barOf = (xr: XrPage): Locator => xr.page.getByRole('region', { name: 'Panorama' });

/** Draws frames until the panorama is used: frames go on while a worker stitches, but few, because they take its time. */
export async function untilReady(xr: XrPage): Promise<void> {
  const ready = barOf(xr).getByText('The light is that of your room');
  while (!(await ready.isVisible())) {
    await xr.step(1);
    await xr.page.waitForTimeout(BETWEEN_FRAMES_MS);
  }
}

const BETWEEN_FRAMES_MS = 250;

/** The panorama that the page has kept on the device. */
export async function storedPanorama(xr: XrPage): Promise<PanoramaPixels & { readonly data: Uint8Array }> {
  const { widthPx, heightPx, base64 } = await xr.page.evaluate(async () => {
    const database = await new Promise<IDBDatabase>((done, fail) => {
      const request = indexedDB.open('scrim-panoramas');
      request.onsuccess = () => done(request.result);
      request.onerror = () => fail(request.error);
    });
    const found = await new Promise<{ widthPx: number; heightPx: number; data: Uint8ClampedArray }>((done) => {
      const request = database.transaction('panoramas').objectStore('panoramas').get(location.pathname);
      request.onsuccess = () => done(request.result);
    });
    let text = '';
    for (let i = 0; i < found.data.length; i += 8192) text += String.fromCharCode(...found.data.subarray(i, i + 8192));
    return { widthPx: found.widthPx, heightPx: found.heightPx, base64: btoa(text) };
  });
  return { widthPx, heightPx, channels: 4, data: new Uint8Array(Buffer.from(base64, 'base64')) };
}

/** The direction from a place to the lamp of the studio, which is where a direction from the middle of the room meets something. */
export async function lampFrom(xr: XrPage, eye: Place, direction: Direction): Promise<Direction> {
  const middle = [0, 1.2, 0] as const;
  const far = await xr.measure(middle, direction);
  if (far === null) throw new Error('The lamp is on a wall.');
  const way = direction.map((part, i) => (middle[i] ?? 0) + part * far - (eye[i] ?? 0));
  const length = Math.hypot(...way);
  return [(way[0] ?? 0) / length, (way[1] ?? 0) / length, (way[2] ?? 0) / length];
}

/** The angle between unit vectors, degrees. */
export function angleDeg([x, y, z]: Direction, [a, b, c]: Direction): number {
  return (Math.acos(Math.min(1, x * a + y * b + z * c)) * 180) / Math.PI;
}
