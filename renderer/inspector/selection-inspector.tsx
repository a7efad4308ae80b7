import { useStore } from 'zustand';
import { runCommand } from '../state/commands/app-commands.ts';
import { withTitles } from '../state/document/message-titles.ts';
import { titleOf } from '../state/editor/document.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { selectOnly } from '../state/editor/selection.ts';
import { Button } from '../ui/button.tsx';

/** Inspector of several selected nodes: their types, and actions on all of them. */
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
    </>
  );
}

function counted(count: number, word: string): string {
  return count === 0 ? '' : `${count} ${word}${count === 1 ? '' : 's'}`;
}
