import { isShadertoy } from '../../export/glsl/shadertoy/convert-shadertoy.ts';
import { type Change, inTurn, unchanged } from '../../export/graph/commands/change.ts';
import { addNode, removeNodes } from '../../export/graph/commands/nodes.ts';
import { bindParam } from '../../export/graph/commands/params.ts';
import { connect } from '../../export/graph/commands/wires.ts';
import { makeNodeId } from '../../export/graph/names.ts';
import { own } from '../../export/graph/own.ts';
import type { GraphNode, Project, Wire } from '../../export/graph/project.ts';
import { apply } from './apply.ts';
import type { Place } from './canvas.ts';
import { graphOf, layoutOf, titleOf } from './document.ts';
import type { Editor } from './editor.ts';
import { importShadertoy } from './import-shadertoy.ts';
import { selectOnly } from './selection.ts';
import { addToast } from './ui.ts';

/** Nodes and the wires among them, as text that another window can take. */
export interface Clipping {
  readonly format: 'scrim-nodes';
  readonly version: 1;
  readonly nodes: Readonly<Record<string, GraphNode & Place>>;
  readonly wires: readonly Wire[];
}

const OFFSET_PX = 32;

/** The selected nodes; null where none is. */
export function clipSelection(editor: Editor): Clipping | null {
  const state = editor.document.getState();
  const graph = graphOf(state);
  const layout = layoutOf(state);
  const ids = [...editor.selection.getState().nodes].sort();
  if (ids.length === 0) return null;
  const nodes: Record<string, GraphNode & Place> = {};
  for (const id of ids) {
    const node = own(graph.nodes, id);
    const place = own(layout.nodes, id);
    if (node) nodes[id] = { ...node, x: place?.x ?? 0, y: place?.y ?? 0 };
  }
  return { format: 'scrim-nodes', version: 1, nodes, wires: graph.wires.filter(({ from, to }) => nodes[from.node] && nodes[to.node]) };
}

/** Null where the text is no clipping. What is in it is judged by the commands that add it. */
export function parseClipping(text: string): Clipping | null {
  try {
    const clipping = JSON.parse(text) as Partial<Clipping> | null;
    const whole = clipping?.format === 'scrim-nodes' && clipping.version === 1 && Array.isArray(clipping.wires);
    return whole && typeof clipping.nodes === 'object' && clipping.nodes !== null ? (clipping as Clipping) : null;
  } catch {
    return null;
  }
}

/** Adds copies under new ids, wired as the originals are among themselves, and selects them. One step. */
export function pasteClipping(editor: Editor, { nodes, wires }: Clipping, label: string, offset: Place): boolean {
  const { project, library, graph } = editor.document.getState();
  const ids = new Map<string, string>();
  const made = inTurn(
    project,
    ...Object.entries(nodes).map(([old, node]) => (before: Project): Change => {
      const id = makeNodeId(before, node.type, editor.random);
      ids.set(old, id);
      return inTurn(
        before,
        (p) => addNode(p, { library, graph, id, type: node.type, x: node.x + offset.x, y: node.y + offset.y }),
        ...Object.entries(node.params).map(
          ([param, binding]) =>
            (p: Project) =>
              bindParam(p, { library, graph, node: id, param, binding }),
        ),
      );
    }),
    ...wires.map(({ from, to }) => (before: Project): Change => {
      const fromId = ids.get(from.node);
      const toId = ids.get(to.node);
      if (fromId === undefined || toId === undefined) return unchanged(before);
      return connect(before, { library, graph, from: { node: fromId, port: from.port }, to: { node: toId, port: to.port } });
    }),
  );
  if (!apply(editor, label, made)) return false;
  selectOnly(editor.selection, ids.values());
  return true;
}

export function duplicateSelection(editor: Editor): boolean {
  const clipping = clipSelection(editor);
  if (clipping === null) return false;
  const [only] = Object.keys(clipping.nodes).length === 1 ? Object.keys(clipping.nodes) : [];
  const what = only === undefined ? `${Object.keys(clipping.nodes).length} nodes` : titleOf(editor.document.getState(), only);
  return pasteClipping(editor, clipping, `Duplicate ${what}`, { x: OFFSET_PX, y: OFFSET_PX });
}

export async function copySelection(editor: Editor): Promise<boolean> {
  const clipping = clipSelection(editor);
  if (clipping === null) return false;
  return editor.clipboard.write(JSON.stringify(clipping)).then(
    () => true,
    () => {
      addToast(editor.ui, { tone: 'error', text: 'The browser did not let Scrim use the clipboard.' });
      return false;
    },
  );
}

export async function cutSelection(editor: Editor): Promise<void> {
  const nodes = [...editor.selection.getState().nodes];
  if (!(await copySelection(editor))) return;
  const { project, library, graph } = editor.document.getState();
  apply(editor, 'Cut', removeNodes(project, { library, graph, nodes }));
}

export async function pasteFromClipboard(editor: Editor): Promise<void> {
  const text = await editor.clipboard.read().catch(() => '');
  if (!pasteText(editor, text)) addToast(editor.ui, { tone: 'info', text: 'There are no nodes on the clipboard.' });
}

/** Nodes become copies of them, a source of shadertoy.com a shader and its node. Whether the text is one of these. */
export function pasteText(editor: Editor, text: string): boolean {
  const clipping = parseClipping(text);
  if (clipping !== null) pasteClipping(editor, clipping, 'Paste', { x: OFFSET_PX, y: OFFSET_PX });
  else if (isShadertoy(text)) importShadertoy(editor, { source: text, name: 'Shadertoy' });
  else return false;
  return true;
}
