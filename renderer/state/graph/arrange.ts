import { type MoveNodes, moveNodes } from '../../../export/graph/commands/layout-commands.ts';
import type { GraphLayout, PortAddress } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { routeOf, type Stretch, stretchesOf } from '../../../export/graph/routes.ts';
import { apply } from '../document/apply.ts';
import type { Place } from '../editor/canvas-state.ts';
import { graphOf, layoutOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { byKind, itemId, itemOf } from '../editor/item-ids.ts';
import { revealNodes } from '../editor/ui.ts';
import type { NodeBox } from './auto-layout.ts';
import { type NodeShape, nodeShape, portCenter, THUMBNAIL_HEIGHT, unknownShape } from './node-shape.ts';

export interface ShapedBox extends NodeBox {
  readonly shape: NodeShape;
}

export type Alignment = 'left' | 'center' | 'right' | 'top' | 'middle' | 'bottom';

/** The selected nodes and the reroutes of the wires among them; if fewer than two nodes are selected, all of the open graph. */
function boxesToArrange(editor: Editor): readonly NodeBox[] {
  const { nodes } = editor.selection.getState();
  const isAll = nodes.size < 2;
  const state = editor.document.getState();
  const layout = layoutOf(state);
  const among = graphOf(state).wires.filter(({ from, to }) => isAll || (nodes.has(from.node) && nodes.has(to.node)));
  const reroutes = new Set(among.flatMap((wire) => routeOf(layout, wire)));
  return [...boxesOf(editor, (id) => isAll || nodes.has(id)), ...rerouteBoxes(layout, (id) => reroutes.has(id))];
}

/** The selected nodes and reroutes. */
export function selectedBoxes(editor: Editor): readonly NodeBox[] {
  const { nodes, items } = editor.selection.getState();
  const reroutes = rerouteBoxes(layoutOf(editor.document.getState()), (id) => items.has(itemId('reroute', id)));
  return [...boxesOf(editor, (id) => nodes.has(id)), ...reroutes];
}

/** Reroutes as boxes without size, by canvas id. */
function rerouteBoxes({ reroutes }: GraphLayout, isWanted: (id: string) => boolean): readonly NodeBox[] {
  const wanted = Object.entries(reroutes).filter(([id]) => isWanted(id));
  return wanted.map(([id, { x, y }]) => ({ id: itemId('reroute', id), x, y, width: 0, height: 0 }));
}

/** Position of a port in canvas units. */
export function portPlace(editor: Editor, { node, port }: PortAddress, side: 'input' | 'output'): Place | undefined {
  const [box] = boxesOf(editor, (id) => id === node);
  const seen = box?.shape.ports.find((candidate) => candidate.side === side && candidate.name === port);
  if (!box || !seen) return undefined;
  const center = portCenter(box.shape, seen);
  return { x: box.x + center.x, y: box.y + center.y };
}

const NO_PORTS: ReadonlySet<string> = new Set();
const BESIDE_THE_NODES = { inputs: null, outputs: null };

/** Nodes of the open graph as boxes, with their thumbnails at full height. */
export function boxesOf(editor: Editor, isWanted: (id: string) => boolean): readonly ShapedBox[] {
  return shapedBoxes(editor, isWanted, editor.preferences.getState().thumbnails ? THUMBNAIL_HEIGHT : 0);
}

/** Nodes of the open graph as boxes, without thumbnails. */
export function bareBoxesOf(editor: Editor): readonly ShapedBox[] {
  return shapedBoxes(editor, () => true, 0);
}

function shapedBoxes(editor: Editor, isWanted: (id: string) => boolean, thumbnailHeight: number): readonly ShapedBox[] {
  const state = editor.document.getState();
  const { nodes, wires } = graphOf(state);
  const places = layoutOf(state).nodes;
  const { expanded } = editor.canvas.getState();
  const wiredOf = new Map<string, Set<string>>();
  for (const { to } of wires) wiredOf.set(to.node, (wiredOf.get(to.node) ?? new Set()).add(to.port));
  return Object.entries(nodes)
    .filter(([id]) => isWanted(id))
    .map(([id, node]) => {
      const definition = state.library.definition(node.type);
      const wired = wiredOf.get(id) ?? NO_PORTS;
      const options = { wired, expanded: expanded.has(id), collapsed: getOwn(places, id)?.collapsed === true, thumbnailHeight };
      const shape = definition ? nodeShape(definition, node, options) : unknownShape([...wired], []);
      const { x, y } = getOwn(places, id) ?? { x: 0, y: 0 };
      return { id, x, y, width: shape.width, height: shape.height, shape };
    });
}

/** Aligns edges or centers of the selected nodes. */
export function align(editor: Editor, to: Alignment): boolean {
  const boxes = selectedBoxes(editor);
  const least = (of: (box: NodeBox) => number) => Math.min(...boxes.map(of));
  const most = (of: (box: NodeBox) => number) => Math.max(...boxes.map(of));
  const left = least(({ x }) => x);
  const right = most(({ x, width }) => x + width);
  const top = least(({ y }) => y);
  const bottom = most(({ y, height }) => y + height);
  const placed = ({ x, y, width, height }: NodeBox): Place => {
    switch (to) {
      case 'left':
        return { x: left, y };
      case 'center':
        return { x: (left + right - width) / 2, y };
      case 'right':
        return { x: right - width, y };
      case 'top':
        return { x, y: top };
      case 'middle':
        return { x, y: (top + bottom - height) / 2 };
      case 'bottom':
        return { x, y: bottom - height };
    }
  };
  return move(editor, 'Align', boxes, placed);
}

/** Makes the gaps between the selected nodes equal. The outermost nodes stay. */
export function distribute(editor: Editor, along: 'x' | 'y'): boolean {
  const size = along === 'x' ? 'width' : 'height';
  const boxes = [...selectedBoxes(editor)].sort((a, b) => a[along] - b[along]);
  const first = boxes[0];
  const last = boxes.at(-1);
  if (!first || !last || boxes.length < 3) return false;
  const filled = boxes.reduce((sum, box) => sum + box[size], 0);
  const gap = (last[along] + last[size] - first[along] - filled) / (boxes.length - 1);
  const places = new Map<string, number>();
  let at = first[along];
  for (const box of boxes) {
    places.set(box.id, at);
    at += box[size] + gap;
  }
  return move(editor, 'Distribute', boxes, (box) => ({ x: box.x, y: box.y, [along]: places.get(box.id) ?? box[along] }));
}

/** Arranges the selected nodes, or the whole graph, from left to right along the wires. Loads the layout library on demand. */
export async function tidy(editor: Editor): Promise<boolean> {
  const boxes = boxesToArrange(editor);
  const { graph } = editor.document.getState();
  const { wires } = graphOf(editor.document.getState());
  const layout = layoutOf(editor.document.getState());
  const { layOut } = await import('./auto-layout.ts');
  const places = await layOut(boxes, [...stretchesOf({ wires }, layout).values()].map(endsOf));
  // The layout takes time; another graph may be open by then.
  if (editor.document.getState().graph !== graph) return false;
  const isWhole = boxes.filter(({ id }) => itemOf(id) === null).length === Object.keys(graphOf(editor.document.getState()).nodes).length;
  const moved = move(editor, 'Tidy up', boxes, (box) => places.get(box.id) ?? box, isWhole ? BESIDE_THE_NODES : {});
  // The whole graph has moved, so the view may show empty canvas.
  if (moved && isWhole) revealNodes(editor.ui, [], 'fit');
  return moved;
}

/** Canvas ids of the two ends of a stretch. */
function endsOf({ source, wires, before, to }: Stretch): readonly [from: string, to: string] {
  const last = before.at(-1);
  return [last === undefined ? source.node : itemId('reroute', last), to === null ? wires[0].to.node : itemId('reroute', to)];
}

function move(
  editor: Editor,
  label: string,
  boxes: readonly NodeBox[],
  placed: (box: NodeBox) => Place,
  borders: MoveNodes['borders'] = {},
): boolean {
  const { project, graph } = editor.document.getState();
  const positions = Object.fromEntries(
    boxes.map((box) => {
      const { x, y } = placed(box);
      return [box.id, { x, y }];
    }),
  );
  return apply(editor, label, moveNodes(project, { graph, ...byKind(positions), borders }));
}
