import { createStore, type StoreApi } from 'zustand/vanilla';
import type { PreviewProbe } from '../../preview-protocol.ts';

/** What is looked at besides the screen. Layers are named as the compiler names them: `outer/inner.port`. */
export interface ViewerState {
  /** Nodes that give layers show them. */
  readonly thumbnails: boolean;
  /** What the preview shows left of `split` instead of the screen; null: the screen. */
  readonly left: string | null;
  readonly right: string | null;
  /** Part of the preview's width; null: the left one is everywhere. */
  readonly split: number | null;
  /** The pointer over the preview asks what is under it. */
  readonly probing: boolean;
  readonly probed: PreviewProbe | null;
  /** Somebody waits for a color of the picture. */
  readonly picking: ColorWish | null;
}

/** The eyedropper is over the preview for it. */
export interface ColorWish {
  /** What the color is for. */
  readonly label: string;
  /** Display-referred sRGB, each in [0, 1]. */
  readonly take: (color: readonly [number, number, number]) => void;
  /** It has ended by itself, with a color or without. */
  readonly onEnd: () => void;
}

export type ViewerStore = StoreApi<ViewerState>;

const NOTHING: ViewerState = { thumbnails: false, left: null, right: null, split: null, probing: false, probed: null, picking: null };

export function createViewerState(): ViewerStore {
  return createStore<ViewerState>(() => NOTHING);
}

export function resetViewer(store: ViewerStore): void {
  const { thumbnails, picking } = store.getState();
  store.setState({ ...NOTHING, thumbnails, picking });
}

/** Who wants small pictures of which layers. They come here and not through a store: nothing else of the page is drawn for them. */
export interface ThumbnailWatchers {
  /** Watches until the returned function is called. The watcher closes the pictures. */
  watch(layer: string, onPicture: (picture: ImageBitmap) => void): () => void;
  wanted(): readonly string[];
  onChange: { run: (() => void) | null };
  deliver(layer: string, picture: ImageBitmap): void;
}

export function createThumbnailWatchers(): ThumbnailWatchers {
  const watchers = new Map<string, Set<(picture: ImageBitmap) => void>>();
  const onChange: ThumbnailWatchers['onChange'] = { run: null };
  return {
    onChange,
    watch: (layer, onPicture) => {
      const all = watchers.get(layer) ?? new Set();
      all.add(onPicture);
      watchers.set(layer, all);
      onChange.run?.();
      return () => {
        all.delete(onPicture);
        if (all.size === 0 && watchers.get(layer) === all) watchers.delete(layer);
        onChange.run?.();
      };
    },
    wanted: () => [...watchers.keys()].sort(),
    deliver: (layer, picture) => {
      const [first] = watchers.get(layer) ?? [];
      if (first) first(picture);
      else picture.close();
    },
  };
}
