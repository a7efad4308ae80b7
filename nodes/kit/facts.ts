import { type Curve, DIAGONAL } from './curve.ts';
import {
  type InputPort,
  type Need,
  type NodeDefinition,
  type OutputPort,
  type ParamDefinition,
  paramWireType,
  type Unit,
} from './definition.ts';
import { type Gradient, STOP_NUMBERS } from './gradient.ts';
import { WIRE_TYPES } from './wire-types.ts';

/**
 * The facts of an input in a few words each, as the help panel and `docs/nodes.md` show them.
 *
 * @example
 * inputFacts({ type: 'layer', label: 'Layer', doc: '', required: true }); // ['layer', 'required']
 */
export function inputFacts(port: InputPort): readonly string[] {
  const several = port.multiple ? ['several wires'] : [];
  return [WIRE_TYPES[port.type].label.toLowerCase(), port.required ? 'required' : 'optional', ...several];
}

/**
 * The facts of an output in a few words each.
 *
 * @example
 * outputFacts({ type: 'layer', label: 'Layer', doc: '', domain: 'view', depth: true }); // ['layer', 'with depth']
 */
export function outputFacts({ type, depth }: OutputPort): readonly string[] {
  const words = depth === true ? ['with depth'] : depth === 'same' ? ['depth of the first input'] : [];
  return [WIRE_TYPES[type].label.toLowerCase(), ...(type === 'layer' ? words : [])];
}

/**
 * Whether a wire can be connected to a param.
 *
 * @example
 * canBeWired(definition.params.radiusPx); // true for a uniform number
 */
export function canBeWired(param: ParamDefinition): boolean {
  return paramWireType(param) !== undefined;
}

/**
 * The type, default and range of a param, in the units of the inspector.
 *
 * @example
 * paramFacts({ type: 'number', stage: 'uniform', label: '', doc: '', default: 1, min: 0, max: 5, unit: 'm' });
 * // ['number', 'default 1 m', '0 to 5 m']
 */
export function paramFacts(param: ParamDefinition): readonly string[] {
  switch (param.type) {
    case 'number':
      return ['number', `default ${quantity(param.default, param.unit)}`, ...range(param.min, param.max, param.unit)];
    case 'vector2':
    case 'vector3':
    case 'vector4':
      return [WIRE_TYPES[param.type].label.toLowerCase(), `default (${param.default.map((n) => quantity(n, param.unit)).join(', ')})`];
    case 'color':
      return ['color', `default ${hex(param.default)}`];
    case 'toggle':
      return ['toggle', `default ${param.default ? 'on' : 'off'}`];
    case 'text':
      return ['text', param.default === '' ? 'empty by default' : `default "${param.default}"`];
    case 'choice':
      return [
        // Users choose the label; project files contain the value.
        `one of ${param.options.map((option) => `"${option.label}" = ${JSON.stringify(option.value)}`).join(', ')}`,
        `default "${param.options.find((option) => option.value === param.default)?.label ?? param.default}"`,
      ];
    case 'curve':
      return ['curve', param.default.join() === DIAGONAL.join() ? 'default a diagonal line' : `default through ${points(param.default)}`];
    case 'gradient':
      return ['gradient', `default ${stops(param.default)}`];
    case 'asset':
      return [`${param.accept} file`];
  }
}

/**
 * Facts about a need in a few words each: whether it is required or optional, and under which conditions.
 *
 * @param definition The definition that contains the need.
 *
 * @example
 * needFacts(definition, { capability: 'planes', required: false, when: 'always', why: '', without: '' }); // ['optional']
 */
export function needFacts(definition: NodeDefinition, { required, when, where }: Need): readonly string[] {
  return [
    required === 'alone' ? 'required if nothing else is shown' : required ? 'required' : 'optional',
    ...(when === 'sampled' ? ['only if a node reads the image'] : []),
    ...(where ? [`only with ${choiceWords(definition, where)}`] : []),
  ];
}

function choiceWords({ params }: NodeDefinition, { param: name, is }: NonNullable<Need['where']>): string {
  const param = params[name];
  if (typeof is === 'boolean') return `“${param?.label ?? name}” ${is ? 'on' : 'off'}`;
  const option = param?.type === 'choice' ? param.options.find(({ value }) => value === is) : undefined;
  return `“${param?.label ?? name}” at “${option?.label ?? String(is)}”`;
}

function range(min: number | undefined, max: number | undefined, unit: Unit | undefined): string[] {
  if (min !== undefined && max !== undefined) return [`${quantity(min, undefined, unit)} to ${quantity(max, unit)}`];
  if (min !== undefined) return [`from ${quantity(min, unit)}`];
  return max === undefined ? [] : [`to ${quantity(max, unit)}`];
}

const SUFFIX: Readonly<Record<Unit, string>> = {
  m: ' m',
  s: ' s',
  rad: '°',
  px: ' px',
  K: ' K',
  Hz: ' Hz',
  cd: ' cd',
  ratio: '',
  none: '',
};

/**
 * Formats a value as the inspector shows it, with its unit. With `unit` undefined and `scaledBy` given, the value is converted but has no
 * unit, for the start of a range.
 */
function quantity(value: number, unit: Unit | undefined, scaledBy: Unit | undefined = unit): string {
  const shown = scaledBy === 'rad' ? (value * 180) / Math.PI : value;
  return `${Number(shown.toPrecision(6))}${unit === undefined ? '' : SUFFIX[unit]}`;
}

function points(curve: Curve): string {
  return Array.from({ length: curve.length / 2 }, (_, i) => `(${curve[2 * i]}, ${curve[2 * i + 1]})`).join(' ');
}

function stops(gradient: Gradient): string {
  return Array.from({ length: gradient.length / STOP_NUMBERS }, (_, i) => {
    const at = STOP_NUMBERS * i;
    return `${hex(gradient.slice(at + 1, at + 5))} at ${gradient[at]}`;
  }).join(', ');
}

function hex(color: readonly number[]): string {
  const bytes = color.map((c) =>
    Math.round(c * 255)
      .toString(16)
      .padStart(2, '0'),
  );
  return `#${(bytes[3] === 'ff' ? bytes.slice(0, 3) : bytes).join('')}`;
}
