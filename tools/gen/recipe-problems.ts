import { readRecipe } from '../../export/graph/read-recipe.ts';
import { formatDiagnostic } from '../../nodes/kit/diagnostics.ts';
import type { RecipeFolder } from './find-nodes.ts';

/** Problems of the recipes as text, each with its folder. */
export function recipeProblems(recipes: readonly RecipeFolder[]): readonly string[] {
  return recipes.flatMap(({ name, project, layout }) =>
    readRecipe({ project, layout, sources: {} }).diagnostics.map(
      (diagnostic) => `shader-library/recipes/${name}: ${formatDiagnostic(diagnostic)}`,
    ),
  );
}
