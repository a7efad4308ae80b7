import { castDraft } from 'immer';
import { isEntryId } from '../document-names.ts';
import type { ExposedPorts, Frame, Note, Place, Project, Reroute } from '../project.ts';
import { getOwn } from '../record.ts';
import { type Change, change, graphOf } from './change.ts';
import { draftLayout } from './node-commands.ts';

/**
 * Options of `moveNodes`. The commands of this file change only `project.layout.json`. Coordinates are rounded to whole canvas units, so
 * that diffs stay short.
 */
export interface MoveNodes {
  readonly graph: string;
  readonly positions: Readonly<Record<string, { readonly x: number; readonly y: number }>>;
  /** Reroutes by id. */
  readonly reroutes?: Readonly<Record<string, Reroute>>;
  /** Places of the borders of a subgraph; null: beside the nodes again. */
  readonly borders?: Readonly<Partial<Record<keyof ExposedPorts, Place | null>>>;
}

/**
 * Moves nodes, reroutes and borders. Unknown ids are ignored.
 *
 * @returns The change; this command is never refused.
 *
 * @example
 * moveNodes(project, { graph: 'main', positions: { 'sepia-k7q2': { x: 240, y: 80 } } });
 */
export function moveNodes(project: Project, { graph, positions, reroutes = {}, borders = {} }: MoveNodes): Change {
  const { nodes } = graphOf(project, graph);
  return change(project, (draft) => {
    const layout = draftLayout(draft, graph).nodes;
    for (const [id, { x, y }] of Object.entries(positions)) {
      if (!getOwn(nodes, id)) continue;
      const place = layout[id];
      // Fields are assigned one by one, so that an unchanged position gives no patch.
      if (place) Object.assign(place, rounded({ x, y }));
      else layout[id] = rounded({ x, y });
    }
    for (const [id, place] of Object.entries(reroutes)) {
      const reroute = draft.layout[graph]?.reroutes[id];
      if (reroute) Object.assign(reroute, rounded(place));
    }
    for (const side of ['inputs', 'outputs'] as const) {
      const place = borders[side];
      if (place) moveBorder(draftLayout(draft, graph), side, rounded(place));
      else if (place === null) releaseBorder(draft.layout[graph], side);
    }
  });
}

function moveBorder(layout: ReturnType<typeof draftLayout>, side: keyof ExposedPorts, place: Place): void {
  const kept = layout.borders?.[side];
  if (kept) Object.assign(kept, place);
  else layout.borders = { ...layout.borders, [side]: place };
}

function releaseBorder(layout: ReturnType<typeof draftLayout> | undefined, side: keyof ExposedPorts): void {
  if (!layout?.borders?.[side]) return;
  const { [side]: _, ...kept } = layout.borders;
  if (Object.keys(kept).length > 0) layout.borders = kept;
  else delete layout.borders;
}

export interface SetCollapsed {
  readonly graph: string;
  readonly nodes: readonly string[];
  readonly collapsed: boolean;
}

/**
 * Collapses or expands nodes on the canvas.
 *
 * @returns The change; this command is never refused.
 *
 * @example
 * setCollapsed(project, { graph: 'main', nodes: ['sepia-k7q2'], collapsed: true });
 */
export function setCollapsed(project: Project, { graph, nodes, collapsed }: SetCollapsed): Change {
  return change(project, (draft) => {
    const layout = draftLayout(draft, graph).nodes;
    for (const id of nodes) {
      const place = layout[id];
      if (collapsed) layout[id] = { x: 0, y: 0, ...place, collapsed };
      else if (place) delete place.collapsed;
    }
  });
}

export interface PutFrame {
  readonly graph: string;
  /** From `makeLayoutId`, or the id of an existing node frame. */
  readonly id: string;
  readonly frame: Frame;
}

/**
 * Adds or replaces a node frame.
 *
 * @throws Error if `id` is not a layout id.
 *
 * @example
 * putFrame(project, { graph: 'main', id: makeLayoutId(project, 'main', 'frame', random), frame: { ...box, title: 'Fog' } });
 */
export function putFrame(project: Project, { graph, id, frame }: PutFrame): Change {
  checkLayoutId(id);
  return change(project, (draft) => {
    draftLayout(draft, graph).frames[id] = castDraft({ ...frame, ...rounded(frame) });
  });
}

export interface PutNote {
  readonly graph: string;
  readonly id: string;
  readonly note: Note;
}

/**
 * Adds or replaces a note.
 *
 * @throws Error if `id` is not a layout id.
 *
 * @example
 * putNote(project, { graph: 'main', id: makeLayoutId(project, 'main', 'note', random), note: { ...box, text: 'Check on a phone' } });
 */
export function putNote(project: Project, { graph, id, note }: PutNote): Change {
  checkLayoutId(id);
  return change(project, (draft) => {
    draftLayout(draft, graph).notes[id] = castDraft({ ...note, ...rounded(note) });
  });
}

export interface RemoveFromLayout {
  readonly graph: string;
  readonly frames?: readonly string[];
  readonly notes?: readonly string[];
  /** Ids of reroutes. Wires keep the rest of their routes. */
  readonly reroutes?: readonly string[];
}

/**
 * Removes node frames, notes and reroutes.
 *
 * @returns The change; this command is never refused.
 *
 * @example
 * removeFromLayout(project, { graph: 'main', notes: ['note-p3m9'] });
 */
export function removeFromLayout(project: Project, { graph, frames = [], notes = [], reroutes = [] }: RemoveFromLayout): Change {
  return change(project, (draft) => {
    const layout = draft.layout[graph];
    if (!layout) return;
    for (const id of frames) delete layout.frames[id];
    for (const id of notes) delete layout.notes[id];
    for (const id of reroutes) delete layout.reroutes[id];
    for (const [wire, route] of reroutes.length === 0 ? [] : Object.entries(layout.routes)) {
      const kept = route.filter((id) => !reroutes.includes(id));
      if (kept.length === 0) delete layout.routes[wire];
      else if (kept.length < route.length) layout.routes[wire] = kept;
    }
  });
}

export function checkLayoutId(id: string): void {
  if (!isEntryId(id)) throw new Error(`${id} is not an id of a node frame, a note or a reroute.`);
}

/** Rounds to whole canvas units. Adding 0 converts −0, which JSON cannot represent. */
export function rounded<T extends { readonly x: number; readonly y: number; readonly width?: number; readonly height?: number }>(box: T) {
  const { x, y, width, height } = box;
  return {
    x: Math.round(x) + 0,
    y: Math.round(y) + 0,
    ...(width === undefined ? {} : { width: Math.round(width) + 0 }),
    ...(height === undefined ? {} : { height: Math.round(height) + 0 }),
  };
}
