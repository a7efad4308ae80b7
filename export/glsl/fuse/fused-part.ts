import type { PassParts } from '../link/link-parts.ts';

/** A pass to fuse. */
export interface FusedPart {
  readonly node: string;
  readonly parts: PassParts;
  /**
   * Sampler → index of the earlier pass that draws its layer. The fused shader reads the layer from a variable; if the pass reads the layer
   * at other pixels (`ImagePart.isHere`), it computes it there, with the earlier passes that only this layer depends on.
   */
  readonly from: ReadonlyMap<string, number>;
  /** Samplers of textures whose alpha is 0 or 1 in each pixel, and whose color is 0 where alpha is. */
  readonly hardEdged: ReadonlySet<string>;
  /** Samplers of textures that cover what is drawn, as targets do: positions on both are equal. */
  readonly aligned: ReadonlySet<string>;
  /** Samplers of the layer of the objects in whose materials the pass is computed (`materialEffects`); absent in fused passes. */
  readonly drawn?: ReadonlySet<string>;
}
