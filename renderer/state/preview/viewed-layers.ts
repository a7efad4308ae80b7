import { MAIN_GRAPH } from '../../../export/graph/project.ts';
import { type DocumentState, graphOf, nodeOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { layerName, layerPortOf } from '../editor/layer-names.ts';
import { soleNode } from '../editor/selection.ts';
import { addToast } from '../editor/ui.ts';
import { resetViewer, type ViewerStore } from '../editor/viewer.ts';

/** The layer that is connected to the Output node of the main graph. */
export function screenLayer({ project }: Pick<DocumentState, 'project'>): string | null {
  const main = graphOf({ project, graph: MAIN_GRAPH });
  const wire = main.wires.filter(({ to }) => main.nodes[to.node]?.type === 'output/screen').at(-1);
  return wire ? `${wire.from.node}.${wire.from.port}` : null;
}

/** The layers that the program must keep for viewing, besides thumbnails. */
export function viewedLayers(editor: Pick<Editor, 'viewer' | 'document'>): readonly string[] {
  const { left, right, photographed } = editor.viewer.getState();
  const layers = [left, right, photographed, probedLayer(editor)];
  return [...new Set(layers.flatMap((layer) => layer ?? []))].sort();
}

/** The layer whose depth the eyedropper or the pixel probe reads; null while neither reads one. */
export function probedLayer({ viewer, document }: Pick<Editor, 'viewer' | 'document'>): string | null {
  const { left, probing, picking } = viewer.getState();
  return picking?.layer ?? (probing ? (left ?? screenLayer(document.getState())) : null);
}

function selectedLayer({ document, selection }: Editor): string | null {
  const state = document.getState();
  const node = soleNode(selection.getState());
  const port = node === null ? null : layerPortOf(state.library.definition(nodeOf(state, node)?.type ?? ''));
  return node === null || port === null ? null : layerName(state, node, port);
}

/** Shows the layer of the selected node in the preview, or the screen output if the layer is already shown. */
export function pinSelected(editor: Editor): void {
  const layer = selectedLayer(editor);
  if (layer !== null) pinLayer(editor.viewer, layer);
  else addToast(editor.ui, { tone: 'info', text: 'Select one node that outputs a layer to show it in the preview.' });
}

export function pinLayer(viewer: ViewerStore, layer: string): void {
  if (viewer.getState().left === layer) resetViewer(viewer);
  else viewer.setState({ left: layer, right: null, split: null, beforeCamera: null });
}

/** Shows the layer of the selected node next to the current one, with a wipe between them. */
export function compareSelected(editor: Editor): void {
  const layer = selectedLayer(editor);
  if (layer !== null) compareLayer(editor.viewer, layer);
  else addToast(editor.ui, { tone: 'info', text: 'Select one node that outputs a layer to compare it.' });
}

export function compareLayer(viewer: ViewerStore, layer: string): void {
  const { left } = viewer.getState();
  if (left === null || left === layer) viewer.setState({ left: layer, right: null, split: 0.5, beforeCamera: null });
  else viewer.setState({ right: layer, split: 0.5, beforeCamera: null });
}
