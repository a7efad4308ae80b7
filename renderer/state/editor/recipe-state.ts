import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Project } from '../../../export/graph/project.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';

/** A recipe that the person has saved. */
export interface OwnRecipe {
  /** Name of its folder. */
  readonly name: string;
  readonly path: string;
  readonly project: Project;
}

/** A folder of recipes that the palette cannot use. */
export interface BrokenRecipe {
  readonly name: string;
  readonly path: string;
  readonly diagnostic: Diagnostic;
}

/** The person’s library of recipes, as it was listed last. */
export interface RecipeState {
  readonly own: readonly OwnRecipe[];
  readonly broken: readonly BrokenRecipe[];
  /** What the host listed, to notice changes. */
  readonly text: string;
}

export type RecipeStore = StoreApi<RecipeState>;

export function createRecipeState(): RecipeStore {
  return createStore<RecipeState>(() => ({ own: [], broken: [], text: '[]' }));
}
