import type { RenderSize } from '../../preview-protocol.ts';
import type { Place } from '../editor/canvas-state.ts';
import type { Editor } from '../editor/editor.ts';
import { RENDER_SIZES, SCALES } from '../editor/preferences.ts';
import { soleNode } from '../editor/selection.ts';
import { addToast, type BottomTab, type Dock, middleOfWindow, type PreviewExtent } from '../editor/ui.ts';
import { selectedSubgraph } from '../graph/subgraphs.ts';

export function openSwapPalette({ ui, selection }: Editor): void {
  const node = soleNode(selection.getState());
  if (node !== null) ui.setState({ palette: { at: middleOfWindow(), place: null, end: null, swap: node } });
}

export function askToSaveSubgraph(editor: Editor): void {
  const name = selectedSubgraph(editor);
  if (name !== null) editor.ui.setState({ dialog: { kind: 'library', name } });
}

/** The center of the visible canvas, in canvas units. */
export function canvasCenter({ canvas }: Editor): Place {
  return canvas.getState().middle();
}

/** Opens the palette. If exactly one wire is selected, the new node is inserted into it; if exactly one node is, it continues that node. */
export function openPalette({ ui, selection }: Editor, query = ''): void {
  const selected = selection.getState();
  const [wire] = selected.nodes.size === 0 && selected.wires.size === 1 ? selected.wires : [];
  const after = wire === undefined ? soleNode(selected) : null;
  const where = wire === undefined ? (after === null ? {} : { after }) : { wire };
  ui.setState({ palette: { at: middleOfWindow(), place: null, end: null, query, ...where } });
}

/** Cycles through system, light and dark. */
export function switchTheme({ preferences, ui }: Editor): void {
  const next = { system: 'light', light: 'dark', dark: 'system' } as const;
  const theme = next[preferences.getState().theme];
  preferences.setState({ theme });
  addToast(ui, { tone: 'info', text: theme === 'system' ? 'Theme: system.' : `Theme: ${theme}.` });
}

export function nextScale({ preferences }: Editor, by: 1 | -1): number | undefined {
  const scales: readonly number[] = SCALES;
  return scales[scales.indexOf(preferences.getState().scale) + by];
}

export function setScale({ preferences, ui }: Editor, scale = 1): void {
  preferences.setState({ scale });
  addToast(ui, { tone: 'info', text: `UI scale: ${Math.round(scale * 100)} %.` });
}

export function switchMotion({ preferences, ui }: Editor): void {
  const motion = preferences.getState().motion === 'reduced' ? 'system' : 'reduced';
  preferences.setState({ motion });
  addToast(ui, { tone: 'info', text: motion === 'reduced' ? 'Motion: reduced.' : 'Motion: system.' });
}

const WHEEL_WORDS = {
  auto: 'Scrolling: the mouse wheel zooms, two fingers on a trackpad pan.',
  zoom: 'Scrolling zooms.',
  pan: 'Scrolling pans. Hold Ctrl to zoom.',
} as const;

/** Cycles through automatic, zoom and pan. */
export function switchWheel({ preferences, ui }: Editor): void {
  const wheel = ({ auto: 'zoom', zoom: 'pan', pan: 'auto' } as const)[preferences.getState().wheel];
  preferences.setState({ wheel });
  addToast(ui, { tone: 'info', text: WHEEL_WORDS[wheel] });
}

/** Labels of the render sizes in menus and messages. */
export const RENDER_SIZE_WORDS: Readonly<Record<RenderSize, string>> = {
  auto: 'Render size: automatic (1080p)',
  panel: 'Render size: as the panel',
  720: 'Render size: 720p',
  1080: 'Render size: 1080p',
  1440: 'Render size: 1440p',
};

/** Cycles through the render sizes. */
export function switchRenderSize({ preferences, ui }: Editor): void {
  const at = RENDER_SIZES.indexOf(preferences.getState().renderSize);
  const renderSize = RENDER_SIZES[(at + 1) % RENDER_SIZES.length] ?? 'auto';
  preferences.setState({ renderSize });
  addToast(ui, { tone: 'info', text: RENDER_SIZE_WORDS[renderSize] });
}

export function dockPreview({ ui }: Editor, dock: Dock): void {
  ui.setState({ dock, previewExtent: 'panel' });
}

/** Switches between this extent of the preview and its panel. */
export function togglePreviewExtent({ ui }: Editor, extent: Exclude<PreviewExtent, 'panel'>): void {
  ui.setState(({ previewExtent }) => ({ previewExtent: previewExtent === extent ? 'panel' : extent }));
}

export function toggleBottom({ ui }: Editor, tab: BottomTab): void {
  ui.setState(({ bottom }) => ({ bottom: bottom === tab ? null : tab }));
}
