import type { Host } from '../../../app/contract/contract.ts';
import type { EditorClock } from '../../clock.ts';
import type { FromPreview, HiddenWork, ToPreview } from '../../preview-protocol.ts';
import { type CandidateStore, createCandidateState } from './candidate-state.ts';
import { type CanvasStore, createCanvasState } from './canvas-state.ts';
import type { Clipping } from './clipping.ts';
import { type CompileStore, createCompileState } from './compile-state.ts';
import { type CostStore, createCostState } from './cost-state.ts';
import { createDocument, type DocumentStore } from './document.ts';
import { createGizmoState, type GizmoStore } from './gizmo-state.ts';
import { createLibraries, type Libraries, type LibraryData } from './library.ts';
import { createPreferences, DEFAULT_PREFERENCES, type Preferences, type PreferencesStore } from './preferences.ts';
import { createPreviewState, type PreviewState, type PreviewStore } from './preview-state.ts';
import { createRecipeState, type RecipeStore } from './recipe-state.ts';
import { createSelection, type SelectionStore } from './selection.ts';
import { createUi, type Dock, type PanelSizes, type UiStore } from './ui.ts';
import { createThumbnailWatchers, createViewerState, type ThumbnailWatchers, type ViewerStore } from './viewer.ts';

/** Runs tasks one after another. A task starts when the previous one has ended, even if it failed. */
type Queue = <T>(work: () => Promise<T>) => Promise<T>;

/** Text clipboard of the system. Rejects if the browser denies access. */
export interface Clipboard {
  read(): Promise<string>;
  write(text: string): Promise<void>;
}

export interface ImageSize {
  readonly widthPx: number;
  readonly heightPx: number;
}

export type FrameRenderQuestion = Exclude<HiddenWork, { kind: 'draw-model' }>;
export type FrameRenderAnswer = Extract<
  FromPreview,
  { kind: 'frame-rendered' | 'render-finished' | 'render-failed' | 'photographed' | 'rephotographed' }
>;

/** A page that renders frames or takes photographs one by one. It answers each message before the next is sent. */
export interface FrameRenderLink {
  ask(message: FrameRenderQuestion): Promise<FrameRenderAnswer>;
  close(): void;
}

/** A picture of a model, and its size on the GPU. Null where the model cannot be read. */
export interface DrawnModel {
  readonly image: ImageBitmap | null;
  /** Textures with mipmaps and geometry. */
  readonly gpuBytes: number | null;
}

/** Draws a model of the project alone. The caller closes the image. */
export type DrawModel = (asset: { readonly assetBaseUrl: string; readonly path: string }, size: ImageSize) => Promise<DrawnModel>;

/**
 * The editor without its user interface: one store per concern, and the services of the host and the page. User actions are functions
 * that take an editor (`edit-graph.ts`, `edit-params.ts`, `files.ts`, …), so that tests can drive it without React.
 */
export interface Editor {
  readonly host: Host;
  readonly clock: EditorClock;
  readonly random: () => number;
  readonly mac: boolean;
  readonly clipboard: Clipboard;
  /** The newest clipping. Files that are still being read for an older one are dropped. */
  readonly copied: { newest: Clipping | null };
  /** Saves a file to the downloads. */
  readonly keepFile: (file: Blob, name: string) => void;
  readonly libraries: Libraries;
  /** Functions that apply pending text edits at once. They run before the document is saved. */
  readonly unfinished: Set<() => void>;
  /** Runs file operations one after another: opening, saving, closing and importing. */
  readonly fileWork: Queue;
  /** Renders a poster of the preview as JPEG; resolves to null if the preview shows nothing. `take` is null without a preview. */
  readonly posters: { take: ((size: ImageSize) => Promise<Uint8Array<ArrayBuffer> | null>) | null };
  readonly thumbnails: ThumbnailWatchers;
  /** Sends playback messages to the preview; does nothing without a preview. */
  readonly transport: { post: (message: ToPreview) => void };
  /** Opens a page for a frame render or photographs; null if that is not possible. */
  readonly renderPage: { open: (() => FrameRenderLink) | null };
  /** Draws pictures of models; null if that is not possible. */
  readonly models: { draw: DrawModel | null };
  readonly document: DocumentStore;
  readonly selection: SelectionStore;
  readonly canvas: CanvasStore;
  readonly ui: UiStore;
  readonly compile: CompileStore;
  readonly candidate: CandidateStore;
  readonly preview: PreviewStore;
  readonly viewer: ViewerStore;
  readonly gizmo: GizmoStore;
  readonly costs: CostStore;
  readonly recipes: RecipeStore;
  readonly preferences: PreferencesStore;
}

export interface EditorOptions {
  readonly host: Host;
  readonly clock: EditorClock;
  readonly random: () => number;
  readonly library: LibraryData;
  readonly mac: boolean;
  readonly clipboard: Clipboard;
  readonly keepFile: (file: Blob, name: string) => void;
  readonly sizes: PanelSizes;
  readonly dock?: Dock;
  readonly frame?: PreviewState['frame'];
  readonly preferences?: Preferences;
}

export function createEditor({
  host,
  clock,
  random,
  library,
  mac,
  clipboard,
  keepFile,
  sizes,
  dock = 'right',
  frame = 'auto',
  preferences = DEFAULT_PREFERENCES,
}: EditorOptions): Editor {
  const libraries = createLibraries(library);
  return {
    host,
    clock,
    random,
    mac,
    clipboard,
    copied: { newest: null },
    keepFile,
    libraries,
    unfinished: new Set(),
    fileWork: createQueue(),
    posters: { take: null },
    thumbnails: createThumbnailWatchers(),
    transport: { post: () => {} },
    renderPage: { open: null },
    models: { draw: null },
    document: createDocument(libraries.of({ sources: {}, graphs: {} })),
    selection: createSelection(),
    canvas: createCanvasState(),
    ui: createUi(sizes, dock),
    compile: createCompileState(),
    candidate: createCandidateState(),
    preview: createPreviewState(frame),
    viewer: createViewerState(),
    gizmo: createGizmoState(),
    costs: createCostState(),
    recipes: createRecipeState(),
    preferences: createPreferences(preferences),
  };
}

function createQueue(): Queue {
  let last: Promise<unknown> = Promise.resolve();
  return (work) => {
    const result = last.then(work);
    last = result.catch(() => {});
    return result;
  };
}
