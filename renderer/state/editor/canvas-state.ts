import { createStore, type StoreApi } from 'zustand/vanilla';
import type { WireType } from '../../../nodes/kit/wire-types.ts';

/** What happens on the canvas and is no part of the document. */
export interface CanvasState {
  /** Nodes that show every param that could be wired. */
  readonly expanded: ReadonlySet<string>;
  /** The node under a wire in hand, expanded for as long as it is. */
  readonly offered: string | null;
  /** Where nodes are while they are dragged, canvas units. */
  readonly dragged: Readonly<Record<string, Place>>;
  readonly inHand: WireInHand | null;
  /** The wire that a dragged node would go into, or that a layer in hand would be laid over. */
  readonly wireUnder: string | null;
  /** Middle of what is seen, canvas units; the page says. */
  readonly middle: () => Place;
  /** A frame or note while it is resized. */
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

/** A port that a wire in hand is looking for a partner for. */
export interface OpenEnd {
  readonly type: WireType;
  /** The side that the wire starts from. */
  readonly side: 'output' | 'input';
}

export interface WireInHand extends OpenEnd {
  readonly node: string;
  readonly port: string;
  /** The reroutes that it is led through, where it was drawn from one. */
  readonly route?: readonly string[];
}

export type CanvasStore = StoreApi<CanvasState>;

const NOWHERE: CanvasState['dragged'] = {};

export function createCanvasState(): CanvasStore {
  return createStore<CanvasState>(() => ({
    expanded: new Set(),
    offered: null,
    dragged: NOWHERE,
    inHand: null,
    wireUnder: null,
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

export function takeWire(store: CanvasStore, inHand: WireInHand): void {
  store.setState({ inHand });
}

export function dropWire(store: CanvasStore): void {
  store.setState({ inHand: null, offered: null, wireUnder: null });
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

/** Ends a drag: what was dragged, and nothing is any more. */
export function endDrag(store: CanvasStore): CanvasState['dragged'] {
  const { dragged } = store.getState();
  store.setState({ dragged: NOWHERE, wireUnder: null });
  return dragged;
}
