import type { Pinhole } from '../../../nodes/kit/capture.ts';
import type { Lens } from '../../captures/lens.ts';
import type { Photo } from '../../captures/undistort.ts';

/** Work on the file of a photograph: JPEG, PNG or AVIF. */
export type PhotoTask =
  /** Draws it as a pinhole camera sees it, if a lens is given; an AVIF file. */
  | { readonly kind: 'pack'; readonly file: Uint8Array; readonly lens: Lens | null; readonly pinhole: Pinhole }
  /** Reduces it to 640 pixels; an AVIF file. */
  | { readonly kind: 'reduce'; readonly file: Uint8Array }
  | { readonly kind: 'decode'; readonly file: Uint8Array };

export interface PhotoResults {
  readonly pack: Uint8Array;
  readonly reduce: Uint8Array;
  readonly decode: Photo;
}

/** The reason of a failure is the end of a sentence about the photograph. */
export type PhotoAnswer =
  | { readonly ok: true; readonly result: PhotoResults[keyof PhotoResults] }
  | { readonly ok: false; readonly reason: string };
