import { useDocument, useEditor } from '../shell/editor-context.ts';
import { graphOf, titleOf } from '../state/document.ts';
import { type PortSide, setShownOutside } from '../state/subgraphs.ts';
import { IconButton } from '../ui/button.tsx';
import { SubgraphName } from './subgraph-section.tsx';

/** The subgraph that is open, while nothing in it is selected: its name, and what the graph outside sees of it. */
export function GraphInspector() {
  const name = useDocument((state) => state.graph);
  const { inputs, outputs } = useDocument((state) => graphOf(state).exposed);
  return (
    <>
      <header className="inspector-head">
        <h2>Subgraph</h2>
        <SubgraphName key={name} name={name} />
      </header>
      <ShownPorts side="inputs" title="Takes" ports={inputs} />
      <ShownPorts side="outputs" title="Gives" ports={outputs} />
      <section className="inspector-section" aria-label="Hint">
        <p className="inspector-note">Select a node to choose which of its ports and values the graph outside sees.</p>
      </section>
    </>
  );
}

interface ShownPortsProps {
  readonly side: PortSide;
  readonly title: string;
  readonly ports: readonly { readonly name: string; readonly node: string; readonly port: string }[];
}

function ShownPorts({ side, title, ports }: ShownPortsProps) {
  const editor = useEditor();
  const state = useDocument((document) => document);
  if (ports.length === 0) return null;
  return (
    <section className="inspector-section" aria-label={title}>
      <h3>{title}</h3>
      {ports.map(({ name, node, port }) => {
        const definition = state.library.definition(graphOf(state).nodes[node]?.type ?? '');
        const label =
          (side === 'outputs' ? definition?.outputs[port] : (definition?.inputs[port] ?? definition?.params[port]))?.label ?? name;
        return (
          <div key={name} className="outside-row">
            <span>
              {label} of {titleOf(state, node)}
            </span>
            <IconButton
              icon="close"
              label={`Hide ${label} of ${titleOf(state, node)} outside`}
              small
              onPress={() => void setShownOutside(editor, side, { node, port }, false)}
            />
          </div>
        );
      })}
    </section>
  );
}
