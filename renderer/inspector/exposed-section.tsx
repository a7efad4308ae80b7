import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import { graphOf } from '../state/editor/document.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { exposedName, type PortSide, setPortExposed } from '../state/graph/subgraphs.ts';

interface ExposedSectionProps {
  readonly node: string;
  readonly definition: NodeDefinition;
}

/** Switches that expose ports and params of a node on the instances of the open subgraph. */
export function ExposedSection({ node, definition }: ExposedSectionProps) {
  const inside = useDocument((state) => state.trail.length > 0);
  if (!inside) return null;
  const rows: readonly (readonly [side: PortSide, ports: Readonly<Record<string, { readonly label: string }>>, kind: string])[] = [
    ['inputs', definition.inputs, 'input'],
    ['inputs', definition.params, 'parameter'],
    ['outputs', definition.outputs, 'output'],
  ];
  return (
    <section className="inspector-section" aria-label="Exposed">
      <h3>Exposed</h3>
      {rows.flatMap(([side, ports, kind]) =>
        Object.entries(ports).map(([port, { label }]) => (
          <ExposedSwitch key={`${kind} ${port}`} side={side} node={node} port={port} label={`${label}, ${kind}`} />
        )),
      )}
    </section>
  );
}

interface ExposedSwitchProps {
  readonly side: PortSide;
  readonly node: string;
  readonly port: string;
  readonly label: string;
}

function ExposedSwitch({ side, node, port, label }: ExposedSwitchProps) {
  const editor = useEditor();
  const shown = useDocument((state) => exposedName(graphOf(state).exposed, side, { node, port }) !== null);
  return (
    <label className="outside-row">
      <span>{label}</span>
      <input
        type="checkbox"
        role="switch"
        className="switch"
        aria-checked={shown}
        checked={shown}
        onChange={(event) => void setPortExposed(editor, side, { node, port }, event.target.checked)}
      />
    </label>
  );
}
