import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import { useDocument, useEditor } from '../shell/editor-context.ts';
import { graphOf } from '../state/document.ts';
import { type PortSide, setShownOutside, shownName } from '../state/subgraphs.ts';

interface OutsideSectionProps {
  readonly node: string;
  readonly definition: NodeDefinition;
}

/** In a subgraph: which ports and values of the node the graph outside sees. */
export function OutsideSection({ node, definition }: OutsideSectionProps) {
  const inside = useDocument((state) => state.trail.length > 0);
  if (!inside) return null;
  const rows: readonly (readonly [side: PortSide, ports: Readonly<Record<string, { readonly label: string }>>, kind: string])[] = [
    ['inputs', definition.inputs, 'input'],
    ['inputs', definition.params, 'value'],
    ['outputs', definition.outputs, 'output'],
  ];
  return (
    <section className="inspector-section" aria-label="Shown outside">
      <h3>Shown outside the subgraph</h3>
      {rows.flatMap(([side, ports, kind]) =>
        Object.entries(ports).map(([port, { label }]) => (
          <OutsideSwitch key={`${kind} ${port}`} side={side} node={node} port={port} label={`${label}, ${kind}`} />
        )),
      )}
    </section>
  );
}

interface OutsideSwitchProps {
  readonly side: PortSide;
  readonly node: string;
  readonly port: string;
  readonly label: string;
}

function OutsideSwitch({ side, node, port, label }: OutsideSwitchProps) {
  const editor = useEditor();
  const shown = useDocument((state) => shownName(graphOf(state).exposed, side, { node, port }) !== null);
  return (
    <label className="outside-row">
      <span>{label}</span>
      <input
        type="checkbox"
        role="switch"
        className="switch"
        aria-checked={shown}
        checked={shown}
        onChange={(event) => void setShownOutside(editor, side, { node, port }, event.target.checked)}
      />
    </label>
  );
}
