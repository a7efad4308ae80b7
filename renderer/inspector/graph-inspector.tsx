import { graphOf, titleOf } from '../state/editor/document.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { type PortSide, setPortExposed } from '../state/graph/subgraphs.ts';
import { IconButton } from '../ui/button.tsx';
import { SubgraphName } from './subgraph-section.tsx';

/** Inspector of the open subgraph while nothing is selected: its name and its exposed ports. */
export function GraphInspector() {
  const name = useDocument((state) => state.graph);
  const { inputs, outputs } = useDocument((state) => graphOf(state).exposed);
  return (
    <>
      <header className="inspector-head">
        <h2>Subgraph</h2>
        <SubgraphName key={name} name={name} />
      </header>
      <ExposedPorts side="inputs" title="Inputs" ports={inputs} />
      <ExposedPorts side="outputs" title="Outputs" ports={outputs} />
      <section className="inspector-section" aria-label="Hint">
        <p className="inspector-note">Select a node to expose its ports and parameters.</p>
      </section>
    </>
  );
}

interface ExposedPortsProps {
  readonly side: PortSide;
  readonly title: string;
  readonly ports: readonly { readonly name: string; readonly node: string; readonly port: string }[];
}

function ExposedPorts({ side, title, ports }: ExposedPortsProps) {
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
              label={`Stop exposing ${label} of ${titleOf(state, node)}`}
              small
              onPress={() => void setPortExposed(editor, side, { node, port }, false)}
            />
          </div>
        );
      })}
    </section>
  );
}
