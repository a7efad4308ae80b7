import { bindParam } from '../../../export/graph/commands/param-commands.ts';
import type { Binding } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { ParamDefinition } from '../../../nodes/kit/definition.ts';
import { apply } from '../document/apply.ts';
import { nodeOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';

export interface BoundParam {
  readonly definition: ParamDefinition;
  readonly binding: Binding | undefined;
}

/** A param with its binding; null if the node or the param does not exist. */
export function findParam(editor: Editor, node: string, param: string): BoundParam | null {
  const state = editor.document.getState();
  const found = nodeOf(state, node);
  const definition = found && getOwn(state.library.definition(found.type)?.params ?? {}, param);
  return definition ? { definition, binding: getOwn(found.params, param) } : null;
}

/**
 * Sets the binding of a param.
 *
 * @param key Groups the changes of a gesture into one undo step.
 */
export function bind(editor: Editor, label: string, node: string, param: string, binding: Binding, key?: string): boolean {
  const { project, library, graph } = editor.document.getState();
  return apply(editor, label, bindParam(project, { library, graph, node, param, binding }), key);
}
