import { useEffect, useId, useState } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../state/editor/editor-context.ts';
import { confirmUnsaved, openPath } from '../state/files/files.ts';
import { listRecipes, wordsOf } from '../state/recipes/list-recipes.ts';
import { recipeOfSelection } from '../state/recipes/recipe-of-selection.ts';
import { describeRecipe, portsOfRecipe, recipeTitleProblem, removeRecipe, saveRecipe } from '../state/recipes/save-recipe.ts';
import { wordsIn } from '../state/recipes/search-words.ts';
import { Button, IconButton } from '../ui/button.tsx';
import { Dialog } from '../ui/dialog.tsx';
import { FormDialog } from '../ui/form-dialog.tsx';
import { TextField } from '../ui/form-fields.tsx';
import { Icon } from '../ui/icon.tsx';
import { DialogErrors, ErrorText } from './dialog-error.tsx';
import './open-dialog.css';

/** Asks for the name, the description and the search words of a recipe with the selected nodes, or says why they cannot be one. */
export function RecipeDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const id = useId();
  const [recipe] = useState(() => recipeOfSelection(editor));
  const [title, setTitle] = useState('My recipe');
  const [description, setDescription] = useState(() => ('project' in recipe ? describeRecipe(editor, recipe.project) : ''));
  const [searchWords, setSearchWords] = useState('');
  const [busy, setBusy] = useState(false);
  const problem = useStore(editor.recipes, (recipes) => recipeTitleProblem(recipes, title));
  if ('problem' in recipe) {
    return (
      <FormDialog title="Save as recipe" action="Save" ready={false} onGo={() => {}} onClose={onClose}>
        <ErrorText text={recipe.problem} detail={undefined} />
      </FormDialog>
    );
  }
  const go = async () => {
    setBusy(true);
    const words = { title: title.trim(), description: description.trim(), keywords: wordsIn(searchWords) };
    if (await saveRecipe(editor, recipe.project, words)) onClose();
    else setBusy(false);
  };
  const ports = (side: 'inputs' | 'outputs') => portsOfRecipe(editor, recipe.project, side);
  return (
    <FormDialog title="Save as recipe" action="Save" ready={problem === null && !busy} onGo={() => void go()} onClose={onClose}>
      <TextField label="Name" text={title} plain autoFocus error={problem ?? undefined} onChange={setTitle} />
      <label htmlFor={`${id}-description`}>Description</label>
      <textarea
        id={`${id}-description`}
        className="field"
        rows={3}
        value={description}
        onChange={(event) => setDescription(event.target.value)}
      />
      <TextField label="Search words, separated by commas" text={searchWords} plain onChange={setSearchWords} />
      <p className="dialog-note">{`Inputs: ${ports('inputs')}. Outputs: ${ports('outputs')}.`}</p>
      <DialogErrors />
    </FormDialog>
  );
}

/** The person’s recipes: opens one as a project, or deletes it. */
export function RecipesDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const { own, broken } = useStore(editor.recipes);
  useEffect(() => void listRecipes(editor), [editor]);
  const open = (path: string) => {
    onClose();
    confirmUnsaved(editor, () => void openPath(editor, path));
  };
  const row = (recipe: { readonly name: string; readonly path: string }, title: string) => (
    <li key={recipe.path}>
      <button type="button" className="open-project" data-tip={recipe.path} onClick={() => open(recipe.path)}>
        <Icon name="folder" />
        <span className="open-title">{title}</span>
        <span className="open-path">{recipe.path}</span>
      </button>
      <IconButton icon="close" label={`Delete ${title}`} small onPress={() => void removeRecipe(editor, recipe)} />
    </li>
  );
  return (
    <Dialog title="My recipes" onClose={onClose} actions={<Button onPress={onClose}>Close</Button>}>
      <ul className="folder-list open-recent">
        {own.map((recipe) => row(recipe, recipe.project.title))}
        {broken.map((recipe) => row(recipe, recipe.name))}
      </ul>
      {broken.map((recipe) => (
        <ErrorText key={recipe.path} text={wordsOf(recipe)} detail={recipe.diagnostic.fix} />
      ))}
      {own.length + broken.length === 0 ? (
        <p className="dialog-note">Select nodes and choose “Save as recipe…” in their menu.</p>
      ) : (
        <p className="dialog-note">
          A recipe opens as a project. Its title is its name in the palette, which also finds it by its search words.
        </p>
      )}
    </Dialog>
  );
}
