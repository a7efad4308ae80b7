import { createStore, type StoreApi } from 'zustand/vanilla';
import type { ExportedReport, HostEvent, HostOutput, ProjectFiles } from '../../../app/contract/contract.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { CanvasPlace, DraggedWire } from './canvas-state.ts';

/** Stored sizes of the panels in CSS pixels. */
export interface PanelSizes {
  readonly sideWidthPx: number;
  readonly previewHeightPx: number;
  readonly bottomHeightPx: number;
  readonly helpWidthPx: number;
  /** Height of preview and inspector below the graph. */
  readonly belowHeightPx: number;
  /** Width of the inspector beside a preview below the graph. */
  readonly inspectorWidthPx: number;
  /** Height of a preview above the inspector whose picture is higher than wide. */
  readonly uprightHeightPx: number;
  /** Width of preview and inspector beside the graph while the picture has the shape of an upright phone. */
  readonly tallSideWidthPx: number;
  /** Width of the inspector beside such a picture. */
  readonly tallInspectorWidthPx: number;
}

export const DEFAULT_SIZES: PanelSizes = {
  sideWidthPx: 576,
  previewHeightPx: 440,
  bottomHeightPx: 280,
  helpWidthPx: 300,
  belowHeightPx: 420,
  inspectorWidthPx: 380,
  uprightHeightPx: 620,
  tallSideWidthPx: 700,
  tallInspectorWidthPx: 290,
};

/** Where preview and inspector are, relative to the graph. */
export const DOCKS = ['right', 'left', 'below'] as const;
export type Dock = (typeof DOCKS)[number];

/** `panel`: beside the graph. `full`: the preview fills the window. `overlay`: the preview fills the window, with the graph over it. */
export type PreviewExtent = 'panel' | 'full' | 'overlay';

export type BottomTab = 'code' | 'timeline' | 'assets' | 'history' | 'problems';

/** A request to open the palette. */
export interface PaletteRequest {
  /** Position in client pixels. */
  readonly at: { readonly x: number; readonly y: number };
  /** Position of the new node in canvas units; null for the center of the visible canvas. */
  readonly place: { readonly x: number; readonly y: number } | null;
  readonly end: DraggedWire | null;
  /** Id of the wire that the new node is inserted into. */
  readonly wire?: string;
  /** Id of the node whose type is changed. */
  readonly swap?: string;
  /** Id of the node that the new node continues, if one of its outputs fits. */
  readonly after?: string;
  /** What is searched for at first. Default: nothing. */
  readonly query?: string;
  /** Label of the category that is listed first, before favorites. Default: none. */
  readonly first?: string;
}

/** Position in client pixels for a palette opened by a key, which roughly centers it. */
export function middleOfWindow(): PaletteRequest['at'] {
  return { x: window.innerWidth / 2 - 480, y: window.innerHeight / 2 - 240 };
}

export type DialogRequest =
  | { readonly kind: 'open' }
  /** `template`: the preselected template. */
  | { readonly kind: 'new'; readonly template?: string }
  | { readonly kind: 'save-as' }
  | { readonly kind: 'export' }
  /** Shows the last exported page. */
  | { readonly kind: 'exported' }
  | { readonly kind: 'render' }
  /** Photographs of the scene, for a capture. */
  | { readonly kind: 'photograph' }
  /** Imports a folder of photographs. `folder` is its path; empty if it is not known yet. */
  | { readonly kind: 'photographs'; readonly folder: string }
  /** What the import of a capture understood. `path`: its `capture.json`; `note`: what has just happened. */
  | { readonly kind: 'capture-report'; readonly path: string; readonly note?: string }
  /** Makes a model or capture smaller. `id`: the chosen asset. */
  | { readonly kind: 'simplify'; readonly id?: string }
  /** How a capture is rephotographed. `path`: the chosen capture. */
  | { readonly kind: 'rephotograph'; readonly path?: string }
  | { readonly kind: 'rephotographed'; readonly rephotographed: RephotographMeans }
  /** Asks about unsaved changes that an action would discard; `proceed` continues the action. */
  | { readonly kind: 'unsaved'; readonly proceed: () => void }
  | { readonly kind: 'recovery'; readonly files: ProjectFiles }
  | { readonly kind: 'changed-outside' }
  /** Another process holds the lock of the project. `overwrite` is that of the failed save. */
  | { readonly kind: 'locked'; readonly overwrite: boolean }
  | { readonly kind: 'shadertoy' }
  /** Asks for the name of a subgraph in the library; `rename` if it is already in the library. */
  | { readonly kind: 'library'; readonly name: string; readonly rename?: true }
  /** Confirms the removal of a subgraph that is in use. */
  | { readonly kind: 'library-remove'; readonly name: string }
  /** Saves the selected nodes as a recipe. */
  | { readonly kind: 'recipe' }
  /** Lists the recipes of the person. */
  | { readonly kind: 'recipes' }
  | { readonly kind: 'commands' }
  | { readonly kind: 'shortcuts' }
  | { readonly kind: 'find' };

/** How well a capture shows its photographs, each drawn from all others. */
export interface RephotographMeans {
  /** Path of its `capture.json`. */
  readonly path: string;
  /** Number of photographs. */
  readonly views: number;
  /** Means over all photographs, by method. */
  readonly means: HostOutput<'rephotograph.finish'>['means'];
}

export interface Toast {
  readonly id: number;
  readonly tone: 'info' | 'success' | 'warning' | 'error';
  readonly text: string;
  readonly detail?: string;
}

/** The dialogs that show errors themselves, which are then no toasts. */
const WITH_ERRORS: ReadonlySet<DialogRequest['kind']> = new Set(['new', 'open', 'save-as', 'export', 'render', 'photographs', 'recipe']);

/** A request to scroll the canvas. */
export interface Reveal {
  readonly serial: number;
  /** Nodes to show; empty for all. */
  readonly nodes: readonly string[];
  /**
   * `show` moves the view as little as possible; `fit` fills the view with the nodes; `find` does so only if the view shows nothing of the
   * graph. A place is shown at once.
   */
  readonly how: 'show' | 'fit' | 'find' | CanvasPlace;
}

export interface CodePosition {
  readonly serial: number;
  readonly line: number;
  readonly column: number;
  /** The file, unless it is the shader of the node: a chunk (`chunks/NAME.glsl`) or its vertex shader (`shaders/NAME.vs`). */
  readonly file: string | null;
}

export interface Exporting {
  /** Handle of the project. */
  readonly handle: string;
  /** Progress text. */
  readonly text: string;
  readonly cancelled: boolean;
  /** A frame render or an acquisition, which the editor draws itself. Absent for an export, which the host writes. */
  readonly frames?: true;
}

/** Work of the host with a program of others, in progress or failed. */
export interface ToolRun {
  /** Handle of the project. */
  readonly handle: string;
  /** Kind of the dialog that shows it. */
  readonly dialog: 'photographs' | 'simplify';
  readonly step: ToolStep;
  /** The last lines that the program printed. */
  readonly lines: readonly string[];
  /** Why it failed; null while it runs. */
  readonly error: Diagnostic | null;
}

export type ToolStep = Extract<HostEvent, { kind: 'tool-progress' }>['step'];

/** How the open project is exported. */
export interface ExportSettings {
  /** Absolute path of the folder of the page; empty before the first export. */
  readonly out: string;
  /** Whether the page is a single file. */
  readonly singleFile: boolean;
  /** Whether the page opens offline after a visit. */
  readonly offline: boolean;
  /** Address of the published page as it was typed; may be empty. */
  readonly address: string;
}

export const DEFAULT_EXPORT_SETTINGS: ExportSettings = { out: '', singleFile: false, offline: true, address: '' };

/** The result of an export. */
export interface ExportedPage {
  /** Handle of the project. */
  readonly handle: string;
  readonly title: string;
  /** The settings that it was exported with. */
  readonly settings: ExportSettings;
  readonly report: ExportedReport;
  /** The poster as a `data:` URL; null if it is a neutral one. */
  readonly poster: string | null;
}

export interface UiState {
  readonly sizes: PanelSizes;
  readonly dock: Dock;
  readonly previewExtent: PreviewExtent;
  readonly bottom: BottomTab | null;
  /** Whether the help panel is open. */
  readonly help: boolean;
  /** Whether the header of a shader is shown as a form. */
  readonly headerForm: boolean;
  /** Shaders that another program saved last. They are read-only in the editor until the user edits them here again. */
  readonly outside: readonly string[];
  readonly palette: PaletteRequest | null;
  readonly dialog: DialogRequest | null;
  /** Errors since the dialog opened, for dialogs that show them. */
  readonly dialogErrors: readonly Omit<Toast, 'id'>[];
  /** Index of the current tour step; null if the tour is closed. */
  readonly tour: number | null;
  readonly toasts: readonly Toast[];
  /** Counts the events of a drag of files over the window; 0 while there is none. */
  readonly fileDrags: number;
  readonly reveal: Reveal | null;
  readonly codePosition: CodePosition | null;
  /** Whether a shader text is being typed. New problems are shown once typing pauses. */
  readonly typing: boolean;
  /** The export, frame render or acquisition in progress. */
  readonly exporting: Exporting | null;
  /** The last work with a program of others; null if there is none or it succeeded. */
  readonly toolRun: ToolRun | null;
  /** Diagnostics of the last export. */
  readonly exportDiagnostics: readonly Diagnostic[];
  /** Why the last export failed, for its dialog. */
  readonly exportErrors: readonly Diagnostic[];
  readonly exportSettings: ExportSettings;
  /** The page of the last export; null if there is none. */
  readonly exported: ExportedPage | null;
}

export type UiStore = StoreApi<UiState>;

export function createUi(sizes: PanelSizes, dock: Dock): UiStore {
  const store = createStore<UiState>(() => ({
    sizes,
    dock,
    previewExtent: 'panel',
    bottom: null,
    help: false,
    headerForm: false,
    outside: [],
    palette: null,
    dialog: null,
    dialogErrors: [],
    tour: null,
    toasts: [],
    fileDrags: 0,
    reveal: null,
    codePosition: null,
    typing: false,
    exporting: null,
    toolRun: null,
    exportDiagnostics: [],
    exportErrors: [],
    exportSettings: DEFAULT_EXPORT_SETTINGS,
    exported: null,
  }));
  store.subscribe(({ dialog, dialogErrors }, before) => {
    if (dialog !== before.dialog && dialogErrors === before.dialogErrors) clearDialogErrors(store);
  });
  return store;
}

/** Opens the start screen. What went wrong before stands in it. */
export function openStartScreen(store: UiStore): void {
  const { toasts } = store.getState();
  const [dialogErrors, others] = [toasts.filter(({ tone }) => tone === 'error'), toasts.filter(({ tone }) => tone !== 'error')];
  store.setState({ dialog: { kind: 'open' }, dialogErrors, toasts: others });
}

export function clearDialogErrors(store: UiStore): void {
  if (store.getState().dialogErrors.length > 0) store.setState({ dialogErrors: [] });
}

const MAX_TOASTS = 4;

export function addToast(store: UiStore, toast: Omit<Toast, 'id'>): number {
  const { toasts } = store.getState();
  const id = (toasts.at(-1)?.id ?? 0) + 1;
  // A repeated message replaces the earlier one.
  const others = toasts.filter((old) => old.text !== toast.text);
  store.setState({ toasts: [...others, { ...toast, id }].slice(-MAX_TOASTS) });
  return id;
}

/** Shows a diagnostic as a toast. An error stands in the open dialog, if that shows errors. */
export function toastDiagnostic(store: UiStore, { severity, message, fix }: Pick<Diagnostic, 'severity' | 'message' | 'fix'>): void {
  const toast = { tone: severity, text: message, ...(fix === undefined ? {} : { detail: fix }) };
  const { dialog, dialogErrors } = store.getState();
  if (severity !== 'error' || dialog === null || !WITH_ERRORS.has(dialog.kind)) addToast(store, toast);
  else store.setState({ dialogErrors: [...dialogErrors.filter(({ text }) => text !== message), toast] });
}

export function removeToast(store: UiStore, id: number): void {
  store.setState(({ toasts }) => ({ toasts: toasts.filter((toast) => toast.id !== id) }));
}

export function revealNodes(store: UiStore, nodes: readonly string[], how: Exclude<Reveal['how'], CanvasPlace> = 'show'): void {
  store.setState(({ reveal }) => ({ reveal: { serial: (reveal?.serial ?? 0) + 1, nodes, how } }));
}

export function revealPlace(store: UiStore, place: CanvasPlace): void {
  store.setState(({ reveal }) => ({ reveal: { serial: (reveal?.serial ?? 0) + 1, nodes: [], how: place } }));
}

/**
 * Opens the code panel at a position of the selected node's shader.
 *
 * @param file A chunk that the technique of the selected node includes, or its vertex shader; null for the shader itself.
 */
export function revealCode(store: UiStore, line: number, column: number, file: string | null = null): void {
  store.setState(({ codePosition }) => ({
    bottom: 'code',
    codePosition: { serial: (codePosition?.serial ?? 0) + 1, line, column, file },
  }));
}
