import type { StitchedPanorama } from './panorama/stitch.ts';

/** A panorama of the room that the visitor has taken (`source/panorama-capture`), in this visit or an earlier one. */
export interface TakenPanorama {
  /** Display-referred sRGB, rows from the top. Alpha is 0 where a hole was filled. */
  readonly pixels: Pick<StitchedPanorama, 'widthPx' | 'heightPx' | 'channels' | 'data'>;
  /**
   * Where the panorama was taken, in the world space of this session: column-major 4×4, rigid and upright. The node or the page finds the
   * place again, writes this matrix and sets `located`.
   */
  readonly worldFromPanorama: Float32Array;
  /** Whether `worldFromPanorama` is known in this session; until then it is that of the session in which the panorama was taken. */
  located: boolean;
  /** True if the panorama was taken in this session, so that the device may be asked to keep an anchor for it. */
  isNew: boolean;
}

/** Name of the anchor that the device keeps for the panorama of a page. */
export const PANORAMA_ANCHOR = 'scrim-panorama';
