import { type Change, sequence } from '../../../export/graph/commands/change.ts';
import { addNode } from '../../../export/graph/commands/node-commands.ts';
import { connect } from '../../../export/graph/commands/wire-commands.ts';
import { makeNodeId } from '../../../export/graph/document-names.ts';
import { routeOf } from '../../../export/graph/routes.ts';
import { printWire } from '../../../export/graph/wires.ts';
import { graphOf, layoutOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { carriesObjects, TRANSFORM } from '../editor/gizmo-target.ts';
import { placeFreely } from './free-places.ts';
import { replaceSource, spaceOnWire } from './insert-on-wire.ts';

/**
 * A Transform between the objects of a node and all that they go to, with its id.
 *
 * @throws Error if no wire carries objects of the node
 */
export function transformAfter(editor: Editor, node: string): { readonly id: string; readonly change: Change } {
  const state = editor.document.getState();
  const { project, library, graph } = state;
  const layout = layoutOf(state);
  const id = makeNodeId(project, TRANSFORM, editor.random);
  const wires = graphOf(state).wires.filter(({ from }) => from.node === node && carriesObjects(state, from));
  const [first] = wires;
  if (!first) throw new Error(`The objects of ${node} are not connected.`);
  const moved = wires.filter(({ from }) => from.port === first.from.port);
  const change = sequence(
    project,
    (before) => addNode(before, { library, graph, id, type: TRANSFORM, ...(layout.nodes[node] ?? { x: 0, y: 0 }) }),
    ...moved.map((wire) => replaceSource(editor, wire, { from: { node: id, port: 'objects' }, to: wire.to, route: routeOf(layout, wire) })),
    (before) => connect(before, { library, graph, from: first.from, to: { node: id, port: 'objects' } }),
    spaceOnWire(editor, id, printWire(first)),
    placeFreely(project, { library, graph, hasThumbnail: editor.preferences.getState().thumbnails }),
  );
  return { id, change };
}
