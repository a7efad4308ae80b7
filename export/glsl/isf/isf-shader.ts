import type { NodeDefinition, Unit } from '../../../nodes/kit/definition.ts';
import type { SizeToken } from '../../program/program.ts';

/**
 * An ISF file as its header describes it (spec: github.com/mrRay/ISF_Spec, "The ISF Specification"). The GLSL below the
 * header is not read yet: `linkIsf` and `isfDefinition` do that.
 */
export interface IsfShader {
  /** Name in the library or project: `filters/sepia.fs`. */
  readonly file: string;
  /** The whole text, header included, so that lines count as the author sees them. */
  readonly source: string;
  /** The vertex shader beside it, `edge.vs` of `edge.fs`: it sets what the fragment shader declares as `varying`. */
  readonly vertex: VertexFile | null;
  /** `transition`: a gl-transitions file, which has `vec4 transition(vec2 uv)` in the place of `main`; see `transition/`. */
  readonly dialect: 'isf' | 'transition';
  /** 1 where the header has no `ISFVSN`. */
  readonly version: 1 | 2;
  /** `operator` has two or more images, `filter` one, `generator` none. */
  readonly kind: 'filter' | 'operator' | 'generator';
  readonly title: string | null;
  readonly description: string;
  readonly credit: string;
  /** `LICENSE`: under which terms the file may be used; empty where it does not say. */
  readonly licence: string;
  readonly categories: readonly string[];
  readonly inputs: readonly IsfInput[];
  /** At least one; the last makes the output. */
  readonly passes: readonly IsfPass[];
  readonly imported: readonly IsfImport[];
  /** `SCRIM_ALPHA`: images are read and written as they are stored, premultiplied. */
  readonly premultiplied: boolean;
  /** `SCRIM_DEPTH`: what becomes of the first layer's depth; `auto` goes by the access. */
  readonly depth: 'auto' | 'same' | 'none' | 'over';
  /** `SCRIM_FIT`: how an operator lays pictures of another size onto the view, unless the node says otherwise. */
  readonly fit: 'cover' | 'contain' | 'stretch';
  /** `SCRIM_RENAMED`: what inputs were called in earlier versions. */
  readonly renamed: NonNullable<NodeDefinition['renamed']>;
}

export interface VertexFile {
  /** Name in the library or project: `filters/edge.vs`. */
  readonly file: string;
  readonly source: string;
}

/** `vector3` and `vector4` are no words of headers: only transitions have them. */
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
  | 'vector3'
  | 'vector4';

export interface IsfInput {
  readonly name: string;
  readonly type: IsfInputType;
  readonly label: string;
  readonly doc: string;
  /** One number for `bool` (0 or 1), `long` and `float`; two for `point2D`; four for `color`; a `curve`'s points; empty for all else. */
  readonly default: readonly number[];
  readonly min: readonly number[] | null;
  readonly max: readonly number[] | null;
  /** Value with which the filter changes nothing. */
  readonly identity: readonly number[] | null;
  /** Choices of a `long`. */
  readonly choices: readonly { readonly value: number; readonly label: string }[];
  readonly unit: Unit;
  readonly step: number | null;
  /** Of sound: how many samples or bins its picture is wide, if the header says (`MAX`). */
  readonly sampleCount: number | null;
  /** Images and depth: may be left without a wire; reads then give transparent black and 0. */
  readonly optional: boolean;
  /** `WRAP`: an image that repeats beyond its edges, where others continue with their edge. */
  readonly repeat: boolean;
  /** Of the name in the header, from 1. */
  readonly line: number;
  readonly column: number;
}

export interface IsfPass {
  /** Buffer that the pass draws into; null for the node's output. */
  readonly target: string | null;
  readonly persistent: boolean;
  /** 32 bits per channel, as ISF has it; 16 where the author says that those do (SCRIM_HALF). */
  readonly float: boolean;
  readonly half: boolean;
  /** Null for the layer's own. */
  readonly width: NamedSize | null;
  readonly height: NamedSize | null;
}

/** A program's size expression (postfix), with inputs by name where the program has slots. */
export type NamedSize = readonly (number | Extract<SizeToken, { op: string }> | { readonly param: string })[];

export interface IsfImport {
  readonly name: string;
  /** As written: one file, or the six of a cube. */
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
