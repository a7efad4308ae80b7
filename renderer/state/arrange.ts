import { moveNodes } from '../../export/graph/commands/layout.ts';
import { own } from '../../export/graph/own.ts';
import { nodeShape } from '../canvas/node-shape.ts';
import { apply } from './apply.ts';
import type { Place } from './canvas.ts';
import { graphOf, layoutOf } from './document.ts';
import type { Editor } from './editor.ts';
import { revealNodes } from './ui.ts';

/** Where a node stands, and how large it is drawn. Canvas units. */
export interface NodeBox extends Place {
  readonly id: string;
  readonly width: number;
  readonly height: number;
}

export type Alignment = 'left' | 'centre' | 'right' | 'top' | 'middle' | 'bottom';

/** The selected nodes; all of the open graph where fewer than two are. */
export function boxesToArrange(editor: Editor): readonly NodeBox[] {
  const selected = editor.selection.getState().nodes;
  return boxesOf(editor, selected.size > 1 ? (id) => selected.has(id) : () => true);
}

export function selectedBoxes(editor: Editor): readonly NodeBox[] {
  const selected = editor.selection.getState().nodes;
  return boxesOf(editor, (id) => selected.has(id));
}

const NO_PORTS: ReadonlySet<string> = new Set();

export function boxesOf(editor: Editor, isWanted: (id: string) => boolean): readonly NodeBox[] {
  const state = editor.document.getState();
  const { nodes, wires } = graphOf(state);
  const places = layoutOf(state).nodes;
  const { expanded } = editor.canvas.getState();
  const { thumbnails: pictured } = editor.look.getState();
  const wiredOf = new Map<string, Set<string>>();
  for (const { to } of wires) wiredOf.set(to.node, (wiredOf.get(to.node) ?? new Set()).add(to.port));
  return Object.entries(nodes)
    .filter(([id]) => isWanted(id))
    .map(([id, node]) => {
      const definition = state.library.definition(node.type);
      const wired = wiredOf.get(id) ?? NO_PORTS;
      const options = { wired, expanded: expanded.has(id), collapsed: own(places, id)?.collapsed === true, pictured };
      const { width, height } = definition ? nodeShape(definition, node, options) : { width: 184, height: 64 };
      const { x, y } = own(places, id) ?? { x: 0, y: 0 };
      return { id, x, y, width, height };
    });
}

/** Brings edges or middles of the selected nodes onto one line. */
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
      case 'centre':
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

/** Makes the gaps between the selected nodes alike; the outermost stay. */
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

/** Lays the selected nodes, or the whole graph, out from left to right along the wires. Loads what it takes when it is asked for. */
export async function tidy(editor: Editor): Promise<boolean> {
  const boxes = boxesToArrange(editor);
  const { wires } = graphOf(editor.document.getState());
  const { layOut } = await import('./lay-out.ts');
  const places = await layOut(boxes, wires);
  const moved = move(editor, 'Tidy up', boxes, (box) => places.get(box.id) ?? box);
  // All of it has gone elsewhere: what was looked at may be out of sight.
  if (moved && boxes.length === Object.keys(graphOf(editor.document.getState()).nodes).length) revealNodes(editor.ui, [], 'fit');
  return moved;
}

function move(editor: Editor, label: string, boxes: readonly NodeBox[], placed: (box: NodeBox) => Place): boolean {
  const { project, graph } = editor.document.getState();
  const positions = Object.fromEntries(
    boxes.map((box) => {
      const { x, y } = placed(box);
      return [box.id, { x, y }];
    }),
  );
  return apply(editor, label, moveNodes(project, { graph, positions }));
}
