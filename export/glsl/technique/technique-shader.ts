import type { NodeDefinition } from '../../../nodes/kit/definition.ts';
import type { TechniquePass } from '../../program/program.ts';
import type { IsfInput } from '../isf/isf-shader.ts';
import { isTransition } from '../transition/is-transition.ts';

/** A technique file as its header describes it. The GLSL below the header is not read yet: `linkTechnique` does that. */
export interface TechniqueShader {
  /** Name in the library or project: `techniques/gooch.glsl`. */
  readonly file: string;
  /** The whole text, header included, so that lines count as the author sees them. */
  readonly source: string;
  readonly title: string | null;
  readonly description: string;
  readonly credit: string;
  readonly licence: string;
  readonly categories: readonly string[];
  /** Numbers, toggles, choices, points, colors and images. */
  readonly inputs: readonly IsfInput[];
  /** Names of the images that are read by their own coordinates; the others are layers as the view shows them. */
  readonly pictures: readonly string[];
  /** Pictures of the library that its text reads by name: `pictures/light-strokes.png`. */
  readonly imported: readonly { readonly name: string; readonly path: string; readonly line: number; readonly column: number }[];
  /** At least one. */
  readonly passes: readonly TechniquePass[];
  /** `SCRIM_RENAMED`: what inputs were called in earlier versions. */
  readonly renamed: NonNullable<NodeDefinition['renamed']>;
}

/** Techniques are told from ISF files by their ending, and from transitions, which share it, by what they hold. */
export function isTechnique(source: string, file: string): boolean {
  return file.endsWith('.glsl') && !isTransition(source, file);
}
