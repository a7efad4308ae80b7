import type { NodeDefinition } from '../../../nodes/kit/definition.ts';
import type { TechniquePass } from '../../program/program.ts';
import type { IsfInput } from '../isf/isf-shader.ts';
import { isTransition } from '../transition/is-transition.ts';

/** The header of a technique file. `linkTechnique` reads the GLSL below it. */
export interface TechniqueShader {
  /** Name in the library or project: `techniques/gooch.glsl`. */
  readonly file: string;
  /** The whole text with the header, so that line numbers are the author's. */
  readonly source: string;
  readonly title: string | null;
  readonly description: string;
  readonly credit: string;
  readonly licence: string;
  readonly categories: readonly string[];
  /** Numbers, toggles, choices, points, colors and images. */
  readonly inputs: readonly IsfInput[];
  /** Names of the images that are read by UV; the others are layers aligned with the view. */
  readonly pictures: readonly string[];
  /** Images of the library that its text reads by name: `pictures/light-strokes.png`. */
  readonly imported: readonly { readonly name: string; readonly path: string; readonly line: number; readonly column: number }[];
  /** At least one. */
  readonly passes: readonly TechniquePass[];
  /** `SCRIM_UNREAD`: values of an input with which its text does not read `s.along` or `s.radial`. */
  readonly unread: readonly { readonly name: 'along' | 'radial'; readonly input: string; readonly values: readonly number[] }[];
  /** `SCRIM_RENAMED`: names of inputs in earlier versions. */
  readonly renamed: NonNullable<NodeDefinition['renamed']>;
}

/** Whether the file is a technique: by its extension, and by its content, because transitions have the same extension. */
export function isTechnique(source: string, file: string): boolean {
  return file.endsWith('.glsl') && !isTransition(source, file);
}
