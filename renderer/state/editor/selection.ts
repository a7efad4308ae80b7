import { createStore, type StoreApi } from 'zustand/vanilla';

/** The selection in the open graph: node ids, and wire ids as `printWire` writes them. */
export interface Selection {
  readonly nodes: ReadonlySet<string>;
  readonly wires: ReadonlySet<string>;
  /** Canvas ids of frames, notes and reroutes; see `item-ids.ts`. */
  readonly items: ReadonlySet<string>;
}

export type SelectionStore = StoreApi<Selection>;

const NOTHING: Selection = { nodes: new Set(), wires: new Set(), items: new Set() };

export function createSelection(): SelectionStore {
  return createStore<Selection>(() => NOTHING);
}

export function selectOnly(
  store: SelectionStore,
  nodes: Iterable<string>,
  wires: Iterable<string> = [],
  items: Iterable<string> = [],
): void {
  const next = { nodes: new Set(nodes), wires: new Set(wires), items: new Set(items) };
  const old = store.getState();
  const same = sameSet(old.nodes, next.nodes) && sameSet(old.wires, next.wires) && sameSet(old.items, next.items);
  if (!same) store.setState(next);
}

export function selectNothing(store: SelectionStore): void {
  selectOnly(store, []);
}

export type SelectionKind = 'node' | 'wire' | 'item';

export interface SelectionChange {
  readonly kind: SelectionKind;
  readonly id: string;
  readonly selected: boolean;
}

/** Applies changes of the canvas; each adds or removes one element. */
export function changeSelection(store: SelectionStore, changes: readonly SelectionChange[]): void {
  if (changes.length === 0) return;
  const nodes = new Set(store.getState().nodes);
  const wires = new Set(store.getState().wires);
  const items = new Set(store.getState().items);
  for (const { kind, id, selected } of changes) {
    const set = { node: nodes, wire: wires, item: items }[kind];
    if (selected) set.add(id);
    else set.delete(id);
  }
  selectOnly(store, nodes, wires, items);
}

/** Removes elements that no longer exist, such as after an undo. */
export function keepInSelection(store: SelectionStore, exists: (kind: SelectionKind, id: string) => boolean): void {
  const { nodes, wires, items } = store.getState();
  selectOnly(
    store,
    [...nodes].filter((id) => exists('node', id)),
    [...wires].filter((id) => exists('wire', id)),
    [...items].filter((id) => exists('item', id)),
  );
}

/** The selected node if exactly one is selected; else null. */
export function soleNode({ nodes }: Selection): string | null {
  const [first] = nodes;
  return nodes.size === 1 && first !== undefined ? first : null;
}

function sameSet(a: ReadonlySet<string>, b: ReadonlySet<string>): boolean {
  return a.size === b.size && [...a].every((value) => b.has(value));
}
