import {
  type InputPort,
  type Need,
  type NodeDefinition,
  type OutputPort,
  type ParamDefinition,
  paramWireType,
  type Unit,
} from '../../nodes/kit/definition.ts';
import { WIRE_TYPES } from '../../nodes/kit/wire-types.ts';

/** `docs/nodes.md`: the reference of all node types, from their definitions. */
export function nodesPage(definitions: readonly NodeDefinition[]): string {
  const sorted = [...definitions].sort((a, b) => compare(a.type, b.type));
  const categories = [...new Set(sorted.map(categoryOf))];
  const contents = categories.map((category) => {
    const links = sorted.filter((d) => categoryOf(d) === category).map((d) => `[${d.title}](#${anchor(d)})`);
    return `- **${category}**: ${links.join(', ')}\n`;
  });
  return `# Nodes

<!-- Made by \`npm run docs\` from the node definitions and the headers of the ISF files; change those instead. -->

Everything that can be placed in a graph. Lengths are in metres, times in seconds; angles are shown in degrees, as in the inspector. A param marked _can be wired_ has a port, and changes while the picture runs.

${contents.join('')}
${sorted.map(nodeSection).join('\n')}`;
}

function nodeSection(definition: NodeDefinition): string {
  const lines = [
    ...Object.entries(definition.inputs).map(([name, port]) => inputLine(name, port)),
    ...Object.entries(definition.params).map(([name, param]) => paramLine(name, param)),
  ];
  return [
    `## ${heading(definition)}\n\n${definition.doc}\n`,
    lines.length > 0 ? `\nIn:\n\n${lines.join('')}` : '',
    Object.keys(definition.outputs).length > 0
      ? `\nOut:\n\n${Object.entries(definition.outputs)
          .map(([name, port]) => outputLine(name, port))
          .join('')}`
      : '',
    needs(definition),
    definition.credit === undefined ? '' : `\nBy ${definition.credit}\n`,
  ].join('');
}

function inputLine(name: string, port: InputPort): string {
  const facts = [
    WIRE_TYPES[port.type].label.toLowerCase(),
    port.required ? 'required' : 'optional',
    ...(port.multiple ? ['takes several'] : []),
  ];
  return item(port.label, name, facts, port.doc);
}

function outputLine(name: string, port: OutputPort): string {
  const depth = port.depth === true ? ['with depth'] : port.depth === 'same' ? ['depth as the first input'] : [];
  return item(port.label, name, [WIRE_TYPES[port.type].label.toLowerCase(), ...(port.type === 'layer' ? depth : [])], port.doc);
}

function paramLine(name: string, param: ParamDefinition): string {
  const wired = paramWireType(param) === undefined ? [] : ['_can be wired_'];
  return item(param.label, name, [...paramFacts(param), ...wired], param.doc);
}

function paramFacts(param: ParamDefinition): string[] {
  switch (param.type) {
    case 'number':
      return ['number', `default ${quantity(param.default, param.unit)}`, ...range(param.min, param.max, param.unit)];
    case 'vector2':
    case 'vector3':
    case 'vector4':
      return [WIRE_TYPES[param.type].label.toLowerCase(), `default (${param.default.map((n) => quantity(n, param.unit)).join(', ')})`];
    case 'color':
      return ['colour', `default ${hex(param.default)}`];
    case 'toggle':
      return ['toggle', `default ${param.default ? 'on' : 'off'}`];
    case 'text':
      return ['text', param.default === '' ? 'empty by default' : `default "${param.default}"`];
    case 'choice':
      return [
        `one of ${param.options.map((option) => `"${option.label}"`).join(', ')}`,
        `default "${param.options.find((option) => option.value === param.default)?.label ?? param.default}"`,
      ];
    case 'asset':
      return [`${param.accept} file`];
  }
}

function needs(definition: NodeDefinition): string {
  const lines = (definition.needs ?? []).map(
    ({ capability, required, when, where, why, without }) =>
      `- **${capability.replaceAll('-', ' ')}** (${required ? 'required' : 'optional'}${when === 'sampled' ? ', only when the picture is read by a node' : ''}${where ? `, only with ${choiceWords(definition, where)}` : ''}): ${why}. Without it: ${without}\n`,
  );
  return lines.length === 0 ? '' : `\nNeeds:\n\n${lines.join('')}`;
}

function choiceWords({ params }: NodeDefinition, { param: name, is }: NonNullable<Need['where']>): string {
  const param = params[name];
  if (typeof is === 'boolean') return `“${param?.label ?? name}” ${is ? 'on' : 'off'}`;
  const option = param?.type === 'choice' ? param.options.find(({ value }) => value === is) : undefined;
  return `“${param?.label ?? name}” at “${option?.label ?? String(is)}”`;
}

function item(label: string, name: string, facts: readonly string[], doc: string): string {
  return `- **${label}** \`${name}\` (${facts.join(', ')}): ${doc}\n`;
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

/** `scaledBy` converts without naming the unit, for the first end of a range. */
function quantity(value: number, unit: Unit | undefined, scaledBy: Unit | undefined = unit): string {
  const shown = scaledBy === 'rad' ? (value * 180) / Math.PI : value;
  return `${Number(shown.toPrecision(6))}${unit === undefined ? '' : SUFFIX[unit]}`;
}

function hex(color: readonly number[]): string {
  const bytes = color.map((c) =>
    Math.round(c * 255)
      .toString(16)
      .padStart(2, '0'),
  );
  return `#${(bytes[3] === 'ff' ? bytes.slice(0, 3) : bytes).join('')}`;
}

function heading({ title, type }: NodeDefinition): string {
  return `${title} \`${type}\``;
}

/** As GitHub makes it from the heading. */
function anchor(definition: NodeDefinition): string {
  return heading(definition)
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\- ]/gu, '')
    .replaceAll(' ', '-');
}

function categoryOf({ type }: NodeDefinition): string {
  return type.slice(0, type.indexOf('/'));
}

function compare(a: string, b: string): number {
  return a < b ? -1 : Number(a > b);
}
