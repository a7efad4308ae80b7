import { sequence } from '../../../export/graph/commands/change.ts';
import { connect } from '../../../export/graph/commands/wire-commands.ts';
import type { Project } from '../../../export/graph/project.ts';
import { printWire } from '../../../export/graph/wires.ts';
import { apply, endGesture } from '../document/apply.ts';
import { copyShader, editableShader, finishTyping } from '../document/edit-shader.ts';
import { graphOf, layoutOf, nodeOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { selectOnly, soleNode } from '../editor/selection.ts';
import { revealNodes } from '../editor/ui.ts';
import { continuationOf } from '../graph/continue-after.ts';
import { fitEncodings } from '../graph/fit-encodings.ts';
import { placeFreely } from '../graph/free-places.ts';
import { insertOnWire, spaceOnWire } from '../graph/insert-on-wire.ts';
import { addShader } from './add-shader.ts';

/** A filter that is small enough to be read at once, and visible before anything is changed. */
const TEXT = `/*{
  "ISFVSN": "2", "DESCRIPTION": "Tints an image.",
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer" },
    { "NAME": "amount", "TYPE": "float", "LABEL": "Amount", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5 }
  ]
}*/
void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  vec3 tinted = color.rgb * vec3(1.0, 0.75, 0.5);
  gl_FragColor = vec4(mix(color.rgb, tinted, amount), color.a);
}
`;

const OUTPUT = 'output/screen';
const STEP_PX = 280;

/**
 * Adds a filter of the project after the selected node, or before the output, and opens its shader. One undo step. Returns the node id, or
 * null after an error, which is shown.
 */
export function newFilter(editor: Editor): string | null {
  const state = editor.document.getState();
  const { nodes, wires } = graphOf(state);
  const selected = soleNode(editor.selection.getState());
  const toOutput = wires.find(({ to }) => nodes[to.node]?.type === OUTPUT);
  const beside = layoutOf(state).nodes[selected ?? toOutput?.from.node ?? ''] ?? { x: 0, y: 0 };
  const key = `new filter ${state.revision}`;
  const place = { x: beside.x + STEP_PX, y: beside.y };
  const node = addShader(editor, { name: 'my-filter.fs', text: TEXT }, place, { step: { key }, isFree: false });
  if (node === null) return null;
  const after = editor.document.getState();
  const { library, graph, project } = after;
  const definition = library.definition(nodeOf(after, node)?.type ?? '');
  const next = selected !== null && definition ? continuationOf(editor, selected, definition) : null;
  const wire = next === null ? toOutput && printWire(toOutput) : 'wire' in next ? next.wire : undefined;
  const change = sequence(
    project,
    ...(wire === undefined ? [] : [insertOnWire(editor, node, wire), spaceOnWire(editor, node, wire)]),
    ...(next && 'end' in next
      ? [(before: Project) => connect(before, { library, graph, from: next.end, to: { node, port: next.port } }), fitEncodings(editor)]
      : []),
    placeFreely(state.project, { library, graph, hasThumbnail: editor.preferences.getState().thumbnails }),
  );
  apply(editor, 'New filter', change, key);
  endGesture(editor);
  selectOnly(editor.selection, [node]);
  editor.ui.setState({ bottom: 'code' });
  revealNodes(editor.ui, [node]);
  return node;
}

/** Whether exactly one node with an ISF file is selected: a filter, a composite or a generator. */
export function canDuplicateFilter(editor: Editor): boolean {
  return editableShader(editor)?.name.endsWith('.fs') === true;
}

/**
 * Copies the shader of the selected node, of the library or of the project, to a new shader of the project. The node uses it from then on,
 * with its params and wires. Opens the shader. One undo step. Returns the node id, or null after an error, which is shown.
 */
export function duplicateFilter(editor: Editor): string | null {
  finishTyping(editor);
  const node = soleNode(editor.selection.getState());
  if (node === null || !copyShader(editor, node)) return null;
  editor.ui.setState({ bottom: 'code' });
  return node;
}
