import { castDraft } from 'immer';
import type { NodeLibrary, ParamDefinition, ParamValue } from '../../../nodes/kit/definition.ts';
import { bindingMisfit } from '../library/binding-misfit.ts';
import { createInterfaceLookup } from '../library/node-interface.ts';
import { boundValue, outOfRange, sameValue, withoutNegativeZero } from '../library/param-value.ts';
import type { Binding, Project } from '../project.ts';
import { getOwn } from '../record.ts';
import { type Change, change, draftGraph, graphOf, type Place, refuse, setWires, unchanged } from './change.ts';

export interface SetParam {
  readonly library: NodeLibrary;
  readonly graph: string;
  readonly node: string;
  readonly param: string;
  readonly value: ParamValue;
}

/**
 * Sets the value of a param. If the param is a port, this is its value while it is not connected. The default value is not stored.
 *
 * @returns The change, or a refusal: SCR012, SCR010 or SCR018 for an unknown node, type or param; SCR018 for an invalid value; SCR019 if
 * the param follows an expression or a track; SCR030 or SCR033 for an asset that is missing or of another kind.
 * @throws Error if the graph does not exist.
 *
 * @example
 * setParam(project, { library, graph: 'main', node: 'sepia-k7q2', param: 'amount', value: 0.5 });
 */
export function setParam(project: Project, { library, graph, node, param, value }: SetParam): Change {
  const found = findParam(project, library, graph, node, param);
  if ('diagnostics' in found) return found;
  const { binding } = found;
  if (binding && boundValue(binding) === undefined) {
    const what = 'track' in binding ? 'a keyframe track' : 'an expression';
    return refuse(project, 'SCR019', `“${found.definition.label}” of ${node} follows ${what}. Bind it to a value first.`, found.place);
  }
  const next: Binding = binding && 'port' in binding ? { port: value } : { value };
  return bind(project, found, { graph, node, param, binding: next, keepWires: true });
}

export interface BindParam {
  readonly library: NodeLibrary;
  readonly graph: string;
  readonly node: string;
  readonly param: string;
  readonly binding: Binding;
}

/**
 * Binds a param to a value, a port, an expression or a track. Its wire is removed unless the new binding is a port.
 *
 * @returns The change, or a refusal as of `setParam`; SCR019 for a binding that the param does not support.
 * @throws Error if the graph does not exist.
 *
 * @example
 * bindParam(project, { library, graph: 'main', node: 'sepia-k7q2', param: 'amount', binding: { expression: 'sin(time)' } });
 */
export function bindParam(project: Project, { library, graph, node, param, binding }: BindParam): Change {
  const found = findParam(project, library, graph, node, param);
  return 'diagnostics' in found ? found : bind(project, found, { graph, node, param, binding, keepWires: 'port' in binding });
}

interface FoundParam {
  readonly definition: ParamDefinition;
  readonly binding: Binding | undefined;
  readonly place: Place;
}

function findParam(project: Project, library: NodeLibrary, graph: string, id: string, name: string): FoundParam | Change {
  const place = { nodeId: id, port: name };
  const node = getOwn(graphOf(project, graph).nodes, id);
  if (!node) return refuse(project, 'SCR012', `Node ${id} does not exist.`, place);
  const nodeInterface = createInterfaceLookup(project, library)(node.type);
  if (!nodeInterface) return refuse(project, 'SCR010', `${id} has the unknown type ${node.type}.`, place);
  const definition = getOwn(nodeInterface.params, name);
  if (!definition) return refuse(project, 'SCR018', `${id} (${nodeInterface.title}) has no parameter “${name}”.`, place);
  return { definition, binding: getOwn(node.params, name), place };
}

type Bind = Omit<BindParam, 'library'> & { readonly keepWires: boolean };

function bind(
  project: Project,
  { definition, binding: before, place }: FoundParam,
  { graph, node, param, binding, keepWires }: Bind,
): Change {
  const problem = bindingProblem(project, definition, binding);
  if (problem !== null) return refuse(project, problem.code, `“${definition.label}” of ${node} ${problem.message}`, place);
  const stored = withoutDefault(definition, binding);
  const { wires } = graphOf(project, graph);
  const others = keepWires ? wires : wires.filter(({ to }) => to.node !== node || to.port !== param);
  if (others.length === wires.length && sameBinding(stored, before ?? null)) return unchanged(project);
  return change(project, (draft) => {
    const params = draftGraph(draft, graph).nodes[node]?.params;
    if (!params) return;
    if (stored === null) delete params[param];
    else params[param] = castDraft(stored);
    if (others.length < wires.length) setWires(draft, graph, others);
  });
}

function bindingProblem(
  project: Project,
  param: ParamDefinition,
  binding: Binding,
): { code: 'SCR018' | 'SCR019' | 'SCR030' | 'SCR033'; message: string } | null {
  const wrong = bindingMisfit(param, binding);
  if (wrong !== null) return wrong;
  const value = boundValue(binding);
  if (value === undefined) return null;
  const range = outOfRange(param, value);
  if (range !== null) return { code: 'SCR018', message: `must be ${range}.` };
  if (param.type !== 'asset' || value === '') return null;
  const asset = getOwn(project.assets, String(value));
  if (!asset) return { code: 'SCR030', message: `cannot be ${String(value)}: the project has no such asset.` };
  if (asset.kind === param.accept) return null;
  return { code: 'SCR033', message: `takes a file of kind “${param.accept}”, but this file is of kind “${asset.kind}”.` };
}

/** The binding to store. Defaults are not stored, except at ports, because the entry marks the param as a port. */
function withoutDefault(param: ParamDefinition, binding: Binding): Binding | null {
  if ('port' in binding) return { port: withoutNegativeZero(binding.port) };
  if (!('value' in binding)) return binding;
  return sameValue(binding.value, param.default) ? null : { value: withoutNegativeZero(binding.value) };
}

function sameBinding(a: Binding | null, b: Binding | null): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}
