import { sequence } from '../../../export/graph/commands/change.ts';
import { setParam } from '../../../export/graph/commands/param-commands.ts';
import type { Project } from '../../../export/graph/project.ts';
import type { ParamValue } from '../../../nodes/kit/definition.ts';
import { hasErrors } from '../../../nodes/kit/diagnostics.ts';
import { endCandidate } from '../editor/candidate-state.ts';
import type { Editor } from '../editor/editor.ts';

/** Shows the project in the preview as it would be with this value of a param of the nodes; null ends that. Changes no undo step. */
export function showParamCandidate(editor: Editor, nodes: readonly string[], param: string, value: ParamValue | null): void {
  if (value === null) {
    endCandidate(editor);
    return;
  }
  const { project, library, graph } = editor.document.getState();
  const change = sequence(project, ...nodes.map((node) => (before: Project) => setParam(before, { library, graph, node, param, value })));
  editor.candidate.setState({ project: hasErrors(change.diagnostics) ? null : change.project });
}
