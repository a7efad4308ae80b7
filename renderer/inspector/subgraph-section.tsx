import { useId, useState } from 'react';
import { usersOfGraph } from '../../export/graph/commands/graphs.ts';
import { useDocument, useEditor } from '../shell/editor-context.ts';
import { runCommand } from '../state/app-commands.ts';
import { titleOfName } from '../state/library.ts';
import { renameSubgraph } from '../state/subgraphs.ts';
import { Button } from '../ui/button.tsx';

/** A subgraph's name, as people write it. Takes effect at Enter, or when the focus goes. */
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

/** At a node that stands for a subgraph: its name, and what can be done with it. */
export function SubgraphSection({ name }: { readonly name: string }) {
  const editor = useEditor();
  const users = useDocument(({ project }) => usersOfGraph(project, name).length);
  return (
    <section className="inspector-section" aria-label="Subgraph">
      <SubgraphName key={name} name={name} />
      <div className="inspector-actions">
        <Button onPress={() => runCommand(editor, 'graph.enter')}>Open</Button>
        {users > 1 && <Button onPress={() => runCommand(editor, 'graph.independent')}>Make independent</Button>}
        <Button onPress={() => runCommand(editor, 'graph.unpack')}>Unpack</Button>
        <Button onPress={() => runCommand(editor, 'graph.save')} tip="As a node of the project’s own, found by Tab">
          Save to the library…
        </Button>
      </div>
      {users > 1 && <p className="inspector-note">{users} nodes stand for it, and all follow what is changed in it.</p>}
    </section>
  );
}
