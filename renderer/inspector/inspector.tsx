import { useStore } from 'zustand';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { soleNode } from '../state/editor/selection.ts';
import { GraphInspector } from './graph-inspector.tsx';
import './inspector.css';
import { NodeInspector } from './node-inspector.tsx';
import { ProjectInspector } from './project-inspector.tsx';
import { SelectionInspector } from './selection-inspector.tsx';

/** Inspector of the selection, or of the project if nothing is selected. It is built from node definitions alone. */
export function Inspector() {
  const { selection } = useEditor();
  const node = useStore(selection, soleNode);
  const count = useStore(selection, ({ nodes, wires }) => nodes.size + wires.size);
  const isInside = useDocument((state) => state.trail.length > 0);
  return (
    <aside className="inspector scroll" aria-label="Inspector">
      {node !== null ? (
        <NodeInspector key={node} id={node} />
      ) : count > 0 ? (
        <SelectionInspector />
      ) : isInside ? (
        <GraphInspector />
      ) : (
        <ProjectInspector />
      )}
    </aside>
  );
}
