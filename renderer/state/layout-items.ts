import { type Change, inTurn } from '../../export/graph/commands/change.ts';
import { moveNodes, putFrame, putNote, removeFromLayout } from '../../export/graph/commands/layout.ts';
import { makeLayoutId } from '../../export/graph/names.ts';
import { own } from '../../export/graph/own.ts';
import type { Frame, GraphLayout, Note, Project } from '../../export/graph/project.ts';
import { apply, endGesture } from './apply.ts';
import { boxesOf, type NodeBox } from './arrange.ts';
import type { Place } from './canvas.ts';
import { layoutOf } from './document.ts';
import type { Editor } from './editor.ts';
import { selectOnly } from './selection.ts';

/**
 * Frames and notes, which stand on the canvas beside the nodes. There they are called `frame:ID` and `note:ID`: no node's id has a
 * colon.
 */
export type ItemKind = 'frame' | 'note';

export interface Box extends Place {
  readonly width: number;
  readonly height: number;
}

const FRAME_MARGIN = 24;
const FRAME_HEAD = 36;
const NOTE_SIZE = { width: 200, height: 96 };
const EMPTY_FRAME = { width: 360, height: 240 };

export function itemId(kind: ItemKind, id: string): string {
  return `${kind}:${id}`;
}

export function itemOf(canvasId: string): { readonly kind: ItemKind; readonly id: string } | null {
  const [kind, id] = canvasId.split(':');
  return (kind === 'frame' || kind === 'note') && id !== undefined ? { kind, id } : null;
}

export function itemIds({ frames, notes }: GraphLayout): readonly string[] {
  return [...Object.keys(frames).map((id) => itemId('frame', id)), ...Object.keys(notes).map((id) => itemId('note', id))];
}

export function boxOfItem(layout: GraphLayout, canvasId: string): Box | undefined {
  const item = itemOf(canvasId);
  return item === null ? undefined : own<Frame | Note>(item.kind === 'frame' ? layout.frames : layout.notes, item.id);
}

/** Puts a frame around the selected nodes; at a place where none is. */
export function addFrame(editor: Editor, place: Place): boolean {
  const { project, graph } = editor.document.getState();
  const selected = editor.selection.getState().nodes;
  const around = boxAround(boxesOf(editor, (id) => selected.has(id)));
  const id = makeLayoutId(project, graph, 'frame', editor.random);
  const frame: Frame = { ...(around ?? { ...place, ...EMPTY_FRAME }), title: 'Frame' };
  if (!apply(editor, 'Add a frame', putFrame(project, { graph, id, frame }))) return false;
  selectOnly(editor.selection, [], [], [itemId('frame', id)]);
  return true;
}

export function addNote(editor: Editor, place: Place): boolean {
  const { project, graph } = editor.document.getState();
  const id = makeLayoutId(project, graph, 'note', editor.random);
  if (!apply(editor, 'Add a note', putNote(project, { graph, id, note: { ...place, ...NOTE_SIZE, text: '' } }))) return false;
  selectOnly(editor.selection, [], [], [itemId('note', id)]);
  return true;
}

/** Title of a frame, text of a note. Typing is one step until `endGesture`. */
export function editItemText(editor: Editor, canvasId: string, text: string): boolean {
  const { project, graph } = editor.document.getState();
  return apply(editor, 'Write', put(editor, canvasId, { text })(project), `text ${graph} ${canvasId}`);
}

export function resizeItem(editor: Editor, canvasId: string, box: Box): boolean {
  endGesture(editor);
  return apply(editor, 'Resize', put(editor, canvasId, { box })(editor.document.getState().project));
}

/** The nodes, frames and notes that lie wholly in a frame, and go where it goes. */
export function contentOf(editor: Editor, canvasId: string): Readonly<Record<string, Place>> {
  const layout = layoutOf(editor.document.getState());
  const frame = itemOf(canvasId)?.kind === 'frame' ? boxOfItem(layout, canvasId) : undefined;
  if (!frame) return {};
  const items = [
    ...Object.entries(layout.frames).map(([id, box]) => ({ ...box, id: itemId('frame', id) })),
    ...Object.entries(layout.notes).map(([id, box]) => ({ ...box, id: itemId('note', id) })),
  ];
  const inside = [...boxesOf(editor, () => true), ...items].filter((box) => box.id !== canvasId && isIn(box, frame));
  return Object.fromEntries(inside.map(({ id, x, y }) => [id, { x, y }]));
}

/** Moves nodes, frames and notes, as one step. */
export function moveAll(editor: Editor, places: Readonly<Record<string, Place>>): boolean {
  const { project, graph } = editor.document.getState();
  const entries = Object.entries(places);
  const nodes = Object.fromEntries(entries.filter(([id]) => itemOf(id) === null));
  const items = entries.filter(([id]) => itemOf(id) !== null);
  const change = inTurn(
    project,
    (before) => moveNodes(before, { graph, positions: nodes }),
    ...items.map(([id, place]) => put(editor, id, { place })),
  );
  return apply(editor, 'Move', change, `move ${Object.keys(places).sort().join(' ')}`);
}

export function removeItems(editor: Editor, canvasIds: Iterable<string>): (project: Project) => Change {
  const { graph } = editor.document.getState();
  const items = [...canvasIds].flatMap((id) => itemOf(id) ?? []);
  const ids = (wanted: ItemKind) => items.filter(({ kind }) => kind === wanted).map(({ id }) => id);
  return (project) => removeFromLayout(project, { graph, frames: ids('frame'), notes: ids('note') });
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
    const frame = item?.kind === 'frame' ? own(layout.frames, item.id) : undefined;
    if (item && frame)
      return putFrame(project, { graph, id: item.id, frame: { ...frame, ...moved, ...(text === undefined ? {} : { title: text }) } });
    const note = item?.kind === 'note' ? own(layout.notes, item.id) : undefined;
    if (item && note) return putNote(project, { graph, id: item.id, note: { ...note, ...moved, ...(text === undefined ? {} : { text }) } });
    return inTurn(project);
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
