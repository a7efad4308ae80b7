import type { BuiltinUniform, TargetFormat } from '../../program/program.ts';
import type { ImageReads } from '../access/find-access.ts';
import type { Image, ImageUse, Reading } from './images.ts';
import type { MappedLines } from './line-writer.ts';
import type { LinkedPass, LinkedUniform } from './linked-pass.ts';
import type { Output } from './prelude.ts';

/** A linked pass with the parts of its shader. */
export interface PartedPass extends LinkedPass {
  readonly parts: PassParts | WhyNotFused;
}

/** Why a pass cannot be fused: it has an author's vertex shader, its loops are bounded for the preview, or it computes depth. */
export type WhyNotFused = 'vertex' | 'loops' | 'depth';

/** The parts of a fragment shader, of which `fusePasses` composes one shader for several passes. */
export interface PassParts {
  readonly file: string;
  readonly passIndex: number;
  readonly builtins: readonly BuiltinUniform[];
  /** Uniforms of params. */
  readonly params: readonly Pick<LinkedUniform, 'name' | 'type'>[];
  readonly images: readonly ImagePart[];
  /** Whether the author's text calls `scrim_project`. */
  readonly projects: boolean;
  readonly usesFragCoord: boolean;
  readonly discards: boolean;
  /** The author's functions and variables. */
  readonly functions: MappedLines;
  /** The statements of `main` that compute `scrim_fragColor`. */
  readonly body: MappedLines;
  readonly output: Output;
  /** The sampler of the layer whose alpha at the current pixel the pass outputs; null if there is none. */
  readonly keptAlpha: string | null;
  /** Whether the text gives each pixel an alpha of 1. */
  readonly isOpaque: boolean;
  readonly format: TargetFormat;
  /**
   * Whether the pass computes the same color when another pixel's invocation computes it: it computes no derivatives, changes no
   * variables that keep their values, and uses its normalized position, of which the rasterizer leaves the last bits open, only to read there.
   */
  readonly moves: boolean;
  /** Estimated arithmetic operations per pixel, without reads of images (`countOperations`). */
  readonly operations: number;
}

/** An image that a pass reads. */
export interface ImagePart {
  readonly image: Image;
  readonly uses: ReadonlySet<ImageUse>;
  readonly reading: Reading;
  /** Whether the pass reads at most the current pixel of it. */
  readonly isHere: boolean;
  /** The pixels that the pass reads of it; infinitely many if unclear. */
  readonly reads: ImageReads;
}
