import { sequence, unchanged } from '../../../export/graph/commands/change.ts';
import { bindParam, setParam } from '../../../export/graph/commands/param-commands.ts';
import { disconnect } from '../../../export/graph/commands/wire-commands.ts';
import type { Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { ParamValue } from '../../../nodes/kit/definition.ts';
import { apply } from '../document/apply.ts';
import { graphOf, nodeOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';

/** Sets the value of a param. Successive edits form one undo step until `endGesture`. */
export function editParam(editor: Editor, node: string, param: string, value: ParamValue): boolean {
  const { project, library, graph } = editor.document.getState();
  const label = library.definition(nodeOf(editor.document.getState(), node)?.type ?? '')?.params[param]?.label ?? param;
  return apply(editor, `Change ${label}`, setParam(project, { library, graph, node, param, value }), `param ${graph} ${node} ${param}`);
}

/** Sets several params of a node. Edits with the same `key` form one undo step until `endGesture`. */
export function editParams(
  editor: Editor,
  label: string,
  node: string,
  edits: readonly { readonly param: string; readonly value: ParamValue }[],
  key: string,
): boolean {
  const { project, library, graph } = editor.document.getState();
  const steps = edits.map((edit) => (before: Project) => setParam(before, { library, graph, node, ...edit }));
  return apply(editor, label, sequence(project, ...steps), key);
}

/** Resets a param to its default value. Removes its wires, track or expression. */
export function resetParam(editor: Editor, node: string, param: string): boolean {
  const state = editor.document.getState();
  const { project, library, graph } = state;
  const definition = library.definition(nodeOf(state, node)?.type ?? '')?.params[param];
  if (!definition) return false;
  const wires = graphOf(state).wires.filter(({ to }) => to.node === node && to.port === param);
  const change = sequence(
    project,
    (before) => (wires.length === 0 ? unchanged(before) : disconnect(before, { graph, wires })),
    (before) => bindParam(before, { library, graph, node, param, binding: { value: definition.default } }),
  );
  return apply(editor, `Reset ${definition.label}`, change);
}

/** Shows a param as a port of its node, or hides the port. */
export function setExposed(editor: Editor, node: string, param: string, exposed: boolean): boolean {
  const state = editor.document.getState();
  const { project, library, graph } = state;
  const definition = library.definition(nodeOf(state, node)?.type ?? '')?.params[param];
  if (!definition) return false;
  const binding = getOwn(nodeOf(state, node)?.params ?? {}, param);
  const held = binding && 'value' in binding ? binding.value : binding && 'port' in binding ? binding.port : definition.default;
  const next = exposed ? { port: held } : { value: held };
  return apply(
    editor,
    exposed ? `Show ${definition.label} as a port` : `Hide the port ${definition.label}`,
    bindParam(project, { library, graph, node, param, binding: next }),
  );
}
