import { createStore, type StoreApi } from 'zustand/vanilla';
import type { SessionSource } from '../../app/contract/contract.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { PreviewStatus } from '../preview-protocol.ts';

/** What is known of the preview page. */
export interface PreviewState {
  readonly ready: boolean;
  readonly status: PreviewStatus | null;
  /** Document revision of the program on screen; null before the first. */
  readonly playing: number | null;
  /** Of the session and of what plays. */
  readonly diagnostics: readonly Diagnostic[];
  /** What the graphics driver said of the newest program's shaders, on their authors' lines. */
  readonly shaderDiagnostics: readonly Diagnostic[];
  readonly sources: readonly SessionSource[];
  readonly sourceId: string | null;
  /** Of an emulated headset. */
  readonly views: 1 | 2;
}

export type PreviewStore = StoreApi<PreviewState>;

export function createPreviewState(): PreviewStore {
  return createStore<PreviewState>(() => ({
    ready: false,
    status: null,
    playing: null,
    diagnostics: [],
    shaderDiagnostics: [],
    sources: [],
    sourceId: null,
    views: 1,
  }));
}

export function chosenSource({ sources, sourceId }: PreviewState): SessionSource | null {
  return sources.find((source) => source.id === sourceId) ?? sources[0] ?? null;
}
