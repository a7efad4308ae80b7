import { sequence } from '../../../export/graph/commands/change.ts';
import { setParam } from '../../../export/graph/commands/param-commands.ts';
import type { Graph, Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { ParamDefinition, ParamValue } from '../../../nodes/kit/definition.ts';
import { apply } from '../document/apply.ts';
import { nodeOf, type OpenGraph } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { boundValue } from './value-text.ts';

/** A param that all selected nodes have, with a plain value in each. */
export interface SharedParam {
  readonly name: string;
  /** Definition of the first node. */
  readonly param: ParamDefinition;
  /** Value of the first node. */
  readonly value: ParamValue;
  /** Whether the nodes have different values. */
  readonly mixed: boolean;
}

/**
 * The params that can be edited together: with the same name, type, unit and choices in all nodes. Params with wires, expressions or
 * keyframes in one of the nodes are left out.
 */
export function sharedParams({ nodes: all, wires }: Graph, library: OpenGraph['library'], nodes: readonly string[]): SharedParam[] {
  const found = nodes.map((id) => ({ id, node: all[id], definition: library.definition(all[id]?.type ?? '') }));
  const [first, ...others] = found;
  if (!first?.definition || others.length === 0) return [];
  const wired = new Set(wires.map(({ to }) => `${to.node} ${to.port}`));
  return Object.entries(first.definition.params).flatMap(([name, param]) => {
    const values: ParamValue[] = [];
    for (const { id, node, definition } of found) {
      const own = definition && getOwn(definition.params, name);
      const binding = getOwn(node?.params ?? {}, name);
      const isPlain = (binding === undefined || 'value' in binding || 'port' in binding) && !wired.has(`${id} ${name}`);
      if (!own || !isPlain || !isSameKind(own, param)) return [];
      values.push(boundValue(own, binding));
    }
    const [value] = values;
    if (value === undefined) return [];
    const mixed = values.some((other) => JSON.stringify(other) !== JSON.stringify(value));
    return [{ name, param, value, mixed }];
  });
}

/**
 * Sets a param of several nodes. Of a vector, only the parts that differ from those of the first node: the others stay in each node.
 * Successive edits form one undo step until `endGesture`.
 */
export function editShared(
  editor: Editor,
  nodes: readonly string[],
  { name, param }: Pick<SharedParam, 'name' | 'param'>,
  value: ParamValue,
): boolean {
  const state = editor.document.getState();
  const { project, library, graph } = state;
  const valueIn = (node: string) => {
    const { type, params } = nodeOf(state, node) ?? {};
    const own = getOwn(library.definition(type ?? '')?.params ?? {}, name) ?? param;
    return boundValue(own, getOwn(params ?? {}, name));
  };
  const first = valueIn(nodes[0] ?? '');
  const steps = nodes.map((node) => (before: Project) => {
    const edited = param.type.startsWith('vector') ? withChangedParts(valueIn(node), first, value) : value;
    return setParam(before, { library, graph, node, param: name, value: edited });
  });
  return apply(
    editor,
    `Change ${param.label} of ${nodes.length} nodes`,
    sequence(project, ...steps),
    `param ${graph} ${nodes.join()} ${name}`,
  );
}

function withChangedParts(own: ParamValue, first: ParamValue, value: ParamValue): ParamValue {
  if (!Array.isArray(own) || !Array.isArray(first) || !Array.isArray(value)) return value;
  return value.map((part, i) => (part === first[i] ? (own[i] ?? part) : part)) as ParamValue;
}

function isSameKind(a: ParamDefinition, b: ParamDefinition): boolean {
  const unit = (param: ParamDefinition) => ('unit' in param ? param.unit : undefined);
  if (a.type !== b.type || unit(a) !== unit(b)) return false;
  if (a.type === 'choice' && b.type === 'choice') return JSON.stringify(a.options) === JSON.stringify(b.options);
  if (a.type === 'asset' && b.type === 'asset') return a.accept === b.accept;
  return true;
}
