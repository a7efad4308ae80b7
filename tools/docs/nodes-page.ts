import { categoryLabel } from '../../nodes/kit/categories.ts';
import type { InputPort, NodeDefinition, OutputPort, ParamDefinition } from '../../nodes/kit/definition.ts';
import { canBeWired, inputFacts, needFacts, outputFacts, paramFacts } from '../../nodes/kit/facts.ts';

/** Text of `docs/nodes.md`: the reference of all node types, from their definitions. */
export function nodesPage(definitions: readonly NodeDefinition[]): string {
  const sorted = [...definitions].sort((a, b) => compare(a.type, b.type));
  const categories = [...new Set(sorted.map(({ type }) => categoryLabel(type)))];
  const contents = categories.map((category) => {
    const links = sorted.filter(({ type }) => categoryLabel(type) === category).map((d) => `[${d.title}](#${anchor(d)})`);
    return `- **${category}**: ${links.join(', ')}\n`;
  });
  return `# Nodes

<!-- Made by \`npm run docs\` from the node definitions and the headers of the ISF files; change those instead. -->

The node types that a graph can contain. Lengths are in meters and times in seconds; angles are shown in degrees, as in the inspector. A parameter marked _can be connected_ has a port, and its value can change while the project plays.

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
    lines.length > 0 ? `\nInputs and parameters:\n\n${lines.join('')}` : '',
    Object.keys(definition.outputs).length > 0
      ? `\nOutputs:\n\n${Object.entries(definition.outputs)
          .map(([name, port]) => outputLine(name, port))
          .join('')}`
      : '',
    needs(definition),
    definition.credit === undefined ? '' : `\nBy ${definition.credit}\n`,
  ].join('');
}

function inputLine(name: string, port: InputPort): string {
  return item(port.label, name, inputFacts(port), port.doc);
}

function outputLine(name: string, port: OutputPort): string {
  return item(port.label, name, outputFacts(port), port.doc);
}

function paramLine(name: string, param: ParamDefinition): string {
  return item(param.label, name, [...paramFacts(param), ...(canBeWired(param) ? ['_can be connected_'] : [])], param.doc);
}

function needs(definition: NodeDefinition): string {
  const lines = (definition.needs ?? []).map(
    (need) =>
      `- **${need.capability.replaceAll('-', ' ')}** (${needFacts(definition, need).join(', ')}): ${need.why}. Without it: ${need.without}\n`,
  );
  return lines.length === 0 ? '' : `\nDevice features:\n\n${lines.join('')}`;
}

function item(label: string, name: string, facts: readonly string[], doc: string): string {
  return `- **${label}** \`${name}\` (${facts.join(', ')}): ${doc}\n`;
}

function heading({ title, type }: NodeDefinition): string {
  return `${title} \`${type}\``;
}

/** Anchor of a heading, as GitHub derives it from the text of the heading. */
function anchor(definition: NodeDefinition): string {
  return heading(definition)
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\- ]/gu, '')
    .replaceAll(' ', '-');
}

function compare(a: string, b: string): number {
  return a < b ? -1 : Number(a > b);
}
