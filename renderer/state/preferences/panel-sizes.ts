import { debounce } from '../../clock.ts';
import type { Editor } from '../editor/editor.ts';
import { DEFAULT_SIZES, type PanelSizes } from '../editor/ui.ts';

const KEY = 'scrim-panels';
const PAUSE_MS = 300;
const NARROW_PX = 1200;
const NARROW_SIZES = { sideWidthPx: 330, previewHeightPx: 270, bottomHeightPx: 250, helpWidthPx: 240 };

/** Reads the stored sizes. Missing or invalid values become defaults, which are smaller in a narrow window. */
export function loadSizes(storage: Pick<Storage, 'getItem'>, windowWidthPx: number): PanelSizes {
  let saved: Partial<Record<keyof PanelSizes, unknown>> = {};
  try {
    saved = (JSON.parse(storage.getItem(KEY) ?? '{}') ?? {}) as typeof saved;
  } catch {
    // Invalid JSON: use the defaults.
  }
  const defaults = windowWidthPx < NARROW_PX ? { ...DEFAULT_SIZES, ...NARROW_SIZES } : DEFAULT_SIZES;
  const size = (name: keyof PanelSizes) => {
    const value = saved[name];
    return typeof value === 'number' && value > 0 && value < 10_000 ? value : defaults[name];
  };
  return {
    sideWidthPx: size('sideWidthPx'),
    previewHeightPx: size('previewHeightPx'),
    bottomHeightPx: size('bottomHeightPx'),
    helpWidthPx: size('helpWidthPx'),
  };
}

export function keepSizes({ ui, clock }: Editor, storage: Pick<Storage, 'setItem'>): () => void {
  const keep = debounce(clock, PAUSE_MS, () => storage.setItem(KEY, JSON.stringify(ui.getState().sizes)));
  const stop = ui.subscribe((state, before) => {
    if (state.sizes !== before.sizes) keep.trigger();
  });
  return () => {
    stop();
    keep.cancel();
  };
}
