import { useId } from 'react';
import { useStore } from 'zustand';
import { runCommand } from '../state/commands/app-commands.ts';
import { withTitles } from '../state/document/message-titles.ts';
import { useUndoGroup } from '../state/document/use-undo-group.ts';
import { graphOf, titleOf } from '../state/editor/document.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { selectOnly } from '../state/editor/selection.ts';
import { showParamCandidate } from '../state/params/param-candidates.ts';
import { editShared, type SharedParam, sharedParams } from '../state/params/shared-params.ts';
import { Button } from '../ui/button.tsx';
import { ParamControl, rowClass } from './param-control.tsx';

/** Inspector of several selected nodes: their types, the params that they share, and actions on all of them. */
export function SelectionInspector() {
  const editor = useEditor();
  const { nodes, wires } = useStore(editor.selection);
  const state = useDocument((document) => document);
  return (
    <>
      <header className="inspector-head">
        <h2>{[counted(nodes.size, 'node'), counted(wires.size, 'wire')].filter(Boolean).join(', ')}</h2>
      </header>
      <section className="inspector-section" aria-label="Selected">
        <ul className="selected-list">
          {[...nodes].map((id) => (
            <li key={id}>
              <button type="button" onClick={() => selectOnly(editor.selection, [id])}>
                {titleOf(state, id)} <code>{id}</code>
              </button>
            </li>
          ))}
          {[...wires].map((id) => (
            <li key={id}>{withTitles(state, id.replace('->', '→'))}</li>
          ))}
        </ul>
        <div className="inspector-actions">
          {nodes.size > 0 && <Button onPress={() => runCommand(editor, 'edit.duplicate')}>Duplicate</Button>}
          {nodes.size > 0 && <Button onPress={() => runCommand(editor, 'edit.mute')}>Mute</Button>}
          <Button look="danger" icon="trash" onPress={() => runCommand(editor, 'edit.delete')}>
            Delete
          </Button>
        </div>
      </section>
      <SharedParams nodes={[...nodes]} />
    </>
  );
}

/** Params of all selected nodes. An edit sets the value in each of them. */
function SharedParams({ nodes }: { readonly nodes: readonly string[] }) {
  const graph = useDocument(graphOf);
  const library = useDocument((state) => state.library);
  const shared = sharedParams(graph, library, nodes);
  if (shared.length === 0) return null;
  return (
    <section className="inspector-section" aria-label="Parameters of all">
      <h3>Parameters of all</h3>
      {shared.map((param) => (
        <SharedRow key={`${param.name} ${nodes.join()}`} nodes={nodes} shared={param} />
      ))}
    </section>
  );
}

function SharedRow({ nodes, shared }: { readonly nodes: readonly string[]; readonly shared: SharedParam }) {
  const editor = useEditor();
  const id = useId();
  const { param, value, mixed } = shared;
  const gesture = useUndoGroup((next) => void editShared(editor, nodes, shared, next));
  return (
    <fieldset className={rowClass(param)} aria-label={param.label} data-param={shared.name}>
      <label htmlFor={id} className="param-label" data-tip={param.doc}>
        <span>{param.label}</span>
      </label>
      <div className="param-control">
        <ParamControl
          id={id}
          param={param}
          value={value}
          {...gesture}
          onExpression={() => false}
          onPoint={(choice) => showParamCandidate(editor, nodes, shared.name, choice)}
        />
      </div>
      <span className="param-actions">
        {mixed && (
          <span className="param-mixed" data-tip="The nodes have different values. The one shown is that of the first.">
            Mixed
          </span>
        )}
      </span>
    </fieldset>
  );
}

function counted(count: number, word: string): string {
  return count === 0 ? '' : `${count} ${word}${count === 1 ? '' : 's'}`;
}
