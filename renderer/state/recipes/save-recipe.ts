import { EMPTY_GRAPH } from '../../../export/graph/new-project.ts';
import type { ExposedPorts, Project } from '../../../export/graph/project.ts';
import { RECIPE_GRAPH } from '../../../export/graph/read-recipe.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { saveProject } from '../../../export/graph/save.ts';
import type { Editor } from '../editor/editor.ts';
import type { OwnRecipe, RecipeState } from '../editor/recipe-state.ts';
import { addToast, clearDialogErrors } from '../editor/ui.ts';
import { showRefusal } from '../files/files.ts';
import { fileName } from '../files/suggest-folder.ts';
import { listRecipes } from './list-recipes.ts';

/** What a recipe adds, as a description of it. */
export function describeRecipe({ libraries }: Editor, { graphs }: Project): string {
  const types = Object.values(graphs[RECIPE_GRAPH]?.nodes ?? {}).map(({ type }) => type);
  const titles = [...new Set(types.map((type) => libraries.base.definition(type)?.title ?? type))].sort();
  return `Adds ${[titles.slice(0, -1).join(', '), titles.at(-1)].filter(Boolean).join(' and ')}.`;
}

/** The labels of its ports. */
export function portsOfRecipe({ libraries }: Editor, { graphs }: Project, side: keyof ExposedPorts): string {
  const { nodes, exposed } = graphs[RECIPE_GRAPH] ?? EMPTY_GRAPH;
  const labels = exposed[side].map(({ name, node, port }) => {
    const definition = libraries.base.definition(nodes[node]?.type ?? '');
    const ports: Readonly<Record<string, { readonly label: string }>> = { ...definition?.params, ...definition?.[side] };
    return getOwn(ports, port)?.label ?? name;
  });
  return labels.length === 0 ? 'none' : labels.join(', ');
}

/** Why a new recipe cannot have a title; null if it can. */
export function recipeTitleProblem({ own, broken }: RecipeState, title: string): string | null {
  if (title.trim() === '') return 'The recipe needs a name.';
  return [...own, ...broken].some(({ name }) => name === fileName(title)) ? 'There already is a recipe of this name.' : null;
}

/** Saves a recipe into the person’s library. Errors stand in the dialog. */
export async function saveRecipe(
  editor: Editor,
  project: Project,
  { title, description, keywords }: { readonly title: string; readonly description: string; readonly keywords: readonly string[] },
): Promise<boolean> {
  clearDialogErrors(editor.ui);
  try {
    const { project: text, layout } = saveProject({ ...project, title, page: { ...project.page, description }, recipe: { keywords } });
    const { path } = await editor.host.call('recipe.save', { name: fileName(title), files: { project: text, layout } });
    await listRecipes(editor);
    addToast(editor.ui, { tone: 'success', text: `Saved the recipe “${title}”. The node search finds it.`, detail: path });
    return true;
  } catch (error) {
    showRefusal(editor, error);
    return false;
  }
}

/** Moves a recipe out of the library. Nodes that were added by it stay. */
export async function removeRecipe(editor: Editor, { name, path }: Pick<OwnRecipe, 'name' | 'path'>): Promise<void> {
  if (editor.document.getState().open?.displayPath === path) {
    addToast(editor.ui, { tone: 'error', text: 'This recipe is open. Open another project first.' });
    return;
  }
  try {
    const { kept } = await editor.host.call('recipe.remove', { name });
    await listRecipes(editor);
    addToast(editor.ui, { tone: 'info', text: `Deleted the recipe “${name}”.`, detail: `Its files were moved to ${kept}.` });
  } catch (error) {
    showRefusal(editor, error);
  }
}
