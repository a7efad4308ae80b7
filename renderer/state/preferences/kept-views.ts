import { MAIN_GRAPH } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { debounce } from '../../clock.ts';
import type { CanvasPlace } from '../editor/canvas-state.ts';
import type { Editor } from '../editor/editor.ts';
import { chosenSource, frameOf, isLoading } from '../editor/preview-state.ts';
import { selectOnly } from '../editor/selection.ts';
import { revealNodes, revealPlace } from '../editor/ui.ts';
import { pathToGraph } from '../graph/graph-path.ts';
import { goToFrame, isHeld, lastFrame, togglePlay } from '../preview/playback.ts';

/** Where a person left a project. */
interface KeptView {
  readonly graph: string;
  /** What the canvas shows; null if the project was closed before it was drawn. */
  readonly place: CanvasPlace | null;
  readonly nodes: readonly string[];
  /** The frame at which a recording was paused; null if the preview played, or showed no recording. */
  readonly held: HeldFrame | null;
}

interface HeldFrame {
  /** Id of the preview source; null for any recording. */
  readonly source: string | null;
  readonly frame: number;
}

const KEY = 'scrim-views';
/** Maximum number of stored views; the oldest are dropped. */
const MOST = 200;
const PAUSE_MS = 400;

type Kept = Pick<Editor, 'document' | 'canvas' | 'selection' | 'preview' | 'transport' | 'ui' | 'clock'>;

/** What stands in the preview of a project that opens for the first time: a recording at its first frame. Other sources play. */
const FIRST: HeldFrame = { source: null, frame: 0 };

/**
 * Restores open graph, view, selection and paused frame when a project opens, and stores their changes. The first time, the view fits the
 * whole graph, and a recording is paused at its first frame.
 */
export function keepViews(editor: Kept, storage: Pick<Storage, 'getItem' | 'setItem'>): () => void {
  const { document, canvas, selection, preview } = editor;
  const kept = new Map(readAll(storage));
  let path: string | null = null;
  /** What the preview does once the source of the opened project is loaded. */
  let wanted: HeldFrame | 'play' | null = null;
  /** Whether the preview of the project before was paused. A pause since then is of the person and stays. */
  let wasHeld = false;

  const store = () => {
    if (path === null) return;
    const { graph } = document.getState();
    kept.delete(path);
    const held = wanted === null ? heldFrame(editor) : wanted === 'play' ? null : wanted;
    kept.set(path, { graph, place: canvas.getState().shown, nodes: [...selection.getState().nodes], held });
    for (const oldest of kept.keys()) if (kept.size > MOST) kept.delete(oldest);
    storage.setItem(KEY, JSON.stringify([...kept]));
  };
  const storeLater = debounce(editor.clock, PAUSE_MS, store);
  const note = storeLater.trigger;
  const restore = (view: KeptView | null) => {
    const { project } = document.getState();
    if (view === null) {
      revealNodes(editor.ui, [], 'fit');
      return;
    }
    const graph = getOwn(project.graphs, view.graph) ? view.graph : MAIN_GRAPH;
    if (graph !== document.getState().graph) document.setState({ graph, trail: pathToGraph(project, graph) });
    const nodes = getOwn(project.graphs, graph)?.nodes ?? {};
    if (graph === view.graph) {
      selectOnly(
        editor.selection,
        view.nodes.filter((id) => Object.hasOwn(nodes, id)),
      );
    }
    if (graph === view.graph && view.place !== null) revealPlace(editor.ui, view.place);
    else revealNodes(editor.ui, [], 'fit');
  };
  /** `sameWork`: the project was saved as a copy and keeps its state. */
  const follow = (sameWork: boolean) => {
    // What changed last, such as the selection, may be of the next project already.
    storeLater.cancel();
    const before = path;
    const { open } = document.getState();
    path = open?.displayPath ?? null;
    if (open === null || path === null || sameWork) return;
    const view = open.isNew ? null : (kept.get(path) ?? null);
    // A project that was loaded again plays on.
    wanted = path === before ? null : view === null ? FIRST : (view.held ?? 'play');
    wasHeld = isHeld(preview.getState());
    restore(view);
  };
  const seek = () => {
    const state = preview.getState();
    if (wanted === null || isLoading(state)) return;
    const to = wanted;
    wanted = null;
    const stands = to !== 'play' && state.frames !== null && (to.source === null || chosenSource(state)?.id === to.source);
    if (stands) goToFrame(editor, Math.min(to.frame, lastFrame(state)));
    else if (wasHeld && isHeld(state)) togglePlay(editor);
  };
  const stops = [
    document.subscribe((state, before) => {
      if (state.open !== before.open) follow(state.project === before.project && before.open !== null);
      else if (state.graph !== before.graph) note();
    }),
    canvas.subscribe((state, before) => {
      if (state.shown !== before.shown) note();
    }),
    selection.subscribe(note),
    preview.subscribe((state, before) => {
      seek();
      if (isHeld(state) && (!isHeld(before) || frameOf(state) !== frameOf(before))) note();
      if (!isHeld(state) && isHeld(before)) note();
    }),
  ];
  return () => {
    for (const stop of stops) stop();
    storeLater.cancel();
  };
}

function heldFrame({ preview }: Pick<Editor, 'preview'>): KeptView['held'] {
  const state = preview.getState();
  const source = chosenSource(state)?.id;
  return isHeld(state) && state.frames !== null && source !== undefined ? { source, frame: frameOf(state) } : null;
}

function readAll(storage: Pick<Storage, 'getItem'>): [string, KeptView][] {
  try {
    const saved: unknown = JSON.parse(storage.getItem(KEY) ?? '[]');
    return Array.isArray(saved) ? saved.filter(isEntry) : [];
  } catch {
    // Invalid JSON: there is nothing to restore.
    return [];
  }
}

function isEntry(value: unknown): value is [string, KeptView] {
  if (!Array.isArray(value) || typeof value[0] !== 'string') return false;
  const { graph, place, nodes, held } = (value[1] ?? {}) as Partial<KeptView>;
  const isPlace = place === null || [place?.x, place?.y, place?.zoom].every(Number.isFinite);
  const isHeldFrame =
    held === null || ((held?.source === null || typeof held?.source === 'string') && Number.isInteger(held.frame) && held.frame >= 0);
  return typeof graph === 'string' && isPlace && Array.isArray(nodes) && nodes.every((id) => typeof id === 'string') && isHeldFrame;
}
