import { useStore } from 'zustand';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import { canBeWired, inputFacts, needFacts, outputFacts, paramFacts } from '../../nodes/kit/facts.ts';
import type { WireType } from '../../nodes/kit/wire-types.ts';
import { categoryOf } from '../canvas/palette-search.ts';
import { PortMark } from '../canvas/port-mark.tsx';
import { useDocument, useEditor } from '../shell/editor-context.ts';
import { PictureCard } from '../shell/picture-card.tsx';
import { useKeys } from '../shell/use-keys.ts';
import { nodeOf } from '../state/document.ts';
import { openPath, withoutUnsaved } from '../state/files.ts';
import { soleNode } from '../state/selection.ts';
import { IconButton } from '../ui/button.tsx';
import { DocText } from '../ui/doc-text.tsx';
import './help-panel.css';

/** What the selected node does, beside the graph: all of it from its definition, as the palette and `docs/nodes.md` have it. */
export function HelpPanel() {
  const { ui, selection } = useEditor();
  const node = useStore(selection, soleNode);
  const keys = useKeys('view.help');
  const definition = useDocument((state) => {
    const type = node === null ? undefined : nodeOf(state, node)?.type;
    return type === undefined ? undefined : state.library.definition(type);
  });
  return (
    <aside className="help scroll" aria-label="Help for the node">
      <div className="help-bar">
        <h2>{definition?.title ?? 'Help for the node'}</h2>
        <IconButton icon="close" label="Close the help" keys={keys} small onPress={() => ui.setState({ help: false })} />
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
      <Facts title="Takes" entries={portEntries(inputs, inputFacts)} />
      <Facts title="Gives" entries={portEntries(outputs, outputFacts)} />
      <Facts
        title="Values"
        entries={Object.entries(params).map(([name, param]) => ({
          name,
          label: param.label,
          facts: [...paramFacts(param), ...(canBeWired(param) ? ['can be wired'] : [])],
          doc: param.doc,
        }))}
      />
      <Facts
        title="Needs"
        entries={needs.map((need) => ({
          name: need.capability,
          label: need.capability.replaceAll('-', ' '),
          facts: needFacts(definition, need),
          doc: `${need.why}. Without it: ${need.without}`,
        }))}
      />
      {keywords.length > 0 && <p className="help-note">Also found as {keywords.join(', ')}.</p>}
      {credit !== undefined && <p className="help-note">By {credit}</p>}
      {licence !== undefined && <p className="help-note">Licence: {licence}</p>}
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

/** Of inputs, or of outputs. */
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

/** Projects that come with Scrim and use the node. */
function Examples({ type }: { readonly type: string }) {
  const editor = useEditor();
  const all = useDocument((state) => state.examples);
  const examples = all.filter(({ types }) => types.includes(type)).slice(0, MOST_EXAMPLES);
  if (examples.length === 0) return null;
  return (
    <section>
      <h3>In use</h3>
      <ul className="help-examples">
        {examples.map(({ path, title, picture }) => (
          <li key={path}>
            <PictureCard
              purpose="Open the example"
              title={title}
              picture={picture}
              disabled={false}
              onPress={() => withoutUnsaved(editor, () => void openPath(editor, path))}
            />
          </li>
        ))}
      </ul>
    </section>
  );
}
