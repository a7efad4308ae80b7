import { Panel } from '@xyflow/react';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { titleOfGraph } from '../state/graph/find.ts';
import { openOnTrail } from '../state/graph/subgraphs.ts';
import { Icon } from '../ui/icon.tsx';
import './breadcrumb.css';

/** The path from the main graph to the open subgraph. Renders nothing in the main graph. */
export function Breadcrumb() {
  const editor = useEditor();
  const graph = useDocument((state) => state.graph);
  const trail = useDocument((state) => state.trail);
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
          <li aria-current="page">{titleOfGraph(graph)}</li>
        </ol>
      </nav>
    </Panel>
  );
}
