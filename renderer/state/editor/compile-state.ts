import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Program } from '../../../export/program/program.ts';
import type { ParamValue } from '../../../nodes/kit/definition.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';

/** A param of the program that was set after the program was compiled; `node` is `outer/inner` within subgraphs. */
export interface LaterValue {
  readonly node: string;
  readonly param: string;
  readonly value: ParamValue;
}

/** What the compiler last said. */
export interface CompileState {
  /** A newer answer is on its way. */
  readonly busy: boolean;
  /** Document revision that the diagnostics are about; null before the first. */
  readonly revision: number | null;
  /** The last good one; null before the first. */
  readonly program: Program | null;
  readonly programRevision: number | null;
  /** To set in the program before it plays elsewhere: it was compiled with older values. */
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
