import { useId, useState } from 'react';
import { titleOfName } from '../state/library.ts';
import { removeFromLibrary, saveToLibrary, titleProblem, usesInWords } from '../state/subgraph-library.ts';
import { renameSubgraph } from '../state/subgraphs.ts';
import { Button } from '../ui/button.tsx';
import { Dialog } from '../ui/dialog.tsx';
import { FormDialog } from '../ui/form-dialog.tsx';
import { useDocument, useEditor } from './editor-context.ts';

interface LibraryNameDialogProps {
  readonly name: string;
  readonly rename: boolean;
  readonly onClose: () => void;
}

/** What a subgraph is called in the library. */
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
            ? 'A node of this project’s own: Tab finds it by this name.'
            : `A node of this project’s own: Tab finds it by this name. Used by ${uses}, where the name changes, too.`)}
      </p>
    </FormDialog>
  );
}

/** Says what uses a subgraph before it goes. */
export function LibraryRemoveDialog({ name, onClose }: { readonly name: string; readonly onClose: () => void }) {
  const editor = useEditor();
  const uses = useDocument(({ project }) => usesInWords(project, name));
  return (
    <Dialog
      title={`Remove “${titleOfName(name)}” from the library?`}
      onClose={onClose}
      actions={
        <>
          <Button look="quiet" onPress={onClose}>
            Cancel
          </Button>
          <Button
            look="danger"
            autoFocus
            onPress={() => {
              onClose();
              removeFromLibrary(editor, name);
            }}
          >
            Unpack and remove
          </Button>
        </>
      }
    >
      {uses === null ? 'Nothing uses it.' : `It is used by ${uses}. What is in it takes their place, so that the picture stays as it is.`}
    </Dialog>
  );
}
