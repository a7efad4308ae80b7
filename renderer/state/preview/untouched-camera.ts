import { MAIN_GRAPH } from '../../../export/graph/project.ts';
import { graphOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { layerName, layerPortOf } from '../editor/layer-names.ts';
import { addToast } from '../editor/ui.ts';

const CAMERA_TYPE = 'source/camera-video';

/** Shows the camera video without effects in the preview, or what was shown before it. */
export function toggleCamera(editor: Editor): void {
  const { viewer, ui, document } = editor;
  const { left, right, split, beforeCamera } = viewer.getState();
  if (beforeCamera !== null) {
    hideCamera(editor);
    return;
  }
  const layer = cameraLayer(editor);
  if (layer === null) {
    addToast(ui, { tone: 'info', text: `“${document.getState().project.title}” does not show the camera.` });
    return;
  }
  viewer.setState({ left: layer, right: null, split: null, beforeCamera: { left, right, split } });
}

export function hideCamera({ viewer }: Pick<Editor, 'viewer'>): void {
  const { beforeCamera } = viewer.getState();
  if (beforeCamera !== null) viewer.setState({ ...beforeCamera, beforeCamera: null });
}

/** The layer of the first camera node of the main graph; null if there is none. */
function cameraLayer({ document }: Pick<Editor, 'document'>): string | null {
  const { project, library } = document.getState();
  const { nodes } = graphOf({ project, graph: MAIN_GRAPH });
  const id = Object.keys(nodes).find((node) => nodes[node]?.type === CAMERA_TYPE);
  const port = layerPortOf(library.definition(CAMERA_TYPE));
  return id === undefined || port === null ? null : layerName({ project, graph: MAIN_GRAPH, trail: [] }, id, port);
}
