import { useId, useState } from 'react';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { titleOfName } from '../state/editor/library.ts';
import { removeFromLibrary, saveToLibrary, titleProblem, usesInWords } from '../state/graph/subgraph-library.ts';
import { renameSubgraph } from '../state/graph/subgraphs.ts';
import { ChoiceDialog } from '../ui/choice-dialog.tsx';
import { FormDialog } from '../ui/form-dialog.tsx';

interface LibraryNameDialogProps {
  readonly name: string;
  readonly rename: boolean;
  readonly onClose: () => void;
}

/** Names or renames a subgraph of the library. */
export function LibraryNameDialog({ name, rename, onClose }: LibraryNameDialogProps) {
  const editor = useEditor();
  const id = useId();
  const [title, setTitle] = useState(titleOfName(name));
  const problem = useDocument(({ project }) => titleProblem(project, name, title));
  const uses = useDocument(({ project }) => usesInWords(project, name));
  const go = () => {
    if ((rename ? renameSubgraph : saveToLibrary)(editor, name, title)) onClose();
  };
  return (
    <FormDialog
      title={rename ? `Rename “${titleOfName(name)}”` : 'Save to the library'}
      action={rename ? 'Rename' : 'Save'}
      ready={problem === null}
      onGo={go}
      onClose={onClose}
    >
      <label htmlFor={id}>Name</label>
      <input
        id={id}
        className="field"
        data-autofocus=""
        autoComplete="off"
        spellCheck={false}
        aria-invalid={problem !== null}
        aria-describedby={`${id}-note`}
        value={title}
        onFocus={(event) => event.target.select()}
        onChange={(event) => setTitle(event.target.value)}
      />
      <p id={`${id}-note`} className="dialog-note" aria-live="polite">
        {problem ??
          (uses === null
            ? 'The node search finds it by this name.'
            : `The node search finds it by this name. Used by ${uses}; the name changes there, too.`)}
      </p>
    </FormDialog>
  );
}

/** Confirms the removal of a subgraph, and lists its instances. */
export function LibraryRemoveDialog({ name, onClose }: { readonly name: string; readonly onClose: () => void }) {
  const editor = useEditor();
  const uses = useDocument(({ project }) => usesInWords(project, name));
  const remove = () => {
    onClose();
    removeFromLibrary(editor, name);
  };
  return (
    <ChoiceDialog
      title={`Remove “${titleOfName(name)}” from the library?`}
      onClose={onClose}
      choices={[
        { label: 'Cancel', look: 'quiet', run: onClose },
        { label: 'Ungroup and remove', look: 'danger', run: remove },
      ]}
    >
      {uses === null ? 'Not used.' : `Used by ${uses}. Each is replaced by its contents, so the output does not change.`}
    </ChoiceDialog>
  );
}
