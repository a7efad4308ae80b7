import { useStore } from 'zustand';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import { canBeWired, inputFacts, needFacts, outputFacts, paramFacts } from '../../nodes/kit/facts.ts';
import type { WireType } from '../../nodes/kit/wire-types.ts';
import { PortMark } from '../canvas/port-mark.tsx';
import { useKeys } from '../state/commands/command-item.ts';
import { nodeOf } from '../state/editor/document.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { soleNode } from '../state/editor/selection.ts';
import { confirmUnsaved, openPath } from '../state/files/files.ts';
import { categoryOf } from '../state/graph/palette-search.ts';
import { IconButton } from '../ui/button.tsx';
import { DocText } from '../ui/doc-text.tsx';
import { ImageCard } from '../ui/image-card.tsx';
import './help-panel.css';

/**
 * Panel with the docs of the selected node, beside the graph. The docs come from the definition of the node, as in the palette and in
 * `docs/nodes.md`.
 */
export function HelpPanel() {
  const { ui, selection } = useEditor();
  const node = useStore(selection, soleNode);
  const keys = useKeys('view.help');
  const definition = useDocument((state) => {
    const type = node === null ? undefined : nodeOf(state, node)?.type;
    return type === undefined ? undefined : state.library.definition(type);
  });
  return (
    <aside className="help scroll" aria-label="Node help">
      <div className="help-bar">
        <h2>{definition?.title ?? 'Node help'}</h2>
        <IconButton icon="close" label="Close help" keys={keys} small onPress={() => ui.setState({ help: false })} />
      </div>
      {definition ? (
        <NodeHelp key={definition.type} definition={definition} />
      ) : (
        <p className="help-none">Select a node to read what it does.</p>
      )}
    </aside>
  );
}

function NodeHelp({ definition }: { readonly definition: NodeDefinition }) {
  const { inputs, outputs, params, needs = [], keywords = [], credit, licence } = definition;
  return (
    <div className="help-body">
      <p className="help-kind">
        {categoryOf(definition)} <code>{definition.type}</code>
      </p>
      <DocText text={definition.doc} />
      <Examples type={definition.type} />
      <Facts title="Inputs" entries={portEntries(inputs, inputFacts)} />
      <Facts title="Outputs" entries={portEntries(outputs, outputFacts)} />
      <Facts
        title="Parameters"
        entries={Object.entries(params).map(([name, param]) => ({
          name,
          label: param.label,
          facts: [...paramFacts(param), ...(canBeWired(param) ? ['can be connected'] : [])],
          doc: param.doc,
        }))}
      />
      <Facts
        title="Device features"
        entries={needs.map((need) => ({
          name: need.capability,
          label: need.capability.replaceAll('-', ' '),
          facts: needFacts(definition, need),
          doc: `${need.why}. Without it: ${need.without}`,
        }))}
      />
      {keywords.length > 0 && <p className="help-note">Also found as {keywords.join(', ')}.</p>}
      {credit !== undefined && <p className="help-note">By {credit}</p>}
      {licence !== undefined && <p className="help-note">License: {licence}</p>}
    </div>
  );
}

interface FactsEntry {
  readonly name: string;
  readonly label: string;
  readonly type?: WireType;
  readonly facts: readonly string[];
  readonly doc: string;
}

/** Entries for inputs or outputs. */
function portEntries<Port extends { readonly label: string; readonly type: WireType; readonly doc: string }>(
  ports: Readonly<Record<string, Port>>,
  factsOf: (port: Port) => readonly string[],
): readonly FactsEntry[] {
  return Object.entries(ports).map(([name, port]) => ({ name, label: port.label, type: port.type, facts: factsOf(port), doc: port.doc }));
}

function Facts({ title, entries }: { readonly title: string; readonly entries: readonly FactsEntry[] }) {
  if (entries.length === 0) return null;
  return (
    <section>
      <h3>{title}</h3>
      <dl className="help-facts">
        {entries.map(({ name, label, type, facts, doc }) => (
          <div key={name}>
            <dt>
              {type && <PortMark type={type} />}
              {label}
            </dt>
            <dd className="help-fact">{facts.join(' · ')}</dd>
            <dd>{doc}</dd>
          </div>
        ))}
      </dl>
    </section>
  );
}

const MOST_EXAMPLES = 2;

/** Example projects that use the node. */
function Examples({ type }: { readonly type: string }) {
  const editor = useEditor();
  const all = useDocument((state) => state.examples);
  const examples = all.filter(({ types }) => types.includes(type)).slice(0, MOST_EXAMPLES);
  if (examples.length === 0) return null;
  return (
    <section>
      <h3>Examples</h3>
      <ul className="help-examples">
        {examples.map(({ path, title, picture }) => (
          <li key={path}>
            <ImageCard
              purpose="Open the example"
              title={title}
              image={picture}
              disabled={false}
              onPress={() => confirmUnsaved(editor, () => void openPath(editor, path))}
            />
          </li>
        ))}
      </ul>
    </section>
  );
}
