import { debounce } from '../../clock.ts';
import type { ToPreview } from '../../preview-protocol.ts';
import type { Editor } from '../editor/editor.ts';
import { viewedLayers } from '../preview/viewed-layers.ts';

/** Of thumbnails: as large as a node shows them on a screen of two pixels a point. */
const THUMBNAIL_HEIGHT_PX = 192;
/** While the canvas is panned, nodes come and go; programs are made for those that stay. */
const PAUSE_MS = 200;

/** Keeps the program and the preview up with what is looked at besides the screen. */
export interface ViewerSync {
  /** Layers that the next program has to keep. */
  taps(): readonly string[];
  /** A preview page came anew. */
  tell(): void;
  dispose(): void;
}

/** A layer has a picture of its own to look at only while somebody does: that is another program, which `compile` asks for. */
export function createViewerSync(editor: Editor, post: (message: ToPreview) => void, compile: () => void): ViewerSync {
  let asked = '';
  const taps = () => {
    const layers = viewedLayers(editor);
    asked = layers.join();
    return layers;
  };
  const tell = () => {
    const { left, right, split } = editor.viewer.getState();
    post({ kind: 'thumbnails', ports: editor.thumbnails.wanted(), heightPx: THUMBNAIL_HEIGHT_PX });
    post({ kind: 'viewer', left, right, split: split ?? 1 });
    post({ kind: 'cost', on: editor.costs.getState().on });
  };
  const settle = debounce(editor.clock, PAUSE_MS, () => {
    tell();
    if (viewedLayers(editor).join() !== asked) compile();
  });
  editor.thumbnails.onChange.run = settle.trigger;
  const stopCosts = editor.costs.subscribe((state, before) => {
    if (state.on !== before.on) tell();
  });
  const stop = editor.viewer.subscribe((state, before) => {
    if (state.left === before.left && state.right === before.right && state.split === before.split && state.probing === before.probing)
      return;
    tell();
    if (viewedLayers(editor).join() !== asked) compile();
  });
  return {
    taps,
    tell,
    dispose: () => {
      stop();
      stopCosts();
      settle.cancel();
      editor.thumbnails.onChange.run = null;
    },
  };
}
