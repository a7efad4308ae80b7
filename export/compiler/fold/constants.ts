import { type Triple, writeAdjustedColor, writeHsvColor, writeMixedColor } from '../../../nodes/kit/color-math.ts';
import { type ParamDefinition, type ParamValue, paramWireType } from '../../../nodes/kit/definition.ts';
import type { ColorFunction } from '../../../nodes/kit/expression.ts';
import { playExpression } from '../../../nodes/kit/play-expression.ts';
import { isValueType, VALUE_SIZES, type ValueType } from '../../../nodes/kit/wire-types.ts';
import { parseExpression } from '../../graph/expression/expression-parser.ts';
import { parseBinding, parseValue } from '../../graph/expression/param-expression.ts';
import { clampToRange, sameValue } from '../../graph/library/param-value.ts';
import type { Binding } from '../../graph/project.ts';
import type { FlatNode } from '../flat-graph.ts';
import { startValue } from '../schedule/slot-allocator.ts';

/** Words of the postfix notation that read the clock. */
const CLOCK = /(?:^| )(?:time|frame)(?: |$)/;

/** A component of a vector or color in a formula. */
const COMPONENT = /\b([A-Za-z]\w*)\.([rgba]|[xyzw])\b/g;

const COLOR_FUNCTIONS = { writeHsvColor, writeAdjustedColor, writeMixedColor } satisfies Record<ColorFunction, unknown>;

/** The value of a param while no wire, track or expression with a clock changes it; undefined if one does. */
export function constantParam(node: FlatNode, name: string, param: ParamDefinition): ParamValue | undefined {
  if (node.inputs.has(name)) return undefined;
  const binding = node.bindings.get(name);
  if (binding && 'track' in binding) return undefined;
  return binding && 'expression' in binding ? constantExpression(param, binding.expression) : startValue(node, name, param);
}

/** The constants at the outputs of a value node, by port; none if the node is not constant. */
export function constantsOf(node: FlatNode): readonly (readonly [port: string, value: ParamValue])[] {
  const { computes, params, outputs } = node.definition;
  if (computes === undefined) return [];
  const values = new Map<string, ParamValue>();
  for (const [name, param] of Object.entries(params)) {
    const value = constantParam(node, name, param);
    if (value === undefined) return [];
    values.set(name, value);
  }
  return Object.entries(computes).flatMap(([port, formula]) => {
    const type = outputs[port]?.type;
    if (type === undefined || !isValueType(type)) return [];
    if (typeof formula !== 'string' && 'call' in formula) {
      const args = formula.params.map((name) => values.get(name));
      return [[port, callColorFunction(formula.call, args)] as const];
    }
    const text = typeof formula === 'string' ? formula : formula.of[String(values.get(formula.by))];
    const value = text === undefined ? undefined : compute(node, text, values, type);
    return value === undefined ? [] : [[port, value] as const];
  });
}

function callColorFunction(name: ColorFunction, args: readonly unknown[]): ParamValue {
  const result = [0, 0, 0, 0];
  // Definitions name params of the types that the function takes; a test calls each of them.
  (COLOR_FUNCTIONS[name] as (out: Triple, ...args: readonly unknown[]) => void)(result, ...args);
  return result;
}

function compute(node: FlatNode, formula: string, values: ReadonlyMap<string, ParamValue>, type: ValueType): ParamValue | undefined {
  const repeated = values.get(formula);
  const param = node.definition.params[formula];
  if (repeated !== undefined && param !== undefined && paramWireType(param) !== undefined) return repeated;
  const numbers = namedNumbers(values);
  // An Expression node: the formula is the value of a param.
  const own = param && repeated !== undefined ? parseValue(param, repeated) : null;
  const parsed = own ?? parseExpression(formula.replaceAll(COMPONENT, '$1_$2'), VALUE_SIZES[type], Object.keys(numbers));
  if (!parsed.ok || parsed.parts.some((part) => CLOCK.test(part))) return undefined;
  const results = evaluate(parsed.parts, numbers);
  if (results.length > 1) return results;
  const [result = 0] = results;
  if (type === 'toggle') return result !== 0;
  return Number.isFinite(result) ? result : 0;
}

/** The numbers and toggles by their names, and the components of vectors and colors, such as `position_x` or `tint_r`. */
function namedNumbers(values: ReadonlyMap<string, ParamValue>): Record<string, { readonly value: number }> {
  const numbers: Record<string, { readonly value: number }> = {};
  for (const [name, value] of values) {
    if (typeof value !== 'object') numbers[name] = { value: Number(value) };
    else {
      value.forEach((component, i) => {
        for (const letters of ['xyzw', 'rgba']) numbers[`${name}_${letters[i]}`] = { value: component };
      });
    }
  }
  return numbers;
}

function evaluate(parts: readonly string[], numbers: Readonly<Record<string, { readonly value: number }>>): number[] {
  const played = playExpression(parts.join(' '), numbers);
  played.update({ timeS: 0, frame: 0 });
  return [...played.results];
}

/** The value of an expression without a clock, within the limits of its param; undefined if it has a clock. */
function constantExpression(param: ParamDefinition, expression: string): ParamValue | undefined {
  const parsed = parseBinding(param, expression);
  if (!parsed.ok || parsed.parts.some((part) => CLOCK.test(part))) return undefined;
  const results = evaluate(parsed.parts, {});
  if (!results.every(Number.isFinite)) return param.default;
  const [only = 0] = results;
  const value = paramWireType(param) === 'toggle' ? only !== 0 : results.length > 1 ? results : only;
  return clampToRange(param, value);
}

/**
 * The binding that gives a param a constant in place of a wire; null if the param would not keep the value, because wires may exceed its
 * limits and choices.
 */
export function bindingFor(param: ParamDefinition, value: ParamValue): Binding | null {
  const type = paramWireType(param);
  if (type === undefined || type === 'text') return null;
  const size = typeof value === 'object' ? value.length : 1;
  if (size !== VALUE_SIZES[type]) return null;
  const own = type === 'toggle' ? Number(value) !== 0 : typeof value === 'object' ? value : Number(value);
  if (param.type === 'choice' && !param.options.some((option) => option.value === own)) return null;
  return sameValue(clampToRange(param, own), own) ? { value: own } : null;
}
