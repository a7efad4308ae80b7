import type { HostOutput } from '../../../app/contract/contract.ts';
import { migrateNodes } from '../../../export/graph/library/migrate-nodes.ts';
import { readRecipe } from '../../../export/graph/read-recipe.ts';
import { validateProject } from '../../../export/graph/validate/validate.ts';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { Editor } from '../editor/editor.ts';
import type { BrokenRecipe, OwnRecipe } from '../editor/recipe-state.ts';
import { addToast } from '../editor/ui.ts';
import { showRefusal } from '../files/files.ts';

/** Lists the recipes of the person again. Leaves out broken ones, and says once which and why. */
export async function listRecipes(editor: Editor): Promise<void> {
  try {
    const listed = await editor.host.call('recipe.list', {});
    const before = editor.recipes.getState();
    const text = JSON.stringify(listed);
    // The same list keeps its objects, so that the palette does not begin anew.
    if (text === before.text) return;
    const own: OwnRecipe[] = [];
    const broken: BrokenRecipe[] = [];
    for (const { name, path, ...read } of listed) {
      const recipe = readOwn(editor.libraries.base, read);
      if ('project' in recipe) own.push({ name, path, project: recipe.project });
      else broken.push({ name, path, diagnostic: recipe });
    }
    editor.recipes.setState({ own, broken, text });
    const known = new Set(before.broken.map(wordsOf));
    for (const recipe of broken) {
      const words = wordsOf(recipe);
      if (!known.has(words)) addToast(editor.ui, { tone: 'warning', text: words, detail: recipe.diagnostic.fix ?? recipe.path });
    }
  } catch (error) {
    showRefusal(editor, error);
  }
}

/** Which recipe is broken, and why. */
export function wordsOf({ name, diagnostic: { message, file, line } }: BrokenRecipe): string {
  const place = file === undefined ? '' : `${file}${line === undefined ? '' : `:${line}`}: `;
  return `The recipe “${name}” was left out. ${place}${message}`;
}

type Listed = Pick<HostOutput<'recipe.list'>[number], 'files' | 'problem'>;

function readOwn(library: NodeLibrary, { files, problem }: Listed): Diagnostic | Pick<OwnRecipe, 'project'> {
  if (files === null) return (problem as Diagnostic | null) ?? UNREADABLE;
  const { output: project, diagnostics } = readRecipe(files);
  if (project === null) return diagnostics.find(({ severity }) => severity === 'error') ?? UNREADABLE;
  // A recipe has no output of its own.
  const wrong = validateProject(migrateNodes(project, library).project, library).find(
    ({ code, severity }) => severity === 'error' && code !== 'SCR017',
  );
  return wrong ?? { project };
}

const UNREADABLE: Diagnostic = { code: 'SCR004', severity: 'error', message: 'It cannot be read.' };
