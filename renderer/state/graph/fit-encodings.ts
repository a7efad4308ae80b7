import type { Change } from '../../../export/graph/commands/change.ts';
import { convertLayers, misfittingWires } from '../../../export/graph/commands/convert-layers.ts';
import { makeNodeId } from '../../../export/graph/document-names.ts';
import type { Project, Wire } from '../../../export/graph/project.ts';
import type { Editor } from '../editor/editor.ts';

/**
 * Returns the last step of a command that connects wires. It inserts “Tone map” or “To scene” where layers of different encodings meet.
 * Wires whose encodings did not fit before the command stay as they are. `connected` are the wires of the command: if a node gets layers of
 * different encodings, those on these wires are converted.
 */
export function fitEncodings(editor: Editor, connected: readonly Wire[] = []): (project: Project) => Change {
  const { project, library, graph } = editor.document.getState();
  const except = misfittingWires(project, library, graph);
  const makeId = (before: Project, type: string): string => makeNodeId(before, type, editor.random);
  return (before) => convertLayers(before, { library, graph, first: connected, except, makeId });
}
