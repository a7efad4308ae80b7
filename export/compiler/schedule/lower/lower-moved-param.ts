import { type ParamDefinition, paramWireType } from '../../../../nodes/kit/definition.ts';
import { overshoots } from '../../../../nodes/kit/ease.ts';
import { parseBinding } from '../../../graph/expression/param-expression.ts';
import { clampToRange } from '../../../graph/library/param-value.ts';
import type { Track } from '../../../graph/project.ts';
import type { NodeOperation } from '../../../program/program.ts';
import type { MovedParam } from '../slot-allocator.ts';
import { addStep, type Lowering } from './lowering.ts';

/**
 * Lowers the expression or track of a param to a value operation that writes the param's slot before the node reads it. Its type is
 * `binding/expression` or `binding/track`, whose runtimes are bundled only if they are used.
 */
export function lowerMovedParam(lowering: Lowering, { node, name, definition, binding, slot }: MovedParam): void {
  const kind = 'track' in binding ? 'track' : 'expression';
  const id = `${node.id}.${name}.${kind}`;
  addStep(lowering, {
    id,
    node: node.id,
    kind: 'value',
    view: 'once',
    type: `binding/${kind}`,
    reads: [],
    writes: [],
    inputs: {},
    multiple: [],
    outputs: { value: { kind: 'slot', slot } },
    params: {},
    config: 'track' in binding ? trackConfig(definition, binding.track) : expressionConfig(definition, binding.expression),
    assets: {},
  });
  const known = lowering.movedBy.get(node.id);
  if (known) known.push(id);
  else lowering.movedBy.set(node.id, [id]);
}

function expressionConfig(definition: ParamDefinition, expression: string): NodeOperation['config'] {
  const parsed = parseBinding(definition, expression);
  if (!parsed.ok) throw new Error(`An expression has not been checked: ${parsed.message}.`);
  const postfix = parsed.parts.map((part, i) => withinLimits(definition, part, i)).join(' ');
  return { postfix, otherwise: numbersIn(definition, definition.default) };
}

/** Clamps a computed value to the param's limits, as a typed value is. */
function withinLimits(definition: ParamDefinition, postfix: string, part: number): string {
  if (paramWireType(definition) === 'toggle') return `${postfix} 0 !=`;
  const [low, high] = limitsOf(definition, part);
  return `${postfix}${low === undefined ? '' : ` ${low} max`}${high === undefined ? '' : ` ${high} min`}`;
}

function limitsOf(definition: ParamDefinition, part: number): readonly [low: number | undefined, high: number | undefined] {
  switch (definition.type) {
    case 'number':
      return [definition.min, definition.max];
    case 'vector2':
    case 'vector3':
    case 'vector4':
      return [definition.min?.[part], definition.max?.[part]];
    case 'color':
      return [0, 1];
    case 'toggle':
    case 'text':
    case 'choice':
    case 'curve':
    case 'gradient':
    case 'asset':
      return [undefined, undefined];
  }
}

function trackConfig(definition: ParamDefinition, { keys, repeat }: Track): NodeOperation['config'] {
  return {
    times: keys.map(({ timeS }) => timeS),
    values: keys.flatMap(({ value }) => numbersIn(definition, value)),
    easings: keys.map(({ easing }) => easing).join(' '),
    // Other tracks never exceed the values of their keys.
    ...(keys.some(({ easing }) => overshoots(easing)) ? { limits: limitsOfTrack(definition, keys[0]?.value) } : {}),
    repeat,
  };
}

/** Lowest and highest value of each number; ±`Number.MAX_VALUE` for no limit. */
function limitsOfTrack(definition: ParamDefinition, value: Track['keys'][number]['value'] = 0): readonly number[] {
  return numbersIn(definition, value).flatMap((_, i) => {
    const [low = -Number.MAX_VALUE, high = Number.MAX_VALUE] = limitsOf(definition, i);
    return [low, high];
  });
}

function numbersIn(definition: ParamDefinition, value: ParamDefinition['default'] | Track['keys'][number]['value']): readonly number[] {
  const clamped = clampToRange(definition, value);
  return typeof clamped === 'object' ? clamped : [Number(clamped)];
}
