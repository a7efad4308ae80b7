import type { ResourceId } from '../../../program/program.ts';

/** Why the passes at the two ends of a wire stay separate. `scrim plan --why` shows the texts. */
export const SEPARATE_REASONS = {
  objects: 'what is drawn into it has no materials of its own objects, or a worker computes it',
  samples: 'objects are drawn into it with several samples per pixel, and the reader needs their mean',
  transparent: 'objects that are drawn into it may be transparent, or fade at a soft border of the room',
  background: 'the reader may color pixels without objects',
  position: 'the reader depends on the position in the image, and objects are drawn into it',
  textures: 'the reader reads other images too, and objects are drawn into it',
  viewed: 'the editor shows it',
  switched: 'fusion is turned off for one of the two nodes',
  kept: 'its content is kept for the next frame',
  vertex: 'one of the two has a vertex shader of its own',
  loops: 'the preview limits the loops of one of the two',
  depth: 'the reader computes depth',
  unstable: 'the reader turns differences in rounding between devices into large steps',
  elsewhere: 'the reader reads other pixels than the current one',
  moved: 'the reader reads another pixel, and the writer may compute another color for it than its own pass',
  fitted: 'the reader fits an image to the view',
  size: 'the two have different sizes',
  readers: 'several passes read it, and one of them needs the texture',
  cost: 'it is read several times, and to compute it each time costs more than a texture',
  neighborhoods: 'the fused shader would read neighboring pixels in two steps',
  limits: 'the fused shader would exceed a limit of WebGL 2',
  memory: 'the layers that the fused shader reads would need more memory at the same time',
  order: 'what the writer reads changes before the reader runs',
} as const;

export type SeparateReason = keyof typeof SEPARATE_REASONS;

/** A layer that one pass draws and another reads as a texture, although both are passes. */
export interface SeparateWire {
  readonly resource: ResourceId;
  /** Ids of the operations. */
  readonly writer: string;
  readonly reader: string;
  /** The node of the reader. */
  readonly node: string;
  readonly reason: SeparateReason;
}
