import { type Change, sequence } from '../../../export/graph/commands/change.ts';
import { addNode } from '../../../export/graph/commands/node-commands.ts';
import { connect } from '../../../export/graph/commands/wire-commands.ts';
import { makeNodeId } from '../../../export/graph/document-names.ts';
import { MAIN_GRAPH, type Project, type Wire } from '../../../export/graph/project.ts';
import { printWire } from '../../../export/graph/wires.ts';
import { categoryLabel } from '../../../nodes/kit/categories.ts';
import { apply } from '../document/apply.ts';
import { type DocumentState, graphOf, layoutOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { selectOnly } from '../editor/selection.ts';
import { middleOfWindow, revealNodes } from '../editor/ui.ts';
import { placeFreely } from './free-places.ts';
import { showObjects } from './show-objects.ts';

const CAMERA = { type: 'source/camera-video', port: 'layer' } as const;
const SCREEN = { type: 'output/screen', port: 'layer' } as const;
const COLUMN_PX = 320;
const ROW_PX = 200;

/** Whether the main graph is shown and holds nothing but the camera and the output: a project that says what to do first. */
export function isBlank(state: Pick<DocumentState, 'project' | 'graph' | 'open'>): boolean {
  if (state.open === null || state.graph !== MAIN_GRAPH) return false;
  return Object.values(graphOf(state).nodes).every(({ type }) => type === CAMERA.type || type === SCREEN.type);
}

/** Connects the camera to the output where it is not yet, and opens the palette with the nodes for their wire, filters first. */
export function startFilter(editor: Editor, at = middleOfWindow()): void {
  const { project, changes, wire } = cameraOnScreen(editor);
  if (!apply(editor, 'Show the camera', sequence(project, ...changes))) return;
  revealNodes(editor.ui, [], 'fit');
  editor.ui.setState({ palette: { at, place: null, end: null, wire: printWire(wire), first: categoryLabel('filter/sepia') } });
}

/** Adds an object that stands on the floor, in a scene with a light over the camera, as one undo step. Returns its node id. */
export function startObject(editor: Editor): string | null {
  const { project, changes, free } = cameraOnScreen(editor);
  const { library } = editor.document.getState();
  const id = makeNodeId(project, 'objects/primitive', editor.random);
  const change = sequence(
    project,
    ...changes,
    (before) => addNode(before, { library, graph: MAIN_GRAPH, id, type: 'objects/primitive', ...free, params: { sizeM: [0.4, 0.4, 0.4] } }),
    showObjects({ node: id, port: 'objects' }, free, { library, random: editor.random }),
    placeFreely(project, { library, graph: MAIN_GRAPH, hasThumbnail: editor.preferences.getState().thumbnails }),
  );
  if (!apply(editor, 'Place an object', change)) return null;
  selectOnly(editor.selection, [id]);
  revealNodes(editor.ui, [], 'fit');
  return id;
}

/** What is missing of a wire from the camera to the output of a blank project. */
function cameraOnScreen(editor: Editor) {
  const state = editor.document.getState();
  const { project, library } = state;
  const { nodes, wires } = graphOf(state);
  const places = layoutOf(state).nodes;
  const changes: ((before: Project) => Change)[] = [];
  const found = (type: string) => Object.keys(nodes).find((id) => nodes[id]?.type === type);
  const add = (type: string, x: number, y: number): string => {
    const id = makeNodeId(project, type, editor.random);
    changes.push((before) => addNode(before, { library, graph: MAIN_GRAPH, id, type, x, y }));
    return id;
  };
  const [oldCamera, oldScreen] = [found(CAMERA.type), found(SCREEN.type)];
  const at = places[oldCamera ?? ''] ?? { x: (places[oldScreen ?? '']?.x ?? COLUMN_PX) - COLUMN_PX, y: places[oldScreen ?? '']?.y ?? 0 };
  const camera = oldCamera ?? add(CAMERA.type, at.x, at.y);
  const screen = oldScreen ?? add(SCREEN.type, at.x + COLUMN_PX, at.y);
  const wire: Wire = { from: { node: camera, port: CAMERA.port }, to: { node: screen, port: SCREEN.port } };
  if (!wires.some((old) => printWire(old) === printWire(wire))) {
    changes.push((before) => connect(before, { library, graph: MAIN_GRAPH, ...wire }));
  }
  return { project, changes, wire, free: { x: at.x, y: at.y + ROW_PX } };
}
