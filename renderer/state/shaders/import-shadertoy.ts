import { convertShadertoy } from '../../../export/glsl/shadertoy/convert-shadertoy.ts';
import { makeShaderFile } from '../../../export/graph/document-names.ts';
import type { AddStep } from '../document/apply.ts';
import type { Place } from '../editor/canvas-state.ts';
import { layoutOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { selectOnly } from '../editor/selection.ts';
import { addToast, revealNodes, toastDiagnostic } from '../editor/ui.ts';
import { addShader } from './add-shader.ts';

export interface ShadertoySource {
  /** Code of the tabs, or the JSON of the site. */
  readonly source: string;
  /** Default name, if the source contains none. */
  readonly name: string;
}

const GAP_PX = 260;

/**
 * Converts Shadertoy source to an ISF file of the project and adds a node for it, as one undo step. Returns the node id, or null
 * after an error, which is shown.
 */
export function addShadertoy(editor: Editor, { source, name }: ShadertoySource, place: Place, step?: AddStep): string | null {
  const { output, diagnostics } = convertShadertoy(source, name);
  for (const diagnostic of diagnostics) toastDiagnostic(editor.ui, diagnostic);
  if (output === null) return null;
  const node = addShader(editor, { name: makeShaderFile(output.title || name), text: output.text }, place, step && { step });
  if (node !== null) addToast(editor.ui, { tone: 'info', text: `License: ${output.licence}.`, detail: `Credit: ${output.credit}.` });
  return node;
}

/** Imports a shader to the right of the graph, selects its node and scrolls to it. */
export function importShadertoy(editor: Editor, shader: ShadertoySource): boolean {
  const node = addShadertoy(editor, shader, placeBeside(editor));
  if (node === null) return false;
  selectOnly(editor.selection, [node]);
  revealNodes(editor.ui, [node]);
  return true;
}

/** A position to the right of all nodes. */
function placeBeside(editor: Editor): Place {
  const places = Object.values(layoutOf(editor.document.getState()).nodes);
  const last = places.reduce<Place | null>((right, place) => (right === null || place.x > right.x ? place : right), null);
  return last === null ? { x: 0, y: 0 } : { x: last.x + GAP_PX, y: last.y };
}
