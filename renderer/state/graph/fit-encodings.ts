import type { Change } from '../../../export/graph/commands/change.ts';
import { convertLayers, misfittingWires } from '../../../export/graph/commands/convert-layers.ts';
import { makeNodeId } from '../../../export/graph/document-names.ts';
import type { Project, Wire } from '../../../export/graph/project.ts';
import type { Editor } from '../editor/editor.ts';

/**
 * The last step of a command that connects wires: inserts “Tone map” and “To scene” where layers of different encodings meet since the
 * command began. `connected` are its wires; where two layers differ, theirs is converted.
 */
export function fitEncodings(editor: Editor, connected: readonly Wire[] = []): (project: Project) => Change {
  const { project, library, graph } = editor.document.getState();
  const except = misfittingWires(project, library, graph);
  const makeId = (before: Project, type: string): string => makeNodeId(before, type, editor.random);
  return (before) => convertLayers(before, { library, graph, first: connected, except, makeId });
}
