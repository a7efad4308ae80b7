import { createStore, type StoreApi } from 'zustand/vanilla';
import type { GizmoMode } from '../../preview-protocol.ts';
import type { GizmoTarget } from './gizmo-target.ts';

/** Whether and how a gizmo is shown in the preview. */
export interface GizmoState {
  /** Null: not at all, and clicks hit nothing. */
  readonly mode: GizmoMode | null;
  readonly space: 'local' | 'world';
  readonly snap: boolean;
  /** Nodes of the program that the object went through that was clicked last. */
  readonly way: readonly string[];
  readonly drag: GizmoDrag | null;
  /** The `id` of the last drag that ended or was canceled; 0: none since the preview page loaded. */
  readonly endedDrag: number;
}

/** The drag in progress. */
export interface GizmoDrag {
  /** Which drag of the preview page it is, from 1. */
  readonly id: number;
  readonly target: GizmoTarget;
  /** Of the history, when it began. */
  readonly state: number;
  /** Where keyframes are set. */
  readonly timeS: number;
}

export type GizmoStore = StoreApi<GizmoState>;

export function createGizmoState(): GizmoStore {
  return createStore<GizmoState>(() => ({ mode: 'move', space: 'world', snap: false, way: [], drag: null, endedDrag: 0 }));
}

/** The mode that is on goes off. */
export function toggleMode(store: GizmoStore, mode: GizmoMode): void {
  store.setState({ mode: store.getState().mode === mode ? null : mode });
}
