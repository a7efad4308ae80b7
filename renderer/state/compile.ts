import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Program } from '../../export/program/program.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';

/** What the compiler last said. */
export interface CompileState {
  /** A newer answer is on its way. */
  readonly busy: boolean;
  /** Document revision that the diagnostics are about; null before the first. */
  readonly revision: number | null;
  /** The last good one; null before the first. */
  readonly program: Program | null;
  readonly programRevision: number | null;
  readonly diagnostics: readonly Diagnostic[];
  readonly tookMs: number;
}

export type CompileStore = StoreApi<CompileState>;

export function createCompileState(): CompileStore {
  return createStore<CompileState>(() => ({
    busy: false,
    revision: null,
    program: null,
    programRevision: null,
    diagnostics: [],
    tookMs: 0,
  }));
}
