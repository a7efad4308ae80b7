import { Panel } from '@xyflow/react';
import { useState } from 'react';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { titleOfGraph } from '../state/graph/find.ts';
import { titleProblem } from '../state/graph/subgraph-library.ts';
import { openOnTrail, renameSubgraph } from '../state/graph/subgraphs.ts';
import { Icon } from '../ui/icon.tsx';
import { NameInPlace, renameHandlers } from './name-in-place.tsx';
import './breadcrumb.css';

/** The path from the main graph to the open subgraph. Renders nothing in the main graph. */
export function Breadcrumb() {
  const editor = useEditor();
  const graph = useDocument((state) => state.graph);
  const trail = useDocument((state) => state.trail);
  const [naming, setNaming] = useState(false);
  if (trail.length === 0) return null;
  return (
    <Panel position="top-left" className="breadcrumb">
      <nav aria-label="Subgraphs">
        <ol>
          {trail.map((name, depth) => (
            // A subgraph never contains itself, so names are unique keys.
            <li key={name}>
              <button type="button" onClick={() => openOnTrail(editor, depth)}>
                {titleOfGraph(name)}
              </button>
              <Icon name="chevron" size={12} />
            </li>
          ))}
          <li>
            {naming ? (
              <NameInPlace
                label="Name of the subgraph"
                title={titleOfGraph(graph)}
                problemOf={(typed) => titleProblem(editor.document.getState().project, graph, typed)}
                onName={(typed) => void renameSubgraph(editor, graph, typed)}
                onLeave={() => setNaming(false)}
              />
            ) : (
              <button type="button" aria-current="page" data-tip="Double-click renames" {...renameHandlers(() => setNaming(true))}>
                {titleOfGraph(graph)}
              </button>
            )}
          </li>
        </ol>
      </nav>
    </Panel>
  );
}
