import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Program } from '../../../export/program/program.ts';
import type { ParamValue } from '../../../nodes/kit/definition.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';

/** A param that changed after the program was compiled. `node` is the id in the program: `outer/inner` within subgraphs. */
export interface LaterValue {
  readonly node: string;
  readonly param: string;
  readonly value: ParamValue;
}

/** The latest result of the compiler. */
export interface CompileState {
  /** Whether a newer compile is running. */
  readonly busy: boolean;
  /** Document revision of the diagnostics; null before the first compile. */
  readonly revision: number | null;
  /** The last program without errors; null before the first. */
  readonly program: Program | null;
  readonly programRevision: number | null;
  /** Params to set when the program plays in another player, because it was compiled with older values. */
  readonly laterValues: readonly LaterValue[];
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
    laterValues: [],
    diagnostics: [],
    tookMs: 0,
  }));
}
