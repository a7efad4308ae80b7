import { debounce } from '../../clock.ts';
import type { ToPreview } from '../../preview-protocol.ts';
import type { Editor } from '../editor/editor.ts';
import { probedLayer, viewedLayers } from '../preview/viewed-layers.ts';

/** Height of thumbnails: that of a node’s thumbnail at a pixel ratio of 2. */
const THUMBNAIL_HEIGHT_PX = 192;
/** While the canvas is panned, thumbnails appear and disappear. Waits for a pause before recompiling. */
const PAUSE_MS = 200;

/** Parts of the viewer that the preview shows or reads, or that the program must have. */
const SHOWN = ['left', 'right', 'split', 'probing', 'photographed'] as const;

/** Keeps program and preview in sync with the viewer, the thumbnails and the performance overlay. */
export interface ViewerSync {
  /** Layers that the next program must keep for viewing; see `CompileOptions`. */
  layers(): { readonly taps: readonly string[]; readonly thumbnails: readonly string[] };
  /** Sends the whole state to a preview page that has just loaded. */
  sendAll(): void;
  dispose(): void;
}

/**
 * Creates the viewer sync.
 *
 * @param compile Recompiles the project. A program keeps only the viewed layers, so further ones need another program.
 */
export function createViewerSync(editor: Editor, post: (message: ToPreview) => void, compile: () => void): ViewerSync {
  let compiledTaps = '';
  let compiledThumbnails: ReadonlySet<string> = new Set();
  const layers = () => {
    const taps = viewedLayers(editor);
    const thumbnails = editor.thumbnails.wanted();
    compiledTaps = taps.join();
    compiledThumbnails = new Set(thumbnails);
    return { taps, thumbnails };
  };
  /** Thumbnails that are no longer visible cost nothing, so they wait for the next compile. */
  const compileIfNeeded = () => {
    const isCompiled = editor.thumbnails.wanted().every((layer) => compiledThumbnails.has(layer));
    if (!isCompiled || viewedLayers(editor).join() !== compiledTaps) compile();
  };
  const sendAll = () => {
    const { left, right, split } = editor.viewer.getState();
    post({ kind: 'thumbnails', ports: editor.thumbnails.wanted(), heightPx: THUMBNAIL_HEIGHT_PX });
    post({ kind: 'viewer', left, right, split: split ?? 1, probed: probedLayer(editor) });
    post({ kind: 'cost', on: editor.costs.getState().on });
  };
  const settle = debounce(editor.clock, PAUSE_MS, () => {
    sendAll();
    compileIfNeeded();
  });
  editor.thumbnails.onChange.run = settle.trigger;
  const stopCosts = editor.costs.subscribe((state, before) => {
    if (state.on !== before.on) sendAll();
  });
  const stop = editor.viewer.subscribe((state, before) => {
    const isSame = SHOWN.every((part) => state[part] === before[part]) && state.picking?.layer === before.picking?.layer;
    if (isSame) return;
    sendAll();
    compileIfNeeded();
  });
  return {
    layers,
    sendAll,
    dispose: () => {
      stop();
      stopCosts();
      settle.cancel();
      editor.thumbnails.onChange.run = null;
    },
  };
}
