import type { LayoutKind } from '../../../export/graph/document-names.ts';
import type { ExposedPorts, GraphLayout } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { Place } from './canvas-state.ts';

/**
 * Canvas items besides nodes: node frames, notes and reroutes. Their canvas ids are `frame:ID`, `note:ID` and `reroute:ID`; node ids
 * contain no colon.
 */
export type ItemKind = LayoutKind;

export function itemId(kind: ItemKind, id: string): string {
  return `${kind}:${id}`;
}

export function itemOf(canvasId: string): { readonly kind: ItemKind; readonly id: string } | null {
  const [kind, id] = canvasId.split(':');
  return (kind === 'frame' || kind === 'note' || kind === 'reroute') && id !== undefined ? { kind, id } : null;
}

/** The borders of an open subgraph, by their canvas ids. */
const BORDERS: Readonly<Record<string, keyof ExposedPorts>> = { 'border:inputs': 'inputs', 'border:outputs': 'outputs' };

export function borderId(side: keyof ExposedPorts): string {
  return `border:${side}`;
}

/** Side of the border with a canvas id; null for other ids. */
export function borderOf(canvasId: string): keyof ExposedPorts | null {
  return getOwn(BORDERS, canvasId) ?? null;
}

export function itemIds(layout: GraphLayout): readonly string[] {
  const ids = (kind: ItemKind) => Object.keys(layout[`${kind}s`]).map((id) => itemId(kind, id));
  return [...ids('frame'), ...ids('note'), ...ids('reroute')];
}

/** Layout ids of the items of one kind. */
export function idsOfKind(canvasIds: Iterable<string>, wanted: ItemKind): readonly string[] {
  return [...canvasIds].flatMap((canvasId) => {
    const item = itemOf(canvasId);
    return item?.kind === wanted ? [item.id] : [];
  });
}

/** The top left corner of a frame or note, or the center of a reroute. */
export function placeOfItem(layout: GraphLayout, canvasId: string): Place | undefined {
  const item = itemOf(canvasId);
  return item === null ? undefined : getOwn<Place>(layout[`${item.kind}s`], item.id);
}

/** Splits positions into those of nodes, reroutes and borders, as `moveNodes` takes them. Omits frames and notes. */
export function byKind(places: Readonly<Record<string, Place>>) {
  const entries = Object.entries(places);
  const borders = entries.flatMap(([canvasId, place]) => {
    const side = borderOf(canvasId);
    return side === null ? [] : [[side, place]];
  });
  const reroutes = entries.flatMap(([canvasId, place]) => idsOfKind([canvasId], 'reroute').map((id) => [id, place]));
  const nodes = entries.filter(([id]) => itemOf(id) === null && borderOf(id) === null);
  return { positions: Object.fromEntries(nodes), reroutes: Object.fromEntries(reroutes), borders: Object.fromEntries(borders) };
}
