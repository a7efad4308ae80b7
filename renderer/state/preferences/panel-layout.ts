import { debounce } from '../../clock.ts';
import type { Editor } from '../editor/editor.ts';
import { DEVICE_FRAMES, PHONE_SHAPE, type PreviewState } from '../editor/preview-state.ts';
import { DEFAULT_SIZES, DOCKS, type Dock, type PanelSizes } from '../editor/ui.ts';

/** The stored part of the layout of panels. */
export interface PanelLayout {
  readonly sizes: PanelSizes;
  readonly dock: Dock;
  /** The device frame of the preview. */
  readonly frame: PreviewState['frame'];
}

const KEY = 'scrim-panels';
const PAUSE_MS = 300;
/** Fraction of the window's width that the image of the preview gets. */
const SIDE_FRACTION = 0.4;
/** Width of the rail beside the image. */
const RAIL_PX = 33;
/** Height ÷ width of a new preview, without its transport: that of most cameras, so that a recording fills it. */
const PREVIEW_SHAPE = 0.75;
const TRANSPORT_PX = 38;
/** Fraction of the window's height that the preview leaves to the inspector below it. */
const INSPECTOR_FRACTION = 0.42;
/** Fraction of the window's height that a preview above the inspector gets if its picture is higher than wide. */
const UPRIGHT_FRACTION = 0.68;
/** Height of the top bar and the status bar. */
const BARS_PX = 70;
/** Space around a device. */
const CASE_PX = 24;
/** Most that a phone beside the inspector takes of the window's width: by default, and always in a narrow window. */
const TALL_SIDE_FRACTION = 0.5;
/** Least width of the graph. */
const GRAPH_LEAST_PX = 360;
/** Pictures with a smaller width ÷ height get the whole height beside the inspector. */
const TALL_SHAPE = 0.7;
/** Least width of preview and inspector for that, in CSS pixels. */
const TALL_LEAST_PX = 520;
const NARROW_PX = 1200;
const NARROW_SIZES = { bottomHeightPx: 250, helpWidthPx: 240 };

/** Reads the stored layout. Missing or invalid values become defaults, which depend on the size of the window. */
export function loadLayout(storage: Pick<Storage, 'getItem'>, windowWidthPx: number, windowHeightPx: number): PanelLayout {
  let saved: Partial<Record<keyof PanelSizes | 'dock' | 'frame', unknown>> = {};
  try {
    saved = (JSON.parse(storage.getItem(KEY) ?? '{}') ?? {}) as typeof saved;
  } catch {
    // Invalid JSON: use the defaults.
  }
  const defaults = sizesFor(windowWidthPx, windowHeightPx);
  const size = (name: keyof PanelSizes) => {
    const value = saved[name];
    return typeof value === 'number' && value > 0 && value < 10_000 ? value : defaults[name];
  };
  return {
    sizes: {
      sideWidthPx: size('sideWidthPx'),
      previewHeightPx: size('previewHeightPx'),
      bottomHeightPx: size('bottomHeightPx'),
      helpWidthPx: size('helpWidthPx'),
      belowHeightPx: size('belowHeightPx'),
      inspectorWidthPx: size('inspectorWidthPx'),
      uprightHeightPx: size('uprightHeightPx'),
      tallSideWidthPx: size('tallSideWidthPx'),
      tallInspectorWidthPx: size('tallInspectorWidthPx'),
    },
    dock: DOCKS.find((dock) => dock === saved.dock) ?? 'right',
    frame: DEVICE_FRAMES.find((frame) => frame === saved.frame) ?? 'auto',
  };
}

function sizesFor(windowWidthPx: number, windowHeightPx: number): PanelSizes {
  const imageWidthPx = Math.round(windowWidthPx * SIDE_FRACTION);
  const shapedPx = imageWidthPx * PREVIEW_SHAPE + TRANSPORT_PX;
  const phoneHeightPx = windowHeightPx - BARS_PX - TRANSPORT_PX - CASE_PX;
  const tallPx = phoneHeightPx * PHONE_SHAPE + CASE_PX + RAIL_PX + DEFAULT_SIZES.tallInspectorWidthPx;
  return {
    ...DEFAULT_SIZES,
    ...(windowWidthPx < NARROW_PX ? NARROW_SIZES : {}),
    sideWidthPx: imageWidthPx + RAIL_PX,
    previewHeightPx: Math.round(Math.min(shapedPx, windowHeightPx * (1 - INSPECTOR_FRACTION))),
    belowHeightPx: Math.round(windowHeightPx * 0.5),
    uprightHeightPx: Math.round(windowHeightPx * UPRIGHT_FRACTION),
    tallSideWidthPx: Math.round(Math.max(imageWidthPx + RAIL_PX, Math.min(tallPx, windowWidthPx * TALL_SIDE_FRACTION))),
  };
}

/**
 * Where the preview stands in a dock beside the graph: `above` or `beside` the inspector, its stored sizes, and the least width of the graph in
 * CSS pixels.
 */
export type SideArrangement = { readonly graphLeastPx: number } & (
  | { readonly place: 'above'; readonly side: 'sideWidthPx' | 'tallSideWidthPx'; readonly preview: 'previewHeightPx' | 'uprightHeightPx' }
  | { readonly place: 'beside'; readonly side: 'tallSideWidthPx'; readonly inspector: 'tallInspectorWidthPx' }
);

/**
 * Arranges the preview by the shape of its picture, so that the picture is as large as the dock permits.
 *
 * @param shape Width ÷ height of the picture; null for that of the panel.
 * @param windowWidthPx The stored sizes may be those of a wider window.
 */
export function arrangeSide(shape: number | null, sizes: PanelSizes, windowWidthPx: number): SideArrangement {
  const graphLeastPx = GRAPH_LEAST_PX;
  if (shape === null || shape >= 1) return { place: 'above', side: 'sideWidthPx', preview: 'previewHeightPx', graphLeastPx };
  if (shape >= TALL_SHAPE) return { place: 'above', side: 'sideWidthPx', preview: 'uprightHeightPx', graphLeastPx };
  const mostPx = windowWidthPx < NARROW_PX ? windowWidthPx * TALL_SIDE_FRACTION : windowWidthPx - GRAPH_LEAST_PX;
  const tall = { side: 'tallSideWidthPx', graphLeastPx: windowWidthPx - mostPx } as const;
  if (Math.min(sizes.tallSideWidthPx, mostPx) < TALL_LEAST_PX) return { place: 'above', preview: 'uprightHeightPx', ...tall };
  return { place: 'beside', inspector: 'tallInspectorWidthPx', ...tall };
}

/** Stores the layout after each change. */
export function keepLayout({ ui, preview, clock }: Editor, storage: Pick<Storage, 'setItem'>): () => void {
  const keep = debounce(clock, PAUSE_MS, () => {
    const { sizes, dock } = ui.getState();
    storage.setItem(KEY, JSON.stringify({ ...sizes, dock, frame: preview.getState().frame }));
  });
  const stops = [
    ui.subscribe((state, before) => {
      if (state.sizes !== before.sizes || state.dock !== before.dock) keep.trigger();
    }),
    preview.subscribe((state, before) => {
      if (state.frame !== before.frame) keep.trigger();
    }),
  ];
  return () => {
    for (const stop of stops) stop();
    keep.cancel();
  };
}
