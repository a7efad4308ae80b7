import { useId, useState } from 'react';
import { usersOfGraph } from '../../export/graph/commands/subgraph-commands.ts';
import { runCommand } from '../state/commands/app-commands.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { titleOfName } from '../state/editor/library.ts';
import { renameSubgraph } from '../state/graph/subgraphs.ts';
import { Button } from '../ui/button.tsx';

/** Edits the title of a subgraph. Enter or a loss of focus applies it. */
export function SubgraphName({ name }: { readonly name: string }) {
  const editor = useEditor();
  const id = useId();
  const [typed, setTyped] = useState<string | null>(null);
  const finish = () => {
    if (typed !== null) renameSubgraph(editor, name, typed);
    setTyped(null);
  };
  return (
    <div className="stacked">
      <label htmlFor={id}>Name</label>
      <input
        id={id}
        className="field"
        autoComplete="off"
        spellCheck={false}
        data-clean={typed === null ? '' : undefined}
        value={typed ?? titleOfName(name)}
        onChange={(event) => setTyped(event.target.value)}
        onBlur={finish}
        onKeyDown={(event) => {
          if (event.key === 'Enter') finish();
          else if (event.key === 'Escape' && typed !== null) {
            event.stopPropagation();
            setTyped(null);
          }
        }}
      />
    </div>
  );
}

/** Name and actions of a subgraph, at one of its instances. */
export function SubgraphSection({ name }: { readonly name: string }) {
  const editor = useEditor();
  const users = useDocument(({ project }) => usersOfGraph(project, name).length);
  return (
    <section className="inspector-section" aria-label="Subgraph">
      <SubgraphName key={name} name={name} />
      <div className="inspector-actions">
        <Button onPress={() => runCommand(editor, 'graph.enter')}>Open</Button>
        {users > 1 && <Button onPress={() => runCommand(editor, 'graph.independent')}>Make unique</Button>}
        <Button onPress={() => runCommand(editor, 'graph.unpack')}>Ungroup</Button>
        <Button onPress={() => runCommand(editor, 'graph.save')} tip="Adds it to the project library and the node search">
          Save to the library…
        </Button>
      </div>
      {users > 1 && <p className="inspector-note">Used by {users} nodes; edits apply to all of them.</p>}
    </section>
  );
}
