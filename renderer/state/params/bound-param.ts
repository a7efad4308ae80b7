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

/** Null where the open graph has no such node, or its type no such param. */
export function findParam(editor: Editor, node: string, param: string): BoundParam | null {
  const state = editor.document.getState();
  const found = nodeOf(state, node);
  const definition = found && getOwn(state.library.definition(found.type)?.params ?? {}, param);
  return definition ? { definition, binding: getOwn(found.params, param) } : null;
}

/** `key`: of a gesture whose changes are one step. */
export function bind(editor: Editor, label: string, node: string, param: string, binding: Binding, key?: string): boolean {
  const { project, library, graph } = editor.document.getState();
  return apply(editor, label, bindParam(project, { library, graph, node, param, binding }), key);
}
