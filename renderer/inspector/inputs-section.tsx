import { useMemo } from 'react';
import type { PortAddress, Wire } from '../../export/graph/project.ts';
import type { InputPort, NodeDefinition } from '../../nodes/kit/definition.ts';
import { PortMark } from '../canvas/port-mark.tsx';
import { graphOf } from '../state/editor/document.ts';
import { useDocument, useDocumentWhile, useEditor } from '../state/editor/editor-context.ts';
import { connect, reorderWires } from '../state/graph/edit-graph.ts';
import { IconButton } from '../ui/button.tsx';
import { SelectField } from '../ui/select-field.tsx';
import { SourceLink } from './source-link.tsx';
import { sameForWires, sourcesFor } from './wire-sources.ts';

interface InputsSectionProps {
  readonly node: string;
  readonly definition: NodeDefinition;
  readonly wires: readonly Wire[];
}

/** Inputs of a node and their sources. Connects, disconnects and reorders wires without a pointer. */
export function InputsSection({ node, definition, wires }: InputsSectionProps) {
  const entries = Object.entries(definition.inputs);
  if (entries.length === 0) return null;
  return (
    <section className="inspector-section" aria-label="Inputs">
      <h3>Inputs</h3>
      {entries.map(([name, port]) => (
        <InputRow
          key={name}
          node={node}
          name={name}
          port={port}
          sources={wires.filter(({ to }) => to.port === name).map(({ from }) => from)}
        />
      ))}
    </section>
  );
}

interface InputRowProps {
  readonly node: string;
  readonly name: string;
  readonly port: InputPort;
  readonly sources: readonly PortAddress[];
}

function InputRow({ node, name, port, sources }: InputRowProps) {
  const editor = useEditor();
  const to = { node, port: name };
  const move = (index: number, by: -1 | 1) => {
    const next = [...sources];
    const [taken] = next.splice(index, 1);
    if (taken) next.splice(index + by, 0, taken);
    reorderWires(editor, to, next);
  };
  return (
    <div className="param-row input-row" data-input={name}>
      <span className="param-label" data-tip={port.doc}>
        <PortMark type={port.type} />
        <span>{port.label}</span>
      </span>
      <div className="param-control">
        {sources.map((from, index) => (
          <span key={`${from.node}.${from.port}`} className="input-source">
            <SourceLink from={from} to={to} />
            {sources.length > 1 && (
              <>
                <IconButton icon="up" label="Move up" small disabled={index === 0} onPress={() => move(index, -1)} />
                <IconButton icon="down" label="Move down" small disabled={index === sources.length - 1} onPress={() => move(index, 1)} />
              </>
            )}
          </span>
        ))}
        {(sources.length === 0 || port.multiple === true) && (
          <SourcePicker node={node} name={name} port={port} empty={sources.length === 0} />
        )}
      </div>
    </div>
  );
}

interface SourcePickerProps {
  readonly node: string;
  readonly name: string;
  readonly port: InputPort;
  readonly empty: boolean;
}

/** Lists all outputs that can connect to the port. */
function SourcePicker({ node, name, port, empty }: SourcePickerProps) {
  const editor = useEditor();
  const state = useDocumentWhile(sameForWires);
  const options = useMemo(() => sourcesFor(state, { node, port: name }), [state, node, name]);
  const choices = options.map(({ label }, value) => ({ value, label }));
  const isExposed = useDocument((document) => graphOf(document).exposed.inputs.some((input) => input.node === node && input.port === name));
  const none = isExposed ? 'Input of the subgraph' : port.required ? 'Not connected (required)' : 'Not connected';
  return (
    <SelectField
      label={empty ? `Connect to ${port.label}` : `Connect another to ${port.label}`}
      value={-1}
      options={choices}
      placeholder={empty ? none : 'Add another…'}
      needed={port.required === true && empty && !isExposed}
      onChoose={(index) => {
        const chosen = options[index];
        if (chosen) connect(editor, chosen.from, { node, port: name });
      }}
    />
  );
}
