import { FILTERS } from './filters.ts';
import type { Recipe } from './recipe.ts';
import { SCENES } from './scenes.ts';

/** All examples after figures of the mixed-reality paper. */
export const RECIPES: readonly Recipe[] = [...SCENES, ...FILTERS];
