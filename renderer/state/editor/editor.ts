import type { Host } from '../../../app/contract/contract.ts';
import type { EditorClock } from '../../clock.ts';
import type { FromPreview, ToPreview } from '../../preview-protocol.ts';
import { type CanvasStore, createCanvasState } from './canvas-state.ts';
import type { Clipping } from './clipping.ts';
import { type CompileStore, createCompileState } from './compile-state.ts';
import { type CostStore, createCostState } from './cost-state.ts';
import { createDocument, type DocumentStore } from './document.ts';
import { createGizmoState, type GizmoStore } from './gizmo-state.ts';
import { createLibraries, type Libraries, type LibraryData } from './library.ts';
import { createPreferences, DEFAULT_PREFERENCES, type Preferences, type PreferencesStore } from './preferences.ts';
import { createPreviewState, type PreviewStore } from './preview-state.ts';
import { createQueue, type Queue } from './queue.ts';
import { createSelection, type SelectionStore } from './selection.ts';
import { createUi, type PanelSizes, type UiStore } from './ui.ts';
import { createThumbnailWatchers, createViewerState, type ThumbnailWatchers, type ViewerStore } from './viewer.ts';

/** Text, as other windows see it. Rejects where the browser forbids it. */
export interface Clipboard {
  read(): Promise<string>;
  write(text: string): Promise<void>;
}

export interface ImageSize {
  readonly widthPx: number;
  readonly heightPx: number;
}

/** A page that draws frames one by one: it answers each message before it takes the next. */
export interface FrameRenderLink {
  ask(
    message: Extract<ToPreview, { kind: 'render-begin' | 'render-frame' | 'render-end' }>,
  ): Promise<Extract<FromPreview, { kind: 'frame-rendered' | 'render-finished' | 'render-failed' }>>;
  close(): void;
}

/**
 * The editor without its page: stores that each hold one concern, and what the outside lends. What people do are functions over
 * it (`edit-graph.ts`, `edit-params.ts`, `files.ts`, …), so that it can be driven without React.
 */
export interface Editor {
  readonly host: Host;
  readonly clock: EditorClock;
  readonly random: () => number;
  readonly mac: boolean;
  readonly clipboard: Clipboard;
  /** What was copied last: what is still being read for an earlier clipping comes too late. */
  readonly copied: { newest: Clipping | null };
  /** Hands a file to the person. */
  readonly keepFile: (file: Blob, name: string) => void;
  readonly libraries: Libraries;
  /** Take over at once what is being typed; run before files are made of the document. */
  readonly unfinished: Set<() => void>;
  /** Opens, saves and closes the project, and brings files into it: each begins with what the one before has made of the document. */
  readonly fileWork: Queue;
  /** Renders what the preview shows as a JPEG; resolves to null where it shows nothing. `take` is null while there is no preview. */
  readonly posters: { take: ((size: ImageSize) => Promise<Uint8Array<ArrayBuffer> | null>) | null };
  readonly thumbnails: ThumbnailWatchers;
  /** Moves the preview's time; goes nowhere while there is no preview. */
  readonly transport: { post: (message: ToPreview) => void };
  /** Opens a page to render frames in; null where there is none. */
  readonly renderPage: { open: (() => FrameRenderLink) | null };
  readonly document: DocumentStore;
  readonly selection: SelectionStore;
  readonly canvas: CanvasStore;
  readonly ui: UiStore;
  readonly compile: CompileStore;
  readonly preview: PreviewStore;
  readonly viewer: ViewerStore;
  readonly gizmo: GizmoStore;
  readonly costs: CostStore;
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
    document: createDocument(libraries.of({ sources: {}, graphs: {} })),
    selection: createSelection(),
    canvas: createCanvasState(),
    ui: createUi(sizes),
    compile: createCompileState(),
    preview: createPreviewState(),
    viewer: createViewerState(),
    gizmo: createGizmoState(),
    costs: createCostState(),
    preferences: createPreferences(preferences),
  };
}
