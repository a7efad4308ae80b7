import { z } from 'zod';
import { diagnostic, documentText, projectFiles } from './call-parts.ts';

/** Name of the folder of a recipe: letters and digits of all scripts, with single hyphens between them. */
const recipeName = z
  .string()
  .max(128)
  .regex(/^[\p{L}\p{N}]+(?:-[\p{L}\p{N}]+)*$/u);

/** The recipes that a person has saved: projects in the folder `recipes` of the projects folder. */
export const RECIPE_CALLS = {
  /** Lists them by name. Those that cannot be read have no `files`, and a `problem` that says why. */
  'recipe.list': {
    input: z.object({}),
    output: z.array(
      z.object({
        /** Name of its folder. */
        name: z.string(),
        path: z.string(),
        files: projectFiles.nullable(),
        problem: diagnostic.nullable(),
      }),
    ),
  },
  /** Saves one into a new folder. Rejects with SCR061 if there is one of this name. */
  'recipe.save': {
    input: z.object({ name: recipeName, files: z.object({ project: documentText, layout: documentText }) }),
    output: z.object({ path: z.string() }),
  },
  /** Moves the folder of one to `.removed` beside it. `name`: as in the list. */
  'recipe.remove': { input: z.object({ name: z.string().min(1).max(255) }), output: z.object({ kept: z.string() }) },
} as const;
