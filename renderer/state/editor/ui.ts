import { createStore, type StoreApi } from 'zustand/vanilla';
import type { ProjectFiles } from '../../../app/contract/contract.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { WireInHand } from './canvas-state.ts';

/** Sizes and choices that outlive the window. CSS pixels. */
export interface PanelSizes {
  readonly sideWidthPx: number;
  readonly previewHeightPx: number;
  readonly bottomHeightPx: number;
  readonly helpWidthPx: number;
}

export const DEFAULT_SIZES: PanelSizes = { sideWidthPx: 380, previewHeightPx: 330, bottomHeightPx: 280, helpWidthPx: 300 };

export type BottomTab = 'code' | 'timeline' | 'problems';

/** Someone asked for a new node: where it goes, and what wire waits for it. */
export interface PaletteRequest {
  /** Client pixels. */
  readonly at: { readonly x: number; readonly y: number };
  /** Canvas units; null: the middle of what is seen. */
  readonly place: { readonly x: number; readonly y: number } | null;
  readonly end: WireInHand | null;
  /** The wire that the new node goes into. */
  readonly wire?: string;
  /** The node that becomes another one. */
  readonly swap?: string;
}

/** Client pixels: where a palette that was asked for by keys lies in the middle of the canvas, within a few pixels. */
export function middleOfWindow(): PaletteRequest['at'] {
  return { x: window.innerWidth / 2 - 480, y: window.innerHeight / 2 - 240 };
}

export type DialogRequest =
  | { readonly kind: 'open' }
  /** `template`: what is chosen already. */
  | { readonly kind: 'new'; readonly template?: string }
  | { readonly kind: 'save-as' }
  | { readonly kind: 'export' }
  | { readonly kind: 'render' }
  /** Something is about to drop unsaved work; `proceed` goes on with it. */
  | { readonly kind: 'unsaved'; readonly proceed: () => void }
  | { readonly kind: 'recovery'; readonly files: ProjectFiles }
  | { readonly kind: 'changed-outside' }
  /** Another process holds the project's lock; `overwrite` as the save had it that met it. */
  | { readonly kind: 'locked'; readonly overwrite: boolean }
  | { readonly kind: 'shadertoy' }
  /** A subgraph, to be called what it is found by; `rename` where it is in the library for long. */
  | { readonly kind: 'library'; readonly name: string; readonly rename?: true }
  /** A subgraph, to be taken out of the library; it is used. */
  | { readonly kind: 'library-remove'; readonly name: string }
  | { readonly kind: 'commands' }
  | { readonly kind: 'shortcuts' }
  | { readonly kind: 'find' };

export interface Toast {
  readonly id: number;
  readonly tone: 'info' | 'success' | 'warning' | 'error';
  readonly text: string;
  readonly detail?: string;
}

/** Where the canvas should look. */
export interface Reveal {
  readonly serial: number;
  /** None means all. */
  readonly nodes: readonly string[];
  /** `show`: moves no more than is needed to see them. `fit`: fills the canvas with them. */
  readonly how: 'show' | 'fit';
}

export interface CodePosition {
  readonly serial: number;
  readonly line: number;
  readonly column: number;
  /** Where it is not in the node's own text: a chunk, `chunks/NAME.glsl`, or its vertex shader, `shaders/NAME.vs`. */
  readonly file: string | null;
}

export interface Exporting {
  /** Of the project. */
  readonly handle: string;
  /** What it is at. */
  readonly text: string;
  readonly cancelled: boolean;
  /** Of frames, which the editor draws itself; else the host exports a page. */
  readonly frames?: true;
}

export interface UiState {
  readonly sizes: PanelSizes;
  readonly bottom: BottomTab | null;
  /** What the selected node does is told beside the graph. */
  readonly help: boolean;
  /** The header of the shader is shown as a form beside its text. */
  readonly headerForm: boolean;
  /** Shaders of the project that another program wrote last: they are read only here until they are taken back. */
  readonly outside: readonly string[];
  readonly palette: PaletteRequest | null;
  readonly dialog: DialogRequest | null;
  /** Which step of the tour is shown, from 0. */
  readonly tour: number | null;
  readonly toasts: readonly Toast[];
  readonly reveal: Reveal | null;
  readonly codePosition: CodePosition | null;
  /** A key was pressed in a text a moment ago: problems are shown once typing pauses. */
  readonly typing: boolean;
  /** The export under way. */
  readonly exporting: Exporting | null;
  /** What the last export said. */
  readonly exportDiagnostics: readonly Diagnostic[];
}

export type UiStore = StoreApi<UiState>;

export function createUi(sizes: PanelSizes): UiStore {
  return createStore<UiState>(() => ({
    sizes,
    bottom: null,
    help: false,
    headerForm: false,
    outside: [],
    palette: null,
    dialog: null,
    tour: null,
    toasts: [],
    reveal: null,
    codePosition: null,
    typing: false,
    exporting: null,
    exportDiagnostics: [],
  }));
}

const MAX_TOASTS = 4;

export function addToast(store: UiStore, toast: Omit<Toast, 'id'>): number {
  const { toasts } = store.getState();
  const id = (toasts.at(-1)?.id ?? 0) + 1;
  // The same refusal twice is one message.
  const others = toasts.filter((old) => old.text !== toast.text);
  store.setState({ toasts: [...others, { ...toast, id }].slice(-MAX_TOASTS) });
  return id;
}

export function toastDiagnostic(store: UiStore, { severity, message, fix }: Pick<Diagnostic, 'severity' | 'message' | 'fix'>): number {
  return addToast(store, { tone: severity, text: message, ...(fix === undefined ? {} : { detail: fix }) });
}

export function removeToast(store: UiStore, id: number): void {
  store.setState(({ toasts }) => ({ toasts: toasts.filter((toast) => toast.id !== id) }));
}

export function revealNodes(store: UiStore, nodes: readonly string[], how: Reveal['how'] = 'show'): void {
  store.setState(({ reveal }) => ({ reveal: { serial: (reveal?.serial ?? 0) + 1, nodes, how } }));
}

/** `file`: a chunk that the selected node's technique includes, or its vertex shader; null for its own text. */
export function revealCode(store: UiStore, line: number, column: number, file: string | null = null): void {
  store.setState(({ codePosition }) => ({
    bottom: 'code',
    codePosition: { serial: (codePosition?.serial ?? 0) + 1, line, column, file },
  }));
}
