import type { PanoramaShot } from './shot.ts';
import type { StitchedPanorama } from './stitch.ts';

/** The message to the worker. */
export interface StitchTask {
  readonly shots: readonly PanoramaShot[];
  readonly widthPx: number;
}

/** The message from the worker: some of them with the progress, the last with the panorama or what went wrong. */
export type StitchAnswer =
  | { readonly kind: 'progress'; readonly part: number }
  | { readonly kind: 'done'; readonly panorama: StitchedPanorama }
  | { readonly kind: 'failed'; readonly reason: string };
