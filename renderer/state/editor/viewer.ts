import { createStore, type StoreApi } from 'zustand/vanilla';
import type { PreviewProbe } from '../../preview-protocol.ts';

/** State of the viewer. Layers have their names in the program: `outer/inner.port`. */
export interface ViewerState {
  /** The layer that the preview shows to the left of `split`; null for the screen output. */
  readonly left: string | null;
  readonly right: string | null;
  /** Position of the wipe as a fraction of the preview’s width; null shows the left layer everywhere. */
  readonly split: number | null;
  /** What was shown before the untouched camera; null unless that is shown. */
  readonly beforeCamera: ShownLayers | null;
  /** Whether the pixel probe is on. */
  readonly probing: boolean;
  readonly probed: PreviewProbe | null;
  /** The layer that the dialog for photographs takes; null while it is closed. */
  readonly photographed: string | null;
  /** What the eyedropper picks a pixel for; null if it is closed. */
  readonly picking: PickRequest | null;
  /** Whether the frame of the poster is shown, to be moved. */
  readonly framing: boolean;
}

export type ShownLayers = Pick<ViewerState, 'left' | 'right' | 'split'>;

/** A request for the eyedropper. */
export interface PickRequest {
  /** What is picked, such as the label of a param. */
  readonly label: string;
  readonly what: 'color' | 'point';
  /** The layer on which a point is picked, whatever is in front of it; null for colors. */
  readonly layer: string | null;
  readonly take: (probe: PreviewProbe) => void;
  /** Called when the eyedropper closes, with or without a pixel. */
  readonly onEnd: () => void;
}

export type ViewerStore = StoreApi<ViewerState>;

const NOTHING: ViewerState = {
  left: null,
  right: null,
  split: null,
  beforeCamera: null,
  probing: false,
  probed: null,
  photographed: null,
  picking: null,
  framing: false,
};

export function createViewerState(): ViewerStore {
  return createStore<ViewerState>(() => NOTHING);
}

export function resetViewer(store: ViewerStore): void {
  const { picking } = store.getState();
  store.setState({ ...NOTHING, picking });
}

/** Components that show thumbnails. Thumbnails bypass the stores, so that a new one rerenders nothing. */
export interface ThumbnailWatchers {
  /** Watches a layer until the returned function is called. The watcher must close the bitmaps. */
  watch(layer: string, onImage: (picture: ImageBitmap) => void): () => void;
  /** The watched layers, of which at most `MOST_THUMBNAILS` are shown. */
  wanted(): readonly string[];
  onChange: { run: (() => void) | null };
  deliver(layer: string, picture: ImageBitmap): void;
}

/** Each layer with a thumbnail has a render target of the size of the preview. More would take too much memory in large graphs. */
const MOST_THUMBNAILS = 40;

export function createThumbnailWatchers(): ThumbnailWatchers {
  const watchers = new Map<string, Set<(picture: ImageBitmap) => void>>();
  const onChange: ThumbnailWatchers['onChange'] = { run: null };
  return {
    onChange,
    watch: (layer, onImage) => {
      const all = watchers.get(layer) ?? new Set();
      all.add(onImage);
      watchers.set(layer, all);
      onChange.run?.();
      return () => {
        all.delete(onImage);
        if (all.size === 0 && watchers.get(layer) === all) watchers.delete(layer);
        onChange.run?.();
      };
    },
    wanted: () => [...watchers.keys()].slice(0, MOST_THUMBNAILS).sort(),
    deliver: (layer, picture) => {
      const [first] = watchers.get(layer) ?? [];
      if (first) first(picture);
      else picture.close();
    },
  };
}
