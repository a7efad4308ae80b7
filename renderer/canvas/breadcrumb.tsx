import { Panel } from '@xyflow/react';
import { useDocument, useEditor } from '../shell/editor-context.ts';
import { titleOfGraph } from '../state/find.ts';
import { openOnTrail } from '../state/subgraphs.ts';
import { Icon } from '../ui/icon.tsx';
import './breadcrumb.css';

/** The way from the main graph to the subgraph that is open; nothing in the main graph. */
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
            // A subgraph never contains itself, so no name comes twice.
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
