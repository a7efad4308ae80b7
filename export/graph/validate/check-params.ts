import type { AssetParam, ParamDefinition } from '../../../nodes/kit/definition.ts';
import { parseBinding, parseValue } from '../expression/param-expression.ts';
import { bindingMisfit } from '../library/binding-misfit.ts';
import { boundValue, outOfRange } from '../library/param-value.ts';
import { replacedParams } from '../library/replaced-params.ts';
import type { Binding } from '../project.ts';
import { getOwn } from '../record.ts';
import { type GraphCheck, inGraph, reportError } from './context.ts';

export function checkParams(check: GraphCheck): void {
  for (const [nodeId, node] of Object.entries(check.graph.nodes)) {
    const nodeInterface = check.interfaceOf(node.type);
    // Params of another version cannot be checked; the version itself is reported at the node.
    if (!nodeInterface || node.version !== nodeInterface.version) continue;
    for (const [port, binding] of Object.entries(node.params)) {
      const param = getOwn(nodeInterface.params, port);
      if (param) checkBinding(check, nodeId, port, param, binding);
      else reportError(check, 'SCR018', { nodeId, port }, `${nodeId} (${nodeInterface.title}) has no parameter “${port}”.`, 'Remove it.');
    }
    const replaced = replacedParams(nodeInterface, (port) => isConnected(check, nodeId, port));
    for (const [port, param] of Object.entries(nodeInterface.params)) {
      if (replaced.has(port)) continue;
      if (param.type === 'asset' && isUsed(param, nodeInterface.params, node.params)) checkChosen(check, nodeId, port, param, node.params);
    }
  }
}

/** Whether a wire in the graph leads to an input, or perhaps one from outside the subgraph. */
function isConnected({ graph }: GraphCheck, node: string, port: string): boolean {
  return (
    graph.wires.some(({ to }) => to.node === node && to.port === port) ||
    graph.exposed.inputs.some((exposed) => exposed.node === node && exposed.port === port)
  );
}

function checkBinding(check: GraphCheck, nodeId: string, port: string, param: ParamDefinition, binding: Binding): void {
  const place = { nodeId, port };
  const wrong = bindingMisfit(param, binding);
  if (wrong !== null) {
    reportError(check, wrong.code, place, `“${param.label}” of ${nodeId} ${wrong.message}`);
    return;
  }
  const value = boundValue(binding);
  const expression = 'expression' in binding ? parseBinding(param, binding.expression) : parseValue(param, value);
  if (expression?.ok === false) {
    const { message, column } = expression;
    const severity = check.live.has(nodeId) ? 'error' : 'warning';
    const words = `The expression of “${param.label}” of ${nodeId} cannot be read: ${message} (character ${column}).`;
    check.report({ code: 'SCR022', severity, ...place, column, message: inGraph(check, words) });
  }
  if (value === undefined) return;
  if (param.type === 'asset') checkAsset(check, nodeId, port, param, String(value));
  const range = outOfRange(param, value);
  if (range === null) return;
  const message = `“${param.label}” of ${nodeId} is ${JSON.stringify(value)} but must be ${range}. The nearest value is used.`;
  check.report({ code: 'SCR018', severity: 'warning', ...place, message: inGraph(check, message) });
}

function checkAsset(check: GraphCheck, nodeId: string, port: string, param: ParamDefinition & { type: 'asset' }, id: string): void {
  if (id === '') return;
  const asset = getOwn(check.project.assets, id);
  const place = { nodeId, port };
  if (!asset) {
    reportError(
      check,
      'SCR030',
      place,
      `“${param.label}” of ${nodeId} names the asset ${id}, which is not in the project.`,
      'Choose another file.',
    );
  } else if (asset.kind !== param.accept) {
    const message = `“${param.label}” of ${nodeId} takes a file of kind “${param.accept}”, but ${id} is of kind “${asset.kind}”.`;
    reportError(check, 'SCR033', place, message, 'Choose another file.');
  }
}

/** Whether the node uses the file of an asset param: the condition `where` on another param is met. */
function isUsed(
  { where }: AssetParam,
  nodeInterface: Readonly<Record<string, ParamDefinition>>,
  params: Readonly<Record<string, Binding>>,
): boolean {
  if (!where) return true;
  const binding = getOwn(params, where.param);
  return ((binding && boundValue(binding)) ?? getOwn(nodeInterface, where.param)?.default) === where.is;
}

function checkChosen(
  check: GraphCheck,
  nodeId: string,
  port: string,
  param: ParamDefinition,
  params: Readonly<Record<string, Binding>>,
): void {
  const binding = getOwn(params, port);
  if ((binding && boundValue(binding)) || !check.live.has(nodeId)) return;
  const exposed = check.graph.exposed.inputs.some((e) => e.node === nodeId && e.port === port);
  if (exposed) return;
  const message = `“${param.label}” of ${nodeId} is not set, so the node shows nothing.`;
  check.report({ code: 'SCR030', severity: 'warning', nodeId, port, message: inGraph(check, message), fix: 'Choose a file.' });
}
