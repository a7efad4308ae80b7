import type { Node } from '@xyflow/react';
import type { GraphLayout } from '../../export/graph/project.ts';
import type { Place } from '../state/editor/canvas-state.ts';
import { itemId } from '../state/editor/item-ids.ts';
import type { Box } from '../state/graph/layout-items.ts';

export interface ItemData extends Record<string, unknown> {
  /** Title of a frame, text of a note. */
  readonly text: string;
}

/** A node frame or a note, as a React Flow node. */
export type ItemNode = Node<ItemData, 'frame' | 'note'>;

export interface ItemsInput {
  readonly layout: GraphLayout;
  readonly selected: ReadonlySet<string>;
  readonly dragged: Readonly<Record<string, Place>>;
  readonly resized: (Box & { readonly id: string }) | null;
}

/** Frames lie behind everything, notes in front of frames. Unchanged items are the same objects as before. */
export function createItemsProjection(): (input: ItemsInput) => readonly ItemNode[] {
  let known = new Map<string, { readonly key: readonly unknown[]; readonly item: ItemNode }>();
  return ({ layout, selected, dragged, resized }) => {
    const next: typeof known = new Map();
    const project = (kind: 'frame' | 'note', name: string, box: Box, text: string) => {
      const id = itemId(kind, name);
      const drawn = resized?.id === id ? resized : { ...box, ...dragged[id] };
      const key = [drawn.x, drawn.y, drawn.width, drawn.height, text, selected.has(id)];
      const before = known.get(id);
      const same = before?.key.every((value, index) => value === key[index]) ?? false;
      next.set(id, before && same ? before : { key, item: itemNode(kind, id, drawn, text, selected.has(id)) });
    };
    for (const [name, frame] of Object.entries(layout.frames)) project('frame', name, frame, frame.title);
    for (const [name, note] of Object.entries(layout.notes)) project('note', name, note, note.text);
    known = next;
    return [...next.values()].map(({ item }) => item);
  };
}

function itemNode(kind: 'frame' | 'note', id: string, { x, y, width, height }: Box, text: string, selected: boolean): ItemNode {
  return {
    id,
    type: kind,
    position: { x, y },
    width,
    height,
    measured: { width, height },
    data: { text },
    selected,
    connectable: false,
    zIndex: kind === 'frame' ? -2 : -1,
    ...(kind === 'frame' ? { dragHandle: '.frame-head' } : {}),
    ariaLabel: kind === 'frame' ? `Frame, ${text}` : `Note, ${text}`,
  };
}
