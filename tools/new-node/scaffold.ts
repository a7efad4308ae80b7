import { saveProject } from '../../export/graph/save.ts';
import type { NodeLibrary } from '../../nodes/kit/definition.ts';
import { DRAW_TEMPLATE } from './draw-template.ts';
import { INPUT_TEMPLATE } from './input-template.ts';
import { LIGHT_TEMPLATE } from './light-template.ts';
import { OBJECTS_TEMPLATE } from './objects-template.ts';
import { PASS_TEMPLATE } from './pass-template.ts';
import { PULSE_TEMPLATE } from './pulse-template.ts';
import { SOURCE_TEMPLATE } from './source-template.ts';
import { surround } from './surround.ts';
import type { Template } from './template.ts';
import { VALUE_TEMPLATE } from './value-template.ts';
import { WORLD_TEMPLATE } from './world-template.ts';

const TEMPLATES = {
  value: VALUE_TEMPLATE,
  pulse: PULSE_TEMPLATE,
  input: INPUT_TEMPLATE,
  source: SOURCE_TEMPLATE,
  world: WORLD_TEMPLATE,
  light: LIGHT_TEMPLATE,
  objects: OBJECTS_TEMPLATE,
  draw: DRAW_TEMPLATE,
  pass: PASS_TEMPLATE,
} as const satisfies Record<string, Template>;

export type TemplateName = keyof typeof TEMPLATES;

/** The names of all templates. */
export const TEMPLATE_NAMES = Object.keys(TEMPLATES) as TemplateName[];

const TYPE = /^[a-z][a-z0-9]*(-[a-z0-9]+)*\/[a-z][a-z0-9]*(-[a-z0-9]+)*$/;

/**
 * Categories that a new node folder cannot have: those of ISF files, techniques and subgraphs, and folders of `nodes/` without node types.
 */
const NO_CATEGORIES = ['filter', 'operator', 'generator', 'technique', 'graph', 'binding', 'part', 'kit', 'generated'];

/**
 * Checks the type of a new node.
 *
 * @param library The node types that exist.
 * @returns Why the type is refused, or null.
 */
export function refuseType(type: string, library: NodeLibrary): string | null {
  const [category = ''] = type.split('/');
  if (!TYPE.test(type)) return `“${type}” is not a node type. Use CATEGORY/NAME in lower-case words, such as layer/fog.`;
  if (['filter', 'operator', 'generator'].includes(category)) {
    return `A ${category} is one ISF file. Create shader-library/${category}s/${type.slice(category.length + 1)}.fs instead.`;
  }
  if (NO_CATEGORIES.includes(category)) return `“${category}” is not a category of node folders. Choose another category.`;
  return library.definition(type) ? `The node type ${type} exists already. Choose another name.` : null;
}

/**
 * The template for a new node.
 *
 * @param type The new type; its category selects the template where none is named.
 * @param named The name of a template, or undefined.
 * @returns The name of a template; null if there is none of the name, or none for the category.
 *
 * @example
 * chooseTemplate('layer/fog', undefined); // 'draw'
 * chooseTemplate('layer/fog', 'pass'); // 'pass'
 */
export function chooseTemplate(type: string, named: string | undefined): TemplateName | null {
  const category = type.slice(0, type.indexOf('/'));
  const name = named ?? (category === 'layer' ? 'draw' : category);
  return TEMPLATE_NAMES.find((known) => known === name) ?? null;
}

/**
 * The files of a new node folder.
 *
 * @param library The node types that the example may use.
 * @returns Path in the repository → text, unformatted.
 */
export function scaffold(type: string, templateName: TemplateName, library: NodeLibrary): Readonly<Record<string, string>> {
  const name = type.slice(type.indexOf('/') + 1);
  const template = TEMPLATES[templateName];
  const definition = template.definition(type, titleOf(name));
  const example = saveProject(surround(withDefinition(library, definition), type, titleOf(name)));
  const files = {
    'definition.ts': `import { defineNode } from '../../kit/definition.ts';\n\nexport const definition = defineNode(${JSON.stringify(definition)});\n`,
    ...template.files(type, name),
    'example/project.scrim.json': example.project,
    'example/project.layout.json': example.layout,
  };
  return Object.fromEntries(Object.entries(files).map(([file, text]) => [`nodes/${type}/${file}`, text]));
}

function withDefinition(library: NodeLibrary, added: ReturnType<Template['definition']>): NodeLibrary {
  return {
    definition: (type) => (type === added.type ? added : library.definition(type)),
    shader: library.shader,
    *types() {
      yield* library.types();
      yield added.type;
    },
  };
}

/** Makes a title from a name: `depth-fog` → `Depth fog`. */
function titleOf(name: string): string {
  const words = name.replaceAll('-', ' ');
  return words.slice(0, 1).toUpperCase() + words.slice(1);
}
