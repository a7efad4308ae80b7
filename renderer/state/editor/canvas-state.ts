import { createStore, type StoreApi } from 'zustand/vanilla';
import type { WireType } from '../../../nodes/kit/wire-types.ts';

/** State of the canvas that is not part of the document. */
export interface CanvasState {
  /** Nodes that show all connectable params as ports. */
  readonly expanded: ReadonlySet<string>;
  /** The node under a dragged wire. It is expanded until the wire leaves it. */
  readonly offered: string | null;
  /** Positions of dragged nodes, in canvas units. */
  readonly dragged: Readonly<Record<string, Place>>;
  readonly draggedWire: DraggedWire | null;
  /** The wire that a dropped node would be inserted into, or that a dropped layer would be composited over. */
  readonly wireUnder: string | null;
  /** Returns the center of the visible canvas, in canvas units. Set by the page. */
  readonly middle: () => Place;
  /** The part of the graph that the canvas shows; null before it is drawn. */
  readonly shown: CanvasPlace | null;
  /** A frame or note during a resize. */
  readonly resized: ResizedItem | null;
}

export interface ResizedItem extends Place {
  readonly id: string;
  readonly width: number;
  readonly height: number;
}

export interface Place {
  readonly x: number;
  readonly y: number;
}

/** A part of the graph, by its center in canvas units. */
export interface CanvasPlace extends Place {
  readonly zoom: number;
}

/** The free end of a dragged wire. */
export interface OpenEnd {
  readonly type: WireType;
  /** The side of the port at the other end. */
  readonly side: 'output' | 'input';
}

export interface DraggedWire extends OpenEnd {
  readonly node: string;
  readonly port: string;
  /** Reroutes of the wire, if it starts from a reroute. */
  readonly route?: readonly string[];
}

export type CanvasStore = StoreApi<CanvasState>;

const NOWHERE: CanvasState['dragged'] = {};

export function createCanvasState(): CanvasStore {
  return createStore<CanvasState>(() => ({
    expanded: new Set(),
    offered: null,
    dragged: NOWHERE,
    draggedWire: null,
    wireUnder: null,
    shown: null,
    resized: null,
    middle: () => ({ x: 0, y: 0 }),
  }));
}

export function toggleExpanded(store: CanvasStore, node: string): void {
  store.setState(({ expanded }) => {
    const next = new Set(expanded);
    if (!next.delete(node)) next.add(node);
    return { expanded: next };
  });
}

export function startWire(store: CanvasStore, draggedWire: DraggedWire): void {
  store.setState({ draggedWire });
}

export function dropWire(store: CanvasStore): void {
  store.setState({ draggedWire: null, offered: null, wireUnder: null });
}

export function offerParams(store: CanvasStore, node: string | null): void {
  if (store.getState().offered !== node) store.setState({ offered: node });
}

export function showResized(store: CanvasStore, resized: ResizedItem | null): void {
  store.setState({ resized });
}

export function hoverWire(store: CanvasStore, wireUnder: string | null): void {
  if (store.getState().wireUnder !== wireUnder) store.setState({ wireUnder });
}

export function dragTo(store: CanvasStore, places: Readonly<Record<string, Place>>): void {
  store.setState(({ dragged }) => ({ dragged: { ...dragged, ...places } }));
}

/**
 * Ends a drag.
 *
 * @returns The dragged positions.
 */
export function endDrag(store: CanvasStore): CanvasState['dragged'] {
  const { dragged } = store.getState();
  store.setState({ dragged: NOWHERE, wireUnder: null });
  return dragged;
}
