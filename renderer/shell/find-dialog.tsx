import { useMemo, useState } from 'react';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { findNodes, goToFound, titleOfGraph } from '../state/graph/find.ts';
import { SearchDialog } from '../ui/search-dialog.tsx';

/** Finds nodes of all graphs by name, id or parameter. */
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
      placeholder="Name, id or parameter of a node"
      none="No matching node."
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
