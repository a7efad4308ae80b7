import { type Change, sequence } from '../../../export/graph/commands/change.ts';
import { moveNodes, putFrame, putNote, removeFromLayout } from '../../../export/graph/commands/layout-commands.ts';
import { makeLayoutId } from '../../../export/graph/document-names.ts';
import type { Frame, GraphLayout, Note, Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { apply, endGesture } from '../document/apply.ts';
import type { Place } from '../editor/canvas-state.ts';
import { layoutOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { byKind, type ItemKind, idsOfKind, itemId, itemOf } from '../editor/item-ids.ts';
import { selectOnly } from '../editor/selection.ts';
import { bareBoxesOf, boxesOf } from './arrange.ts';
import type { NodeBox } from './auto-layout.ts';

export interface Box extends Place {
  readonly width: number;
  readonly height: number;
}

const FRAME_MARGIN = 24;
const FRAME_HEAD = 36;
const NOTE_SIZE = { width: 200, height: 96 };
const EMPTY_FRAME = { width: 360, height: 240 };

export function boxOfItem(layout: GraphLayout, canvasId: string): Box | undefined {
  const item = itemOf(canvasId);
  return item === null || item.kind === 'reroute' ? undefined : getOwn<Frame | Note>(layout[`${item.kind}s`], item.id);
}

/** Adds a frame around the selected nodes; if none are selected, an empty one at the place. */
export function addFrame(editor: Editor, place: Place): boolean {
  const { project, graph } = editor.document.getState();
  const selected = editor.selection.getState().nodes;
  const around = boxAround(boxesOf(editor, (id) => selected.has(id)));
  const id = makeLayoutId(project, graph, 'frame', editor.random);
  const frame: Frame = { ...(around ?? { ...place, ...EMPTY_FRAME }), title: 'Frame' };
  if (!apply(editor, 'Add frame', putFrame(project, { graph, id, frame }))) return false;
  selectOnly(editor.selection, [], [], [itemId('frame', id)]);
  return true;
}

export function addNote(editor: Editor, place: Place): boolean {
  const { project, graph } = editor.document.getState();
  const id = makeLayoutId(project, graph, 'note', editor.random);
  if (!apply(editor, 'Add note', putNote(project, { graph, id, note: { ...place, ...NOTE_SIZE, text: '' } }))) return false;
  selectOnly(editor.selection, [], [], [itemId('note', id)]);
  return true;
}

/** Sets the title of a frame or the text of a note. Successive edits form one undo step until `endGesture`. */
export function editItemText(editor: Editor, canvasId: string, text: string): boolean {
  const { project, graph } = editor.document.getState();
  return apply(editor, 'Edit text', put(editor, canvasId, { text })(project), `text ${graph} ${canvasId}`);
}

export function resizeItem(editor: Editor, canvasId: string, box: Box): boolean {
  endGesture(editor);
  return apply(editor, 'Resize frame or note', put(editor, canvasId, { box })(editor.document.getState().project));
}

/** The items that lie completely inside a frame and move with it. */
export function contentOf(editor: Editor, canvasId: string): Readonly<Record<string, Place>> {
  const layout = layoutOf(editor.document.getState());
  const frame = itemOf(canvasId)?.kind === 'frame' ? boxOfItem(layout, canvasId) : undefined;
  if (!frame) return {};
  const items = [
    ...Object.entries(layout.frames).map(([id, box]) => ({ ...box, id: itemId('frame', id) })),
    ...Object.entries(layout.notes).map(([id, box]) => ({ ...box, id: itemId('note', id) })),
    ...Object.entries(layout.reroutes).map(([id, place]) => ({ ...place, width: 0, height: 0, id: itemId('reroute', id) })),
  ];
  const inside = [...bareBoxesOf(editor), ...items].filter((box) => box.id !== canvasId && isIn(box, frame));
  return Object.fromEntries(inside.map(({ id, x, y }) => [id, { x, y }]));
}

/** Moves nodes, frames, notes, reroutes and borders as one undo step. */
export function moveAll(editor: Editor, places: Readonly<Record<string, Place>>): boolean {
  const { project, graph } = editor.document.getState();
  const boxes = Object.entries(places).filter(([id]) => boxOfItem(layoutOf(editor.document.getState()), id) !== undefined);
  const change = sequence(
    project,
    (before) => moveNodes(before, { graph, ...byKind(places) }),
    ...boxes.map(([id, place]) => put(editor, id, { place })),
  );
  return apply(editor, 'Move', change, `move ${Object.keys(places).sort().join(' ')}`);
}

export function removeItems(editor: Editor, canvasIds: ReadonlySet<string>): (project: Project) => Change {
  const { graph } = editor.document.getState();
  const ids = (wanted: ItemKind) => idsOfKind(canvasIds, wanted);
  return (project) => removeFromLayout(project, { graph, frames: ids('frame'), notes: ids('note'), reroutes: ids('reroute') });
}

interface ItemEdit {
  readonly text?: string;
  readonly box?: Box;
  readonly place?: Place;
}

function put(editor: Editor, canvasId: string, { text, box, place }: ItemEdit): (project: Project) => Change {
  const { graph } = editor.document.getState();
  const item = itemOf(canvasId);
  return (project) => {
    const layout = layoutOf({ project, graph });
    const moved = { ...(place && { x: place.x, y: place.y }), ...(box && { x: box.x, y: box.y, width: box.width, height: box.height }) };
    const frame = item?.kind === 'frame' ? getOwn(layout.frames, item.id) : undefined;
    if (item && frame)
      return putFrame(project, { graph, id: item.id, frame: { ...frame, ...moved, ...(text === undefined ? {} : { title: text }) } });
    const note = item?.kind === 'note' ? getOwn(layout.notes, item.id) : undefined;
    if (item && note) return putNote(project, { graph, id: item.id, note: { ...note, ...moved, ...(text === undefined ? {} : { text }) } });
    return sequence(project);
  };
}

function boxAround(boxes: readonly NodeBox[]): Box | null {
  if (boxes.length === 0) return null;
  const x = Math.min(...boxes.map((box) => box.x)) - FRAME_MARGIN;
  const y = Math.min(...boxes.map((box) => box.y)) - FRAME_MARGIN - FRAME_HEAD;
  const right = Math.max(...boxes.map((box) => box.x + box.width)) + FRAME_MARGIN;
  const bottom = Math.max(...boxes.map((box) => box.y + box.height)) + FRAME_MARGIN;
  return { x, y, width: right - x, height: bottom - y };
}

function isIn(inner: Box, outer: Box): boolean {
  return (
    inner.x >= outer.x &&
    inner.y >= outer.y &&
    inner.x + inner.width <= outer.x + outer.width &&
    inner.y + inner.height <= outer.y + outer.height
  );
}
