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

/**
 * The project as it would look with an entry of the palette: in the wire, in place of the node or after the node that the palette was opened
 * for, else in the wire to the output. Null if the entry does not fit there.
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
  const next = after === undefined ? null : continuationOf(editor, after, entry.definition);
  const through = wire ?? (next && 'wire' in next ? next.wire : wireToOutput(editor));
  const types = through === null ? null : wireTypes(editor, through);
  if (through === null || types === null || portsThrough(entry.definition, types) === null) return null;
  const { change } = additionOf(editor, entry, { x: 0, y: 0 }, null, through);
  return hasErrors(change.diagnostics) ? null : change.project;
}

/** The wire that carries the image to the output; null inside of subgraphs, and if there is none. */
function wireToOutput({ document }: Editor): string | null {
  const state = document.getState();
  if (state.graph !== MAIN_GRAPH) return null;
  const wire = graphOf(state).wires.find(({ to }) => nodeOf(state, to.node)?.type === 'output/screen');
  return wire === undefined ? null : printWire(wire);
}
