import { type KeyboardEvent, useId, useMemo, useRef, useState } from 'react';
import { type Found, findNodes, goToFound, titleOfGraph } from '../state/find.ts';
import { Dialog } from '../ui/dialog.tsx';
import { useDocument, useEditor } from './editor-context.ts';
import './find-dialog.css';

/** Finds nodes of all graphs by name or value: type, arrows, Enter. */
export function FindDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const state = useDocument((document) => document);
  const [query, setQuery] = useState('');
  const [chosen, setChosen] = useState(0);
  const list = useRef<HTMLDivElement>(null);
  const listId = useId();
  const found = useMemo(() => findNodes(state, query), [state, query]);

  const go = (target: Found | undefined) => {
    if (!target) return;
    onClose();
    goToFound(editor, target);
  };
  const choose = (index: number) => {
    setChosen(index);
    list.current?.children[index]?.scrollIntoView({ block: 'nearest' });
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const last = found.length - 1;
    if (event.key === 'ArrowDown') choose(chosen >= last ? 0 : chosen + 1);
    else if (event.key === 'ArrowUp') choose(chosen <= 0 ? Math.max(last, 0) : chosen - 1);
    else if (event.key === 'Enter') go(found[chosen]);
    else return;
    event.preventDefault();
  };

  return (
    <Dialog title="Find in the graph" onClose={onClose}>
      <input
        className="field"
        data-autofocus=""
        role="combobox"
        aria-label="Name or value"
        aria-expanded="true"
        aria-controls={listId}
        aria-activedescendant={found[chosen] ? `${listId}-${chosen}` : undefined}
        placeholder="Name, id or value of a node"
        autoComplete="off"
        spellCheck={false}
        value={query}
        onChange={(event) => {
          setQuery(event.target.value);
          choose(0);
        }}
        onKeyDown={onKeyDown}
      />
      <div ref={list} id={listId} className="find-list scroll" role="listbox" aria-label="Nodes">
        {found.map((entry, index) => (
          // Keys are the field's: the list is only ever pointed at.
          <div
            key={entry.node}
            id={`${listId}-${index}`}
            className="find-row"
            role="option"
            aria-selected={index === chosen}
            tabIndex={-1}
            onPointerMove={() => setChosen(index)}
            onPointerUp={() => go(entry)}
          >
            <span className="find-title">{entry.title}</span>
            <span className="find-detail">{entry.detail}</span>
            {entry.graph !== state.graph && <span className="find-graph">{titleOfGraph(entry.graph)}</span>}
          </div>
        ))}
      </div>
      {found.length === 0 && <p className="find-none">Nothing is called so.</p>}
    </Dialog>
  );
}
