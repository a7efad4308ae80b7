import { createStore, type StoreApi } from 'zustand/vanilla';
import type { GizmoMode } from '../../preview-protocol.ts';
import type { GizmoTarget } from './gizmo-target.ts';

/** Options and state of the gizmo in the preview. */
export interface GizmoState {
  /** Mode of the gizmo. Null hides the gizmo and disables selection by click. */
  readonly mode: GizmoMode | null;
  readonly space: 'local' | 'world';
  readonly snap: boolean;
  /** Nodes of the program that the last clicked object passed through, from its creator to the node that drew it. */
  readonly chain: readonly string[];
  /** The lamp of a Lights from panorama node that is rotated, from 1. */
  readonly lamp: number;
  readonly drag: GizmoDrag | null;
  /** `id` of the last drag that ended or was canceled; 0 if there was none since the preview page loaded. */
  readonly endedDrag: number;
}

/** The drag in progress. */
export interface GizmoDrag {
  /** Counter of drags in the preview page, from 1. */
  readonly id: number;
  readonly target: GizmoTarget;
  /** State of the history before the drag, which a cancel restores. */
  readonly state: number;
  /** Time of the keyframes that the drag sets. */
  readonly timeS: number;
}

export type GizmoStore = StoreApi<GizmoState>;

export function createGizmoState(): GizmoStore {
  return createStore<GizmoState>(() => ({ mode: 'move', space: 'world', snap: false, chain: [], lamp: 1, drag: null, endedDrag: 0 }));
}

/** Sets the mode; turns the gizmo off if it already has this mode. */
export function toggleMode(store: GizmoStore, mode: GizmoMode): void {
  store.setState({ mode: store.getState().mode === mode ? null : mode });
}
