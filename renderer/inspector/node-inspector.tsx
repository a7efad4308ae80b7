import { useMemo } from 'react';
import { useStore } from 'zustand';
import { subgraphName } from '../../export/graph/document-names.ts';
import { replacedParams } from '../../export/graph/library/replaced-params.ts';
import type { Binding } from '../../export/graph/project.ts';
import { getOwn } from '../../export/graph/record.ts';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import { runCommand } from '../state/commands/app-commands.ts';
import { useKeys } from '../state/commands/command-item.ts';
import { shaderOf } from '../state/document/edit-shader.ts';
import { graphOf, nodeOf, titleOf } from '../state/editor/document.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { toggleMuted } from '../state/graph/edit-graph.ts';
import { categoryOf } from '../state/graph/palette-search.ts';
import { isOfOneLamp } from '../state/lamps/edit-lamps.ts';
import { LAMPS_TYPE } from '../state/lamps/lamp-source.ts';
import { goToProblem, isAboutNode } from '../state/problems/problems.ts';
import { useProblems } from '../state/problems/use-problems.ts';
import { Button, IconButton } from '../ui/button.tsx';
import { DocText } from '../ui/doc-text.tsx';
import { Icon } from '../ui/icon.tsx';
import { ExposedSection } from './exposed-section.tsx';
import { InputsSection } from './inputs-section.tsx';
import { LampsSection } from './lamps-section.tsx';
import { ParamRow } from './param-row.tsx';
import { PassesSection } from './passes-section.tsx';
import { ReplacedRow } from './replaced-row.tsx';
import { SubgraphSection } from './subgraph-section.tsx';
import { TrueSizeSection } from './true-size-section.tsx';

/** Nodes that show a place of the real world, whose file may not have its true size. */
const HAS_TRUE_SIZE = new Set(['source/capture', 'source/splats']);

export function NodeInspector({ id }: { readonly id: string }) {
  const node = useDocument((state) => nodeOf(state, id));
  const definition = useDocument((state) => (node === undefined ? undefined : state.library.definition(node.type)));
  const allWires = useDocument((state) => graphOf(state).wires);
  const wires = useMemo(() => allWires.filter(({ to }) => to.node === id), [allWires, id]);
  if (node === undefined) return null;
  if (definition === undefined) {
    return (
      <div className="inspector-head">
        <h2>{node.type}</h2>
        <p className="inspector-note">This version of Scrim does not have the node type. The node keeps its wires and parameters.</p>
      </div>
    );
  }
  const subgraph = subgraphName(node.type);
  return (
    <>
      <Head id={id} definition={definition} muted={node.muted ?? false} />
      <Problems id={id} />
      {node.type === 'source/panorama-capture' && <TakePanorama params={node.params} />}
      {subgraph !== null && <SubgraphSection name={subgraph} />}
      <InputsSection node={id} definition={definition} wires={wires} />
      {node.type === LAMPS_TYPE && <LampsSection id={id} />}
      <Params id={id} definition={definition} params={node.params} sourceOf={(name) => wires.find(({ to }) => to.port === name)?.from} />
      {HAS_TRUE_SIZE.has(node.type) && <TrueSizeSection id={id} />}
      <ExposedSection node={id} definition={definition} />
      {definition.lowering.kind === 'image' && <PassesSection id={id} />}
      {node.unfused === true && <Unfused />}
      <Facts definition={definition} />
    </>
  );
}

function Head({ id, definition, muted }: { readonly id: string; readonly definition: NodeDefinition; readonly muted: boolean }) {
  const editor = useEditor();
  const title = useDocument((state) => titleOf(state, id));
  const hasShader = useDocument((state) => shaderOf(state, id) !== null);
  const muteKeys = useKeys('edit.mute');
  const codeOpen = useStore(editor.ui, (state) => state.bottom === 'code');
  return (
    <header className="inspector-head">
      <div className="inspector-title">
        <h2>{title}</h2>
        <IconButton
          icon="mute"
          label={muted ? 'Unmute' : 'Mute'}
          keys={muteKeys}
          pressed={muted}
          small
          onPress={() => void toggleMuted(editor)}
        />
      </div>
      <p className="inspector-kind">
        {title === definition.title ? '' : `${definition.title} · `}
        {categoryOf(definition)} <code>{id}</code>
      </p>
      <DocText text={definition.doc} />
      {hasShader && !codeOpen && (
        <Button icon="code" onPress={() => runCommand(editor, 'view.code')}>
          Edit shader
        </Button>
      )}
    </header>
  );
}

function Problems({ id }: { readonly id: string }) {
  const editor = useEditor();
  const problems = useProblems().filter((problem) => isAboutNode(problem, editor.document.getState(), id));
  if (problems.length === 0) return null;
  return (
    <ul className="inspector-problems">
      {problems.map((problem) => (
        <li key={`${problem.code} ${problem.message} ${problem.line ?? 0}`}>
          <button type="button" className={`problem-card problem-card-${problem.severity}`} onClick={() => goToProblem(editor, problem)}>
            <Icon name={problem.severity} />
            <span>
              {problem.message}
              {problem.fix !== undefined && <span className="problem-fix"> {problem.fix}</span>}
            </span>
          </button>
        </li>
      ))}
    </ul>
  );
}

/** Takes the panorama in the emulated room of the preview. */
function TakePanorama({ params }: { readonly params: Readonly<Record<string, Binding>> }) {
  const { transport } = useEditor();
  const { size } = params;
  // The default of the param.
  const widthPx = size !== undefined && 'value' in size ? Number(size.value) : 1024;
  return (
    <section className="inspector-section" aria-label="Panorama">
      <Button icon="room" onPress={() => transport.post({ kind: 'take-panorama', widthPx })}>
        Take panorama in the preview
      </Button>
      <p className="inspector-note">In an emulated room, the preview turns to all targets by itself. On a page, visitors do it.</p>
    </section>
  );
}

interface ParamsProps {
  readonly id: string;
  readonly definition: NodeDefinition;
  readonly params: Readonly<Record<string, Binding>>;
  readonly sourceOf: (name: string) => { readonly node: string; readonly port: string } | undefined;
}

function Params({ id, definition, params, sourceOf }: ParamsProps) {
  const entries = Object.entries(definition.params).filter(([name]) => definition.type !== LAMPS_TYPE || !isOfOneLamp(name));
  if (entries.length === 0) return null;
  const replaced = replacedParams(definition, (port) => sourceOf(port) !== undefined);
  return (
    <section className="inspector-section" aria-label="Parameters">
      <h3>Parameters</h3>
      {entries.map(([name, param]) => {
        const input = definition.inputs[replaced.get(name) ?? ''];
        if (input) return <ReplacedRow key={name} name={name} param={param} input={input.label} />;
        return <ParamRow key={name} node={id} name={name} param={param} binding={getOwn(params, name)} source={sourceOf(name)} />;
      })}
    </section>
  );
}

/** Says that fusion is turned off for the node. */
function Unfused() {
  const editor = useEditor();
  return (
    <section className="inspector-section" aria-label="Fusion">
      <p className="inspector-note">In exported pages, the passes of this node are not fused with others.</p>
      <Button onPress={() => runCommand(editor, 'edit.unfuse')}>Fuse passes</Button>
    </section>
  );
}

/** Features that the node needs of a device, credit and license. */
function Facts({ definition: { needs = [], credit, licence } }: { readonly definition: NodeDefinition }) {
  if (needs.length === 0 && credit === undefined && licence === undefined) return null;
  return (
    <section className="inspector-section" aria-label="About">
      {needs.length > 0 && <h3>Device features</h3>}
      {needs.map((need) => (
        <p key={need.capability} className="inspector-note">
          <strong>{need.capability.replaceAll('-', ' ')}</strong>: {need.why}. Without it: {need.without}
        </p>
      ))}
      {credit !== undefined && <h3>Credit</h3>}
      {credit !== undefined && <p className="inspector-note">{credit}</p>}
      {licence !== undefined && <h3>License</h3>}
      {licence !== undefined && <p className="inspector-note">{licence}</p>}
    </section>
  );
}
