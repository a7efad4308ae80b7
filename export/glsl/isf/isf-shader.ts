import type { NodeDefinition, Unit } from '../../../nodes/kit/definition.ts';
import type { ImageHandle } from '../../../nodes/kit/handles.ts';
import type { SizeToken } from '../../program/program.ts';

/**
 * The header of an ISF file (spec: github.com/mrRay/ISF_Spec, “The ISF Specification”). The GLSL below it is read by `linkIsf` and
 * `isfDefinition`.
 */
export interface IsfShader {
  /** Name in the library or project: `filters/sepia.fs`. */
  readonly file: string;
  /** The whole text with the header, so that line numbers are the author's. */
  readonly source: string;
  /** The vertex shader of the file, `edge.vs` of `edge.fs`, which sets its varyings. */
  readonly vertex: VertexFile | null;
  /** `transition`: a gl-transitions file, which has `vec4 transition(vec2 uv)` instead of `main`; see `transition/`. */
  readonly dialect: 'isf' | 'transition';
  /** 1 without `ISFVSN`. */
  readonly version: 1 | 2;
  /** `operator` has two or more images, `filter` one, `generator` none. */
  readonly kind: 'filter' | 'operator' | 'generator';
  readonly title: string | null;
  readonly description: string;
  readonly credit: string;
  /** `LICENSE`: the license of the file; empty if there is none. */
  readonly licence: string;
  readonly categories: readonly string[];
  readonly inputs: readonly IsfInput[];
  /** At least one; the last draws the output. */
  readonly passes: readonly IsfPass[];
  readonly imported: readonly IsfImport[];
  /** `SCRIM_ALPHA`: images are read and written as they are stored, premultiplied. */
  readonly premultiplied: boolean;
  /**
   * `SCRIM_OPAQUE`: images; where they and the colors have no transparency, the output has none. Empty: unclear. It may be wrong in shaders
   * of projects.
   */
  readonly opaqueImages: readonly string[];
  /** `SCRIM_DEPTH`: depth of the output; `auto` depends on the access. */
  readonly depth: 'auto' | 'same' | 'none' | 'over' | 'nearer';
  /**
   * `SCRIM_ENCODING`: encoding of the layers that the shader reads and outputs; `either`: the shader accepts both encodings, and its output
   * has that of its inputs.
   */
  readonly encoding: (typeof SHADER_ENCODINGS)[number];
  /**
   * Whether the shader reads scene layers (`readsScene`) and outputs one (`writesScene`). For the encoding `either`, both are false here
   * and true in its `sceneVariant`.
   */
  readonly readsScene: boolean;
  readonly writesScene: boolean;
  /** `SCRIM_FIT`: default for fitting images of another size to the view. */
  readonly fit: 'cover' | 'contain' | 'stretch';
  /** `SCRIM_RENAMED`: names of inputs in earlier versions. */
  readonly renamed: NonNullable<NodeDefinition['renamed']>;
}

/** Words of `SCRIM_ENCODING`; the first is the default. */
export const SHADER_ENCODINGS = ['display', 'scene', 'either', 'scene to display', 'display to scene'] as const;

const sceneVariants = new WeakMap<IsfShader, IsfShader>();

/** Returns the variant of an `either` shader that reads and writes scene layers; the macro `SCRIM_SCENE` is defined in it. */
export function sceneVariant(shader: IsfShader): IsfShader {
  const known = sceneVariants.get(shader) ?? { ...shader, readsScene: true, writesScene: true };
  sceneVariants.set(shader, known);
  return known;
}

export interface VertexFile {
  /** Name in the library or project: `filters/edge.vs`. */
  readonly file: string;
  readonly source: string;
}

/** `vector3` and `vector4` occur in transitions only. */
export type IsfInputType =
  | 'event'
  | 'bool'
  | 'long'
  | 'float'
  | 'point2D'
  | 'color'
  | 'image'
  | 'audio'
  | 'audioFFT'
  | 'depth'
  | 'curve'
  | 'gradient'
  | 'vector3'
  | 'vector4';

export interface IsfInput {
  readonly name: string;
  readonly type: IsfInputType;
  readonly label: string;
  readonly doc: string;
  /**
   * One number for `bool` (0 or 1), `long` and `float`; two for `point2D`; four for `color`; the points of a `curve`, the stops of a `gradient`; empty for other
   * types.
   */
  readonly default: readonly number[];
  readonly min: readonly number[] | null;
  readonly max: readonly number[] | null;
  /** Value with which the filter changes nothing. */
  readonly identity: readonly number[] | null;
  /** Choices of a `long`. */
  readonly choices: readonly { readonly value: number; readonly label: string }[];
  readonly unit: Unit;
  readonly step: number | null;
  /** `HANDLE`: the part of the gizmo in the preview that changes a `float` or a `point2D`, or null. */
  readonly handle: ImageHandle | null;
  /** For sound: number of samples or bins (`MAX`), or null. */
  readonly sampleCount: number | null;
  /** Whether images and depth may stay unconnected; reads then give transparent black and 0. */
  readonly optional: boolean;
  /** `WRAP`: whether the image repeats; otherwise its edge is extended. */
  readonly repeat: boolean;
  /** Position of the name in the header, from 1. */
  readonly line: number;
  readonly column: number;
}

export interface IsfPass {
  /** Buffer that the pass draws to; null for the node's output. */
  readonly target: string | null;
  readonly persistent: boolean;
  /** Whether the target stores floats: 32 bits per channel, as ISF specifies, or 16 with SCRIM_HALF (`half`). */
  readonly float: boolean;
  readonly half: boolean;
  /** Null for the size of the layer. */
  readonly width: NamedSize | null;
  readonly height: NamedSize | null;
}

/** A size expression of a program (postfix), with inputs by name instead of slots. */
export type NamedSize = readonly (number | Extract<SizeToken, { op: string }> | { readonly param: string })[];

export interface IsfImport {
  readonly name: string;
  /** As written: one file, or the six faces of a cube. */
  readonly paths: readonly string[];
  readonly cube: boolean;
  readonly line: number;
  readonly column: number;
}

export function findInput(shader: IsfShader, name: string): IsfInput | undefined {
  return shader.inputs.find((input) => input.name === name);
}

/** Inputs that are layers, in order. */
export function imageInputs(shader: IsfShader): readonly IsfInput[] {
  return shader.inputs.filter((input) => input.type === 'image');
}
