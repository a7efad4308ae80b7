import { changeType } from '../../../export/graph/commands/change-type.ts';
import { MAIN_GRAPH, type Project } from '../../../export/graph/project.ts';
import { printWire } from '../../../export/graph/wires.ts';
import { hasErrors } from '../../../nodes/kit/diagnostics.ts';
import { graphOf, nodeOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import type { PaletteRequest } from '../editor/ui.ts';
import { continuationOf } from './continue-after.ts';
import { additionOf } from './edit-graph.ts';
import { portsThrough, wireTypes } from './insert-on-wire.ts';
import type { PaletteEntry } from './palette-search.ts';
import { recipeOfEntry } from './recipes.ts';
import { recipeAddition } from './show-recipe.ts';

/**
 * The project as it would look with an entry of the palette: in the wire, in place of the node or after the node that the palette was opened
 * for, else in the wire to the output, or for objects in a wire to a scene. Recipes bring what they need. Null if the entry fits none of them.
 */
export function candidateOf(
  editor: Editor,
  entry: PaletteEntry,
  { wire, swap, after }: Pick<PaletteRequest, 'wire' | 'swap' | 'after'>,
): Project | null {
  const { project, library, graph } = editor.document.getState();
  if (swap !== undefined) {
    const change = changeType(project, { library, graph, node: swap, type: entry.definition.type });
    return hasErrors(change.diagnostics) ? null : change.project;
  }
  const recipe = recipeOfEntry(editor, entry.definition.type);
  if (recipe && wire === undefined && graph === MAIN_GRAPH) {
    const { change } = recipeAddition(editor, recipe, after, { x: 0, y: 0 });
    return hasErrors(change.diagnostics) ? null : change.project;
  }
  const next = after === undefined ? null : continuationOf(editor, after, entry.definition);
  const places = next && 'wire' in next ? [next.wire] : [...wiresToScenes(editor, after), ...wireToOutput(editor)];
  const through = (wire === undefined ? places : [wire]).find((one) => {
    const types = wireTypes(editor, one);
    return types !== null && portsThrough(entry.definition, types) !== null;
  });
  if (through === undefined) return null;
  const { change } = additionOf(editor, entry, { x: 0, y: 0 }, null, through);
  return hasErrors(change.diagnostics) ? null : change.project;
}

/** The wire that carries the image to the output; none inside of subgraphs. */
function wireToOutput({ document }: Editor): readonly string[] {
  const state = document.getState();
  if (state.graph !== MAIN_GRAPH) return [];
  const wire = graphOf(state).wires.find(({ to }) => nodeOf(state, to.node)?.type === 'output/screen');
  return wire === undefined ? [] : [printWire(wire)];
}

/** The wires to scenes, those from a node if there are any. */
function wiresToScenes({ document }: Editor, node: string | undefined): readonly string[] {
  const state = document.getState();
  const all = graphOf(state).wires.filter(({ to }) => nodeOf(state, to.node)?.type === 'layer/scene');
  const own = all.filter(({ from }) => from.node === node);
  return (own.length > 0 ? own : all).map(printWire);
}
