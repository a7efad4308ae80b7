import type { LayoutKind } from '../../../export/graph/document-names.ts';
import type { GraphLayout } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { Place } from './canvas-state.ts';

/**
 * Frames, notes and the reroutes of wires, which stand on the canvas beside the nodes. There they are called `frame:ID`, `note:ID` and
 * `reroute:ID`: no node's id has a colon.
 */
export type ItemKind = LayoutKind;

export function itemId(kind: ItemKind, id: string): string {
  return `${kind}:${id}`;
}

export function itemOf(canvasId: string): { readonly kind: ItemKind; readonly id: string } | null {
  const [kind, id] = canvasId.split(':');
  return (kind === 'frame' || kind === 'note' || kind === 'reroute') && id !== undefined ? { kind, id } : null;
}

export function itemIds(layout: GraphLayout): readonly string[] {
  const ids = (kind: ItemKind) => Object.keys(layout[`${kind}s`]).map((id) => itemId(kind, id));
  return [...ids('frame'), ...ids('note'), ...ids('reroute')];
}

/** The ids in the layout of those of one kind. */
export function idsOfKind(canvasIds: Iterable<string>, wanted: ItemKind): readonly string[] {
  return [...canvasIds].flatMap((canvasId) => {
    const item = itemOf(canvasId);
    return item?.kind === wanted ? [item.id] : [];
  });
}

/** The top left of a frame or note, the middle of a reroute. */
export function placeOfItem(layout: GraphLayout, canvasId: string): Place | undefined {
  const item = itemOf(canvasId);
  return item === null ? undefined : getOwn<Place>(layout[`${item.kind}s`], item.id);
}

/** Places by what has them, for `moveNodes`. Those of frames and notes are left out. */
export function nodesAndReroutes(places: Readonly<Record<string, Place>>) {
  const entries = Object.entries(places);
  const reroutes = entries.flatMap(([canvasId, place]) => idsOfKind([canvasId], 'reroute').map((id) => [id, place]));
  return { positions: Object.fromEntries(entries.filter(([id]) => itemOf(id) === null)), reroutes: Object.fromEntries(reroutes) };
}
