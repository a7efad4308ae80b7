import type { TableType } from '../../../nodes/kit/wire-types.ts';
import type { BuiltinUniform, LinkedShader, PassUniform, TargetFormat } from '../../program/program.ts';
import type { NamedSize } from '../isf/isf-shader.ts';

/**
 * One full-screen draw of a linked shader, with inputs, params and buffers by name. The compiler replaces them by resources and slots,
 * which gives a `PassOperation`.
 */
export interface LinkedPass {
  readonly shader: LinkedShader;
  /** ISF `PASSINDEX`. Passes without effect are left out, so the numbers may have gaps. */
  readonly passIndex: number;
  /** Target of the pass with its size and format. */
  readonly target: PassTarget;
  readonly samplers: readonly LinkedSampler[];
  readonly uniforms: readonly LinkedUniform[];
}

export type PassTarget =
  /** The node's layer, with the size of its first layer input, or of the view. */
  | { readonly kind: 'output'; readonly format: TargetFormat }
  /** A buffer of the node; several passes may draw to one. Persistent ones exist per view. */
  | {
      readonly kind: 'buffer';
      readonly name: string;
      readonly format: TargetFormat;
      readonly persistent: boolean;
      /** Null for the node's size, to which `$WIDTH` and `$HEIGHT` refer. */
      readonly width: NamedSize | null;
      readonly height: NamedSize | null;
    };

export interface LinkedSampler {
  /** Uniform name in the shader: `PassSampler.name`. */
  readonly name: string;
  readonly source: /** Color of the layer at input port `input`. */
    | { readonly kind: 'input'; readonly input: string }
    /** Depth of the layer at port `input`. */
    | { readonly kind: 'input-depth'; readonly input: string }
    /** Room depth at input port `input`. */
    | { readonly kind: 'room-depth'; readonly input: string }
    /** The most recent sound of the input `input` as a texture with one row per channel. */
    | ({ readonly kind: 'sound'; readonly input: string } & LinkedSound)
    /** Heights of the curve or colors of the gradient in param `param`, see `export/program/texture-sizes.ts`. */
    | { readonly kind: 'table'; readonly of: TableType; readonly param: string }
    /** An image that the shader imports under this name. */
    | { readonly kind: 'import'; readonly import: string }
    /** Buffer `target` of this node: drawn in this frame by an earlier pass, else in the previous frame. */
    | { readonly kind: 'buffer'; readonly target: string };
}

export interface LinkedSound {
  readonly analysis: 'waveform' | 'spectrum';
  /** Width of the texture: number of samples or bins. */
  readonly count: number;
}

export interface LinkedUniform {
  /** Uniform name in the shader: `PassUniform.name`. */
  readonly name: string;
  readonly type: PassUniform['type'];
  readonly source:
    | { readonly param: string }
    /** Whether the input has a pulse in this frame. */
    | { readonly event: string }
    | { readonly builtin: BuiltinUniform };
}

export interface LinkOptions {
  /** Node of the text, for source maps and diagnostics. */
  readonly node: string;
  /**
   * For previews and checks: limits the loops of every invocation (`export/program/loop-budget.ts`), and prints the text so that the token
   * that a driver quotes occurs once per line.
   */
  readonly loopBudget?: boolean;
  /** Unconnected optional inputs of images, depth and sound: reads give transparent black, 0 and silence. */
  readonly absent?: readonly string[];
  /** Whether the text ends above a mistake (`linkAbove`), so that functions may lack their bodies. */
  readonly partial?: boolean;
  /** Image inputs whose layer has no depth; `LAYER_DEPTH` gives 0. */
  readonly withoutDepth?: readonly string[];
}
