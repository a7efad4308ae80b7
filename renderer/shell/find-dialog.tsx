import { useMemo, useState } from 'react';
import { findNodes, goToFound, titleOfGraph } from '../state/find.ts';
import { SearchDialog } from '../ui/search-dialog.tsx';
import { useDocument, useEditor } from './editor-context.ts';

/** Finds nodes of all graphs by name or value. */
export function FindDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const state = useDocument((document) => document);
  const [query, setQuery] = useState('');
  const found = useMemo(() => findNodes(state, query), [state, query]);
  return (
    <SearchDialog
      title="Find in the graph"
      label="Name or value"
      listLabel="Nodes"
      placeholder="Name, id or value of a node"
      none="Nothing is called so."
      query={query}
      onQuery={setQuery}
      found={found}
      keyOf={({ graph, node }) => `${graph}/${node}`}
      onPick={(target) => goToFound(editor, target)}
      onClose={onClose}
    >
      {({ title, detail, graph }) => (
        <>
          <span>{title}</span>
          <span className="search-detail">{detail}</span>
          {graph !== state.graph && <span className="search-aside">{titleOfGraph(graph)}</span>}
        </>
      )}
    </SearchDialog>
  );
}
