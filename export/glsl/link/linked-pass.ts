import type { BuiltinUniform, LinkedShader, PassUniform, TargetFormat } from '../../program/program.ts';
import type { NamedSize } from '../isf/isf-shader.ts';

/**
 * One full-screen draw of a linked shader, with inputs, params and buffers by name: the compiler puts resources and slots in
 * their place and has a `PassOperation`.
 */
export interface LinkedPass {
  readonly shader: LinkedShader;
  /** ISF `PASSINDEX`. Passes that nothing can see are left out, so the numbers may have gaps. */
  readonly passIndex: number;
  /** What is drawn into. Size and format are the target's. */
  readonly target: PassTarget;
  readonly samplers: readonly LinkedSampler[];
  readonly uniforms: readonly LinkedUniform[];
}

export type PassTarget =
  /** The node's layer, of the size of its first layer input, or of the view where it has none. */
  | { readonly kind: 'output'; readonly format: TargetFormat }
  /** A buffer of the node's own; several passes may draw into one. Persistent ones exist per view. */
  | {
      readonly kind: 'buffer';
      readonly name: string;
      readonly format: TargetFormat;
      readonly persistent: boolean;
      /** Null for the node's size. `$WIDTH` and `$HEIGHT` in them are the node's. */
      readonly width: NamedSize | null;
      readonly height: NamedSize | null;
    };

export interface LinkedSampler {
  /** Uniform name in the shader: `PassSampler.name`. */
  readonly name: string;
  readonly source: /** Color of the layer at input port `input`. */
    | { readonly kind: 'input'; readonly input: string }
    /** Depth of that layer. */
    | { readonly kind: 'input-depth'; readonly input: string }
    /** Room depth at input port `input`. */
    | { readonly kind: 'room-depth'; readonly input: string }
    /** What was heard last at the sound input `input`, as a picture: one row per channel. */
    | ({ readonly kind: 'sound'; readonly input: string } & LinkedSound)
    /** Heights of the curve that is the param `param`, as `export/program/curve-table.ts` says. */
    | { readonly kind: 'curve'; readonly param: string }
    /** A picture of the shader's own, `IMPORTED` under this name. */
    | { readonly kind: 'import'; readonly import: string }
    /** Buffer `target` of this node: this frame's picture if an earlier pass has drawn it, else the last frame's. */
    | { readonly kind: 'buffer'; readonly target: string };
}

export interface LinkedSound {
  readonly analysis: 'waveform' | 'spectrum';
  /** How many samples or bins the picture is wide. */
  readonly count: number;
}

export interface LinkedUniform {
  /** Uniform name in the shader: `PassUniform.name`. */
  readonly name: string;
  readonly type: PassUniform['type'];
  readonly source:
    | { readonly param: string }
    /** Whether there is a pulse at this input in this frame. */
    | { readonly event: string }
    | { readonly builtin: BuiltinUniform };
}

export interface LinkOptions {
  /** Node that the text belongs to, for source maps and diagnostics. */
  readonly node: string;
  /**
   * For previews and checks: bound every invocation's loops (`export/program/loop-budget.ts`), and print so that it is clear which
   * token a driver quotes.
   */
  readonly loopBudget?: boolean;
  /** Optional image, depth and sound inputs without a wire: reads give transparent black, 0 and silence. */
  readonly absent?: readonly string[];
  /** The text is what stands above a mistake (`linkAbove`): functions may have their bodies below. */
  readonly partial?: boolean;
  /** Image inputs whose layer has no depth: `LAYER_DEPTH` gives 0. */
  readonly withoutDepth?: readonly string[];
}
