import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Project } from '../../../export/graph/project.ts';

/**
 * What the preview shows instead of the document for a moment: the project as it would be after a choice that the pointer rests on, or as
 * it was saved. It is in no undo step, and its diagnostics are not shown.
 */
export interface CandidateState {
  /** Null: the preview shows the document. */
  readonly project: Project | null;
}

export type CandidateStore = StoreApi<CandidateState>;

export function createCandidateState(): CandidateStore {
  return createStore<CandidateState>(() => ({ project: null }));
}

export function endCandidate({ candidate }: { readonly candidate: CandidateStore }): void {
  if (candidate.getState().project !== null) candidate.setState({ project: null });
}
