import type { FoundLamps } from '../../../nodes/kit/panorama/found-lamps.ts';
import type { LampOptions } from '../../../nodes/kit/panorama/lamp-options.ts';

/** A panorama to search, as its file or as those of its shots. Ending the worker cancels the search. */
export interface LampRequest {
  readonly files: readonly ArrayBuffer[];
  /** Of shots: their difference in stops; 0 to measure it. */
  readonly stopsApart: number;
  readonly options: LampOptions;
}

/** A step of a search as an image. */
export interface LampStage {
  readonly kind: 'picture' | 'gray' | 'threshold' | 'median';
  /** Iteration of the search, from 0. The stage `picture` has 0. */
  readonly iteration: number;
  readonly image: ImageBitmap;
}

/**
 * Answers of the worker: its progress as fractions in [0, 1], then one result or one failure. The reason of a failure is text for users.
 */
export type LampAnswer =
  | { readonly kind: 'part'; readonly part: number }
  | { readonly kind: 'found'; readonly found: FoundLamps; readonly stages: readonly LampStage[] }
  | { readonly kind: 'failed'; readonly reason: string };
