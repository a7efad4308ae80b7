import type { Host } from '../../app/contract/contract.ts';
import type { EditorClock } from '../clock.ts';
import type { FromPreview, ToPreview } from '../preview-protocol.ts';
import { type CanvasStore, createCanvasState } from './canvas.ts';
import type { Clipping } from './clipboard.ts';
import { type CompileStore, createCompileState } from './compile.ts';
import { type CostStore, createCostState } from './costs.ts';
import { createDocument, type DocumentStore } from './document.ts';
import { createGizmoState, type GizmoStore } from './gizmo-state.ts';
import { createLibraries, type Libraries, type LibraryData } from './library.ts';
import { createLayerPictures, createLookState, type LookStore, type Pictures } from './looks.ts';
import { createPreferences, DEFAULT_PREFERENCES, type Preferences, type PreferencesStore } from './preferences.ts';
import { createPreviewState, type PreviewStore } from './preview.ts';
import { createQueue, type Queue } from './queue.ts';
import { createSelection, type SelectionStore } from './selection.ts';
import { createUi, type PanelSizes, type UiStore } from './ui.ts';

/** Text, as other windows see it. Rejects where the browser forbids it. */
export interface Clipboard {
  read(): Promise<string>;
  write(text: string): Promise<void>;
}

export interface PictureSize {
  readonly widthPx: number;
  readonly heightPx: number;
}

/** A page that draws frames one by one: it answers each message before it takes the next. */
export interface FilmLink {
  ask(
    message: Extract<ToPreview, { kind: 'film' | 'film-frame' | 'film-end' }>,
  ): Promise<Extract<FromPreview, { kind: 'filmed' | 'film-over' | 'film-failed' }>>;
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
  /** Takes a picture of what the preview shows, as JPEG, or null where it shows nothing; set while there is a preview. */
  readonly pictures: { take: ((size: PictureSize) => Promise<Uint8Array<ArrayBuffer> | null>) | null; readonly layers: Pictures };
  /** Moves the preview's time; goes nowhere while there is no preview. */
  readonly transport: { post: (message: ToPreview) => void };
  /** Opens a page to render frames in; null where there is none. */
  readonly film: { open: (() => FilmLink) | null };
  readonly document: DocumentStore;
  readonly selection: SelectionStore;
  readonly canvas: CanvasStore;
  readonly ui: UiStore;
  readonly compile: CompileStore;
  readonly preview: PreviewStore;
  readonly look: LookStore;
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
    pictures: { take: null, layers: createLayerPictures() },
    transport: { post: () => {} },
    film: { open: null },
    document: createDocument(libraries.of({ sources: {}, graphs: {} })),
    selection: createSelection(),
    canvas: createCanvasState(),
    ui: createUi(sizes),
    compile: createCompileState(),
    preview: createPreviewState(),
    look: createLookState(),
    gizmo: createGizmoState(),
    costs: createCostState(),
    preferences: createPreferences(preferences),
  };
}
