import type { PortAddress } from '../../export/graph/project.ts';
import { printWire } from '../../export/graph/wires.ts';
import { nodeOf, titleOf } from '../state/editor/document.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { selectOnly } from '../state/editor/selection.ts';
import { revealNodes } from '../state/editor/ui.ts';
import { removeWires } from '../state/graph/edit-graph.ts';
import { IconButton } from '../ui/button.tsx';
import { Icon } from '../ui/icon.tsx';

/** Source of a wire, with buttons that select its node and disconnect the wire. */
export function SourceLink({ from, to }: { readonly from: PortAddress; readonly to: PortAddress }) {
  const editor = useEditor();
  const title = useDocument((state) => titleOf(state, from.node));
  const port = useDocument(
    (state) => state.library.definition(nodeOf(state, from.node)?.type ?? '')?.outputs[from.port]?.label ?? from.port,
  );
  return (
    <span className="source-link">
      <button
        type="button"
        data-tip="Go to this node"
        onClick={() => {
          selectOnly(editor.selection, [from.node]);
          revealNodes(editor.ui, [from.node]);
        }}
      >
        <Icon name="link" size={14} />
        <span>
          {title} · {port}
        </span>
      </button>
      <IconButton icon="close" label={`Disconnect ${title}`} small onPress={() => void removeWires(editor, [printWire({ from, to })])} />
    </span>
  );
}
